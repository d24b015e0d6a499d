package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.passFrames;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javafx.scene.image.WritableImage;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import tellosimulator.scenario.Gallery;
import tellosimulator.testing.CompressedImage;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.testing.NeedsDisplay;

/**
 * Opens all scenarios of the program in the window, in the light and the dark theme. With {@code
 * -Dupdate.docs=true} it writes the sheet of all pictures:
 *
 * <pre>{@code mvn -Pbench test -Dtest=ContactSheetDisplayTest -Dupdate.docs=true}</pre>
 */
@Tag("bench")
@NeedsDisplay
class ContactSheetDisplayTest {

  private static final Path SHEET = Path.of("docs", "images", "scenarios.jpg");

  /** Default size of the window [px]. */
  private static final int WIDTH = 1280;

  private static final int HEIGHT = 800;

  /** Pictures per row: two scenarios, light and dark. */
  private static final int COLUMNS = 4;

  /** Factor by which each side of a picture is reduced on the sheet, whose width is 1600 px. */
  private static final double SMALLER = 3.2;

  /** Maximum size of the file [bytes]. Decided. */
  private static final int LARGEST = 1_000_000;

  /** Frames after which the camera is at rest and everything is drawn. Decided: a second. */
  private static final int FRAMES = 60;

  @RegisterExtension
  final AppFixture window = new AppFixture(ContactSheetDisplayTest::stage).asAtFirst();

  private static Stage stage() {
    Stage stage = new Stage(StageStyle.UNDECORATED);
    stage.setWidth(WIDTH);
    stage.setHeight(HEIGHT);
    return stage;
  }

  @Test
  void allScenariosAreSeenInBothThemes() throws IOException {
    int width = (int) (WIDTH / SMALLER);
    int height = (int) (HEIGHT / SMALLER);
    int rows = 2 * Gallery.NAMES.size() / COLUMNS;
    BufferedImage sheet =
        new BufferedImage(COLUMNS * width, rows * height, BufferedImage.TYPE_INT_RGB);
    Graphics2D pen = sheet.createGraphics();
    for (int i = 0; i < 2 * Gallery.NAMES.size(); i++) {
      String name = Gallery.NAMES.get(i / 2);
      if (i % 2 == 0) {
        change(() -> window.app().openKnown(name));
      }
      BufferedImage picture = picture();
      assertThat(colors(picture)).as("colors in the middle of %s", name).isGreaterThan(200);
      Image small = picture.getScaledInstance(width, height, Image.SCALE_AREA_AVERAGING);
      pen.drawImage(small, i % COLUMNS * width, i / COLUMNS * height, null);
      Theme other = i % 2 == 0 ? Theme.DARK : Theme.LIGHT;
      change(() -> window.state().themeProperty().set(other));
    }
    pen.dispose();

    byte[] jpeg = CompressedImage.bytes(sheet, "jpeg", 0.88f);
    assertThat(jpeg.length).isLessThan(LARGEST);
    if (Boolean.getBoolean("update.docs")) {
      Files.write(SHEET, jpeg);
    }
  }

  private BufferedImage picture() {
    waitUntil(() -> window.stage().getScene().getWidth() == WIDTH);
    window.robot().moveTo("#scene-3d"); // where the pointer highlights no button
    passFrames(FRAMES);
    WritableImage image = onFxThread(() -> window.stage().getScene().snapshot(null));
    BufferedImage picture = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        picture.setRGB(x, y, image.getPixelReader().getArgb(x, y));
      }
    }
    return picture;
  }

  private static int colors(BufferedImage picture) {
    int[] middle = picture.getRGB(WIDTH / 4, HEIGHT / 4, WIDTH / 2, HEIGHT / 3, null, 0, WIDTH / 2);
    return (int) Arrays.stream(middle).distinct().count();
  }
}
