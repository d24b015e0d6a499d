package tellosimulator.view.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.control.Labeled;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.Slider;
import javafx.scene.image.PixelReader;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.TransferMode;
import javafx.scene.paint.Color;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.api.FxToolkit;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.replay.ReplayWindow.Appearance;
import tellosimulator.view.testing.FxFailures;
import tellosimulator.view.testing.NeedsDisplay;
import tellosimulator.view.testing.QuickRobot;
import tellosimulator.view.text.Language;

/** The player on a screen: a recording from 1 to 15 s, and a ghost that took off 1 s earlier. */
@NeedsDisplay
class ReplayWindowDisplayTest {

  @TempDir private Path folder;
  private final FxRobot robot = new QuickRobot();
  private ReplayWindow window;
  private Stage stage;
  private FxFailures failures;

  @BeforeEach
  void open() throws Exception {
    FxToolkit.registerPrimaryStage();
    failures = new FxFailures();
    ReplayFlight flight = ReplayFlight.read(RecordingFixture.in(folder.resolve("first")));
    Path early = folder.resolve("early");
    new RecordingFixture(early).runWith("\"started\":4.0", "\"started\":3.0").samples(15);
    ReplayFlight ghost = ReplayFlight.read(early);
    onFxThread(
        () -> {
          stage = new Stage(StageStyle.UNDECORATED); // window managers may shrink others
          window =
              new ReplayWindow(
                  stage,
                  flight,
                  new Appearance(
                      new Language(Locale.ENGLISH),
                      new SimpleObjectProperty<>(Theme.LIGHT),
                      DroneOptics.DEFAULT));
          window.compareWith(Optional.of(ghost));
          stage.setOnHidden(hidden -> window.close());
          window.show();
          stage.requestFocus();
          return window;
        });
    waitUntil(() -> stage.isFocused());
  }

  @AfterEach
  void close() {
    onFxThread(
        () -> {
          stage.hide();
          return stage;
        });
    failures.close();
  }

  @Test
  void itPlaysAndScrubsAFlightWithItsGhostAndCloses() {
    robot.press(KeyCode.SPACE).release(KeyCode.SPACE);
    waitUntil(() -> moment().getValue() > 1.5);
    robot.press(KeyCode.SPACE).release(KeyCode.SPACE);

    robot.clickOn("#moment"); // 1 s after the drone moved off, when its ghost stood still
    waitUntil(() -> Math.abs(moment().getValue() - 8) < 0.5);
    robot.press(KeyCode.SHIFT, KeyCode.RIGHT).release(KeyCode.RIGHT, KeyCode.SHIFT);
    waitUntil(() -> text("distance").matches("The ghost is \\d+ cm away"));
    waitUntil(() -> purplePixels() > 50);

    robot.press(KeyCode.CONTROL, KeyCode.Q).release(KeyCode.Q, KeyCode.CONTROL);
    waitUntil(() -> !stage.isShowing());
  }

  @Test
  void aGhostThatIsTakenAwayIsSeenNoMore() {
    robot.press(KeyCode.END).release(KeyCode.END);
    waitUntil(() -> purplePixels() > 50);

    onFxThread(
        () -> {
          MenuButton compare = robot.lookup("#compare").queryAs(MenuButton.class);
          compare.getItems().stream()
              .filter(item -> "compare-none".equals(item.getId()))
              .forEach(MenuItem::fire);
          return compare;
        });

    assertThat(text("ghost-name")).isEmpty();
    waitUntil(() -> purplePixels() < 10); // anti-aliasing produces a pixel or two of that colour
  }

  @Test
  void aFolderThatIsDroppedOntoTheWindowIsTheGhost() {
    Path second = RecordingFixture.in(folder.resolve("second"));
    Stage files = onFxThread(() -> fileManager(second));

    robot.drag("#file").dropTo("#transport");

    waitUntil(() -> text("ghost-name").equals("Ghost: second"));
    onFxThread(
        () -> {
          files.hide();
          return files;
        });
  }

  /** A small window beside the player from which a file can be dragged. */
  private static Stage fileManager(Path file) {
    Label icon = new Label(file.getFileName().toString());
    icon.setId("file");
    icon.setOnDragDetected(
        event -> {
          ClipboardContent content = new ClipboardContent();
          content.putFiles(List.of(file.toFile()));
          icon.startDragAndDrop(TransferMode.COPY).setContent(content);
          event.consume();
        });
    Stage manager = new Stage(StageStyle.UNDECORATED);
    manager.setScene(new Scene(icon, 100, 50));
    manager.setX(0);
    manager.setY(0);
    manager.show();
    return manager;
  }

  private Slider moment() {
    return robot.lookup("#moment").queryAs(Slider.class);
  }

  private String text(String id) {
    return robot.lookup("#" + id).queryAs(Labeled.class).getText();
  }

  /** Returns the number of pixels of the room in the colour of ghosts. */
  private int purplePixels() {
    PixelReader pixels = stage.getScene().snapshot(null).getPixelReader();
    Node scene = robot.lookup("#scene-3d").query();
    Bounds room = scene.localToScene(scene.getLayoutBounds());
    int purple = 0;
    for (int x = (int) room.getMinX(); x < (int) room.getMaxX(); x++) {
      for (int y = (int) room.getMinY(); y < (int) room.getMaxY(); y++) {
        Color color = pixels.getColor(x, y);
        boolean hue = color.getHue() > 265 && color.getHue() < 305;
        purple += hue && color.getSaturation() > 0.3 ? 1 : 0;
      }
    }
    return purple;
  }
}
