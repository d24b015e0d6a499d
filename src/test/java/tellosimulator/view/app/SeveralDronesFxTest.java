package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.view.testing.QuickRobot;
import tellosimulator.view.world.Simulator3DScene;

/** The parts of the window for several drones. */
class SeveralDronesFxTest {

  private final FxRobot robot = new QuickRobot();
  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    window = WholeWindow.ofDrones(3, folder);
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void keysGoFromDroneToDrone() {
    robot.type(KeyCode.PAGE_DOWN);
    assertThat(selected()).isEqualTo(2);
    robot.type(KeyCode.PAGE_UP, KeyCode.PAGE_UP);
    assertThat(selected()).isEqualTo(3);
  }

  @Test
  void theListIsHiddenAndShownAgain() {
    assertThat(window.shows("drone-list")).isTrue();
    robot.type(KeyCode.F5);
    assertThat(window.shows("drone-list")).isFalse();
    robot.clickOn("#show-drones");
    assertThat(window.shows("drone-list")).isTrue();
  }

  @Test
  void aLongListIsFoldedAtFirst() {
    assertThat(window.shows("drones")).as("three rows").isTrue();
    window.close();

    window = WholeWindow.ofDrones(6, folder);
    assertThat(window.shows("drone-list")).isTrue();
    assertThat(window.shows("drones")).as("six rows").isFalse();
    robot.clickOn("#drones-fold");
    assertThat(window.shows("drones")).isTrue();
  }

  @Test
  void whetherDistantDronesAreLargerIsRemembered() {
    assertThat(enlarged()).isTrue();
    robot.clickOn("#settings").clickOn("#enlarged-drones");
    assertThat(enlarged()).isFalse();
    window.close();

    window = WholeWindow.ofDrones(3, folder);

    assertThat(enlarged()).isFalse();
  }

  private boolean enlarged() {
    return window.find("scene-3d", Simulator3DScene.class).dronesEnlargedProperty().get();
  }

  private int selected() {
    return window.context().simulation().selected().number();
  }
}
