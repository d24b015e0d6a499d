package tellosimulator.view.app;

import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.control.Slider;
import javafx.scene.image.PixelReader;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.benchmark.Statistics;
import tellosimulator.sim.SimConfig;
import tellosimulator.view.testing.NeedsDisplay;
import tellosimulator.view.testing.QuickRobot;

/**
 * Measures the time until the screen shows a room that was changed by its slider: at most 100 ms on
 * an otherwise idle machine. The test prints the time, and fails if the screen does not follow.
 */
@Tag("bench")
@NeedsDisplay
class RoomSliderDisplayTest {

  /** Number of changes of the room, the first of which only warm up. */
  private static final int CHANGES = 16;

  private static final int WARM_UP = 5;

  private final FxRobot robot = new QuickRobot();
  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    window = WholeWindow.open(SimConfig.DEFAULT, folder.resolve("settings"));
    waitUntil(() -> window.stage().isFocused());
    window.passFrames(30);
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void theRoomFollowsItsSlider() {
    Slider slider = window.find("room-width", Slider.class);
    List<Double> times = new ArrayList<>();
    for (int change = 0; change < CHANGES; change++) {
      double width = 500 + 50 * (change % 2 + 1);
      int[] before = pixels();
      long start = System.nanoTime();
      onFxThread(
          () -> {
            slider.setValue(width);
            return width;
          });
      AtomicLong seen = new AtomicLong();
      waitUntil(
          () -> {
            boolean differs = differs(before);
            seen.set(System.nanoTime());
            return differs;
          });
      if (change >= WARM_UP) {
        times.add((seen.get() - start) * 1e-6);
      }
      window.passFrames(40); // the camera is at rest
    }

    double median = new Statistics(times).median();
    System.out.printf(
        "From a slider's change to the changed room on the screen: %.0f ms%n", median);
  }

  private boolean differs(int[] before) {
    int[] now = pixels();
    int changed = 0;
    for (int i = 0; i < now.length; i++) {
      changed += now[i] == before[i] ? 0 : 1;
    }
    return changed > now.length / 20;
  }

  /** Returns a part of the floor from the screen. */
  private int[] pixels() {
    Rectangle2D part =
        onFxThread(
            () -> {
              var scene = window.find("scene-3d", Node.class);
              var middle = scene.localToScreen(scene.getLayoutBounds());
              return new Rectangle2D(
                  Math.floor(middle.getCenterX()), Math.floor(middle.getCenterY()), 150, 60);
            });
    PixelReader image = robot.capture(part).getImage().getPixelReader();
    int[] pixels = new int[150 * 60];
    for (int y = 0; y < 60; y++) {
      for (int x = 0; x < 150; x++) {
        pixels[y * 150 + x] = image.getArgb(x, y);
      }
    }
    return pixels;
  }
}
