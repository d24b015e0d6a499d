package tellosimulator.view;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import java.util.List;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimConfig;

/** What the window shows and keeps of the drones' video. */
class WindowVideoFxTest {

  /** Two drones that look at opposite walls. */
  private static final List<Pose> STARTS =
      List.of(
          new Pose(Vec3.ZERO, Attitude.LEVEL),
          new Pose(new Vec3(0, 1, 0), Attitude.ofHeading(Math.PI)));

  private final FxRobot robot = new FxRobot();
  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    SimConfig config = SimConfig.DEFAULT.withRoom(SimConfig.DEFAULT.room(), STARTS);
    window = WholeWindow.open(config, folder.resolve("settings"));
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void theInsetShowsAPictureThoughNobodyTakesTheVideo() {
    robot.type(KeyCode.F6);

    waitUntil(() -> picture() != null);
    assertThat(window.shows("inset-live")).isFalse();
    robot.type(KeyCode.F6);
    assertThat(onFxThread(this::picture)).isNull();
  }

  @Test
  void whileTheVideoIsSentTheInsetSaysSo() {
    window.switchOn();
    robot.type(KeyCode.F6);

    window.fly("command", "streamon");
    waitUntil(() -> window.shows("inset-live"));

    window.fly("streamoff");
    waitUntil(() -> !window.shows("inset-live"));
  }

  @Test
  void theInsetFollowsTheSelection() {
    robot.type(KeyCode.F6);
    waitUntil(() -> picture() != null);
    int first = onFxThread(() -> checksum(picture()));

    window.change(
        () -> {
          FxSimulation simulation = window.context().simulation();
          simulation.selectedProperty().set(simulation.drones().get(1));
        });

    waitUntil(() -> picture() != null);
    assertThat(onFxThread(() -> checksum(picture()))).isNotEqualTo(first);
  }

  private Image picture() {
    return window.find("inset-picture", ImageView.class).getImage();
  }

  private static int checksum(Image image) {
    int sum = 0;
    for (int x = 0; x < (int) image.getWidth(); x++) {
      for (int y = 0; y < (int) image.getHeight(); y++) {
        sum = sum * 31 + image.getPixelReader().getArgb(x, y);
      }
    }
    return sum;
  }
}
