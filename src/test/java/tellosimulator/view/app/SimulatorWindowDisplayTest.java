package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import javafx.geometry.Bounds;
import javafx.geometry.Rectangle2D;
import javafx.scene.control.Labeled;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TextField;
import javafx.scene.image.PixelReader;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import javafx.stage.Screen;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.testing.NeedsDisplay;
import tellosimulator.view.testing.QuickRobot;

/** The whole window on a screen with a window manager. */
@NeedsDisplay
class SimulatorWindowDisplayTest {

  /** The borders of a panel above and below its content [px]. */
  private static final double BORDERS = 2;

  /** Half the size of the square in the centre of the scene in which the drone must be [px]. */
  private static final int HALF = 60;

  private final FxRobot robot = new QuickRobot();
  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    window = WholeWindow.open(SimConfig.DEFAULT, folder.resolve("settings"));
    waitUntil(() -> window.stage().isFocused());
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void inFullScreenThePartsLieOverTheSceneAndComeBack() {
    Bounds before = bounds("scene-3d");
    assertThat(bounds("simulator-controls").getMaxX()).isLessThanOrEqualTo(before.getMinX());

    robot.type(KeyCode.F11);

    Rectangle2D screen = onFxThread(() -> Screen.getPrimary().getBounds());
    waitUntil(
        () ->
            window.stage().isFullScreen()
                && bounds("scene-3d").getWidth() == screen.getWidth()
                && bounds("scene-3d").getHeight() == screen.getHeight());
    for (String part : new String[] {"simulator-controls", "network-controls", "log"}) {
      waitUntil( // the panels are laid out a frame or more after the scene
          () -> bounds("scene-3d").contains(bounds(part)) && bounds(part).getHeight() > 100);
    }
    ScrollPane controls = robot.lookup("#network-controls").queryAs(ScrollPane.class);
    waitUntil( // no higher than its content, and not over the log
        () ->
            bounds("network-controls").getHeight()
                    <= controls.getContent().getLayoutBounds().getHeight() + BORDERS
                && bounds("network-controls").getMaxY() <= bounds("log").getMinY());
    waitUntil( // makes space for what lies over the scene
        () ->
            bounds("inset").getMaxX() <= bounds("network-controls").getMinX()
                && bounds("inset").getMinY() >= bounds("window-bar").getMaxY());

    robot.type(KeyCode.F11);

    waitUntil(() -> !window.stage().isFullScreen());
    waitUntil(
        () ->
            bounds("scene-3d").equals(before)
                && bounds("network-controls").getMaxY() == before.getMaxY());
  }

  @Test
  void aDroneThatIsFollowedIsSeenInTheMiddleOfWhatIsFree() {
    robot.type(KeyCode.DIGIT6);
    waitUntil(() -> window.scene().camera().distance() < 2);
    window.passFrames(10);
    Bounds scene = bounds("scene-3d");
    PixelReader pixels = window.picture().getPixelReader();
    int middleX = (int) scene.getCenterX();
    int middleY = (int) (scene.getMinY() + bounds("pilot-controls").getMinY()) / 2;

    assertThat(darkPixels(pixels, middleX, middleY)).isGreaterThan(150);
    assertThat(darkPixels(pixels, middleX - 4 * HALF, middleY)).isZero();
    assertThat(darkPixels(pixels, middleX + 4 * HALF, middleY)).isZero();
  }

  @Test
  void theDemoFlightMovesTheDroneAndWritesTheLog() {
    window.carryOut(new Control.SetTimeFactor(new TimeFactor(5)));
    WritableImage before = window.picture();

    // only these lines, because on a slow machine the expected one would soon be out of sight
    window.change(() -> window.find("log-search", TextField.class).setText("takeoff"));

    robot.clickOn("#demo-flight");

    waitUntil(() -> window.text("demo-flight").equals("Stop"));
    waitUntil(() -> position().z() > 0.5);
    waitUntil(
        () ->
            window.find("log-list").lookupAll(".log-reply").stream()
                .anyMatch(reply -> ((Labeled) reply).getText().equals("ok")));
    Bounds scene = bounds("scene-3d");
    assertThat(changedPixels(before, window.picture(), scene)).isGreaterThan(10_000);
  }

  private Vec3 position() {
    return window.context().simulation().selected().poseProperty().get().position();
  }

  private Bounds bounds(String id) {
    return onFxThread(() -> window.find(id).localToScene(window.find(id).getLayoutBounds()));
  }

  /** Returns the number of pixels around a place that are as dark as only a drone is. */
  private static long darkPixels(PixelReader pixels, int middleX, int middleY) {
    long dark = 0;
    for (int x = middleX - HALF; x < middleX + HALF; x++) {
      for (int y = middleY - HALF; y < middleY + HALF; y++) {
        dark += pixels.getColor(x, y).getBrightness() < 0.25 ? 1 : 0;
      }
    }
    return dark;
  }

  private static long changedPixels(WritableImage before, WritableImage after, Bounds where) {
    long changed = 0;
    for (int x = (int) where.getMinX(); x < where.getMaxX(); x++) {
      for (int y = (int) where.getMinY(); y < where.getMaxY(); y++) {
        boolean same =
            before.getPixelReader().getArgb(x, y) == after.getPixelReader().getArgb(x, y);
        changed += same ? 0 : 1;
      }
    }
    return changed;
  }
}
