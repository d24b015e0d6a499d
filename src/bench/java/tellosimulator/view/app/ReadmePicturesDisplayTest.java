package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.CompressedImage;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.testing.NeedsDisplay;
import tellosimulator.view.testing.QuickRobot;
import tellosimulator.view.world.ViewCamera;
import tellosimulator.world.Room;

/**
 * Takes the pictures of the README and of docs/window.md, and writes them with {@code
 * -Dupdate.docs=true}:
 *
 * <pre>{@code mvn -Pbench test -Dtest=ReadmePicturesDisplayTest -Dupdate.docs=true}</pre>
 */
@Tag("bench")
@NeedsDisplay
class ReadmePicturesDisplayTest {

  /** Size of the pictures [px], which is the default size of the window. */
  private static final int WIDTH = 1280;

  private static final int HEIGHT = 800;
  private static final TimeFactor FAST = new TimeFactor(2);
  private static final boolean UPDATE = Boolean.getBoolean("update.docs");

  /** The command port that users see; used only with {@code -Dupdate.docs=true}. */
  private static final int PORT = 8879;

  private static final Path IMAGES = Path.of("docs", "images");

  /** Maximum size of a file [bytes]. Measured: the patterns of the room take up to 760,000. */
  private static final int LARGEST = 850_000;

  @TempDir private Path folder;
  private WholeWindow window;

  @AfterEach
  void close() {
    if (window != null) {
      window.close();
    }
  }

  @Test
  void theWindowInFlight() throws IOException {
    open(Gallery.find("gate-race").orElseThrow());
    window.fly("command", "speed 100", "takeoff", "up 70", "forward 150", "up 50", "forward 120");
    window.fly("forward 60", "left 90");
    window.tell(1, "left 600");
    assertThat(window.reply(1)).isEqualTo("out of range");
    take("window.png");

    window.change(() -> window.context().actions().togglePause());
    window.change(() -> window.state().flag(Flag.PROJECTOR).set(true));
    waitUntil(() -> window.shows("projector"));
    take("projector.png");
    window.change(() -> window.state().flag(Flag.PROJECTOR).set(false));
    waitUntil(() -> !window.stage().isFullScreen());

    window.choose("language", "language-de");
    window.change(() -> window.state().themeProperty().set(Theme.DARK));
    take("dark-german.png");
  }

  @Test
  void throughTheDronesCamera() throws IOException {
    open(SimConfig.DEFAULT);
    window.fly("command", "takeoff", "up 60", "ccw 30", "back 60");
    window.change(() -> window.scene().viewCameraProperty().set(ViewCamera.DRONE));
    take("drone-camera.png");
  }

  @Test
  void severalDrones() throws IOException {
    List<Pose> starts = new ArrayList<>();
    for (double y : new double[] {0.6, 0, -0.6}) {
      starts.add(new Pose(new Vec3(0, y, 0), Attitude.LEVEL));
    }
    open(SimConfig.DEFAULT.withRoom(Room.DEFAULT, starts));
    window.change(
        () ->
            window
                .context()
                .simulation()
                .selectedProperty()
                .set(window.context().simulation().drones().get(1)));
    all("command", "command", "command");
    all("takeoff", "takeoff", "takeoff");
    all("up 40", "forward 90", "up 60");
    all("forward 60", "cw 30", "back 50");
    take("several-drones.png");
  }

  @Test
  void helpOverTheWindow() throws IOException {
    open(SimConfig.DEFAULT);
    new QuickRobot().type(KeyCode.F1);
    take("help.png");
  }

  @Test
  void theDroneNearby() throws IOException {
    open(SimConfig.DEFAULT);
    window.fly("command", "takeoff", "up 40");
    window.change(
        () -> {
          window.scene().camera().followingProperty().set(true);
          window.scene().camera().zoomBy(3.5);
          window.scene().camera().turn(480, 30);
        });
    take("drone.png");
  }

  private void open(SimConfig config) {
    open(Scenario.of(config));
  }

  private void open(Scenario scenario) {
    SimConfig config = scenario.config().withTimeFactor(FAST);
    SimConfig fast = UPDATE ? config : config.withStreamPorts(WholeWindow.NOWHERE);
    window =
        WholeWindow.open(scenario.withConfig(fast), folder.resolve("settings"), UPDATE ? PORT : 0);
    window.asAtFirst().switchOn();
    waitUntil(() -> window.stage().getWidth() == WIDTH && window.stage().getHeight() == HEIGHT);
    new QuickRobot().moveTo("#scene-3d"); // where the pointer highlights no button
  }

  private void all(String first, String second, String third) {
    List<String> commands = List.of(first, second, third);
    for (int drone = 1; drone <= 3; drone++) {
      window.tell(drone, commands.get(drone - 1));
    }
    for (int drone = 1; drone <= 3; drone++) {
      assertThat(window.reply(drone)).isEqualTo("ok");
    }
  }

  /** Takes a picture once the camera has caught up with the drone. */
  private void take(String name) throws IOException {
    awaitRestOfTheCamera();
    BufferedImage picture = coarse(window.picture());
    assertThat(picture.getWidth()).isEqualTo(WIDTH);
    assertThat(picture.getHeight()).isEqualTo(HEIGHT);
    assertThat(colors(picture)).as("colours in the middle").isGreaterThan(50);
    byte[] file = CompressedImage.bytes(picture, "png", 0);
    assertThat(file.length).as("size of %s", name).isLessThan(LARGEST);
    if (UPDATE) {
      Files.createDirectories(IMAGES);
      Files.write(IMAGES.resolve(name), file);
    }
  }

  private void awaitRestOfTheCamera() {
    window.passFrames(10);
    Vec3 before;
    Vec3 now = eye();
    do {
      before = now;
      window.passFrames(5);
      now = eye();
    } while (now.minus(before).norm() > 0.003);
  }

  private Vec3 eye() {
    return onFxThread(() -> window.scene().camera().pose().position());
  }

  private static int colors(BufferedImage picture) {
    int[] middle = picture.getRGB(WIDTH / 4, HEIGHT / 4, WIDTH / 2, HEIGHT / 3, null, 0, WIDTH / 2);
    return (int) Arrays.stream(middle).distinct().count();
  }

  /** Returns the picture with 128 shades of each colour, which makes the file small. */
  private static BufferedImage coarse(WritableImage picture) {
    int width = (int) picture.getWidth();
    int height = (int) picture.getHeight();
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int color = picture.getPixelReader().getArgb(x, y) & 0xfefefe;
        image.setRGB(x, y, color | ((color >> 7) & 0x010101));
      }
    }
    return image;
  }
}
