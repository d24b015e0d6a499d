package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javafx.scene.control.ListView;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.testing.QuickRobot;

/** Commands typed into the command palette are run. */
class CommandPaletteFxTest {

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
  void wordsChangeThemeAndLanguage() {
    enter("dark");
    assertThat(window.state().themeProperty().get()).isEqualTo(Theme.DARK);
    assertThat(window.shows("page-overlay")).as("closed").isFalse();

    enter("german");
    assertThat(window.text("power")).isEqualTo("Drohne einschalten");
    enter("hell");
    assertThat(window.state().themeProperty().get()).isEqualTo(Theme.LIGHT);
    enter("english");
    assertThat(window.text("power")).isEqualTo("Start Drone");
  }

  @Test
  void valuesAreSet() {
    enter("wind 2");
    assertThat(window.snapshot().arena().wind().mean()).isEqualTo(new Vec3(2, 0, 0));
    enter("wind 1,5 m/s");
    assertThat(window.snapshot().arena().wind().mean()).isEqualTo(new Vec3(1.5, 0, 0));
    enter("no wind");
    assertThat(window.snapshot().arena().wind().mean()).isEqualTo(Vec3.ZERO);

    enter("speed 5");
    assertThat(window.snapshot().clock().factor().value()).isEqualTo(5);
    enter("drone 2");
    assertThat(window.context().simulation().selected().number()).isEqualTo(2);
    enter("battery 40");
    assertThat(batteryOf(window.snapshot(), 2)).isEqualTo(40);
    enter("fault loss state 20%");
    assertThat(window.snapshot().drones().get(0).faults().faults()).hasSize(1);
    enter("end faults");
    assertThat(window.snapshot().drones().get(0).faults().faults()).isEmpty();
  }

  private static double batteryOf(SimSnapshot snapshot, int drone) {
    return Math.rint(snapshot.drones().get(drone - 1).state().energy().battery().percent());
  }

  @Test
  void whatCannotBeIsNotOffered() {
    for (String typed :
        List.of(
            "wind 21", "wind much", "battery 101", "drone 4", "drone 1.5", "speed -1", "xyzzy")) {
      type(typed);

      assertThat(list().getItems()).as(typed).isEmpty();
      robot.type(KeyCode.ENTER);
      assertThat(window.shows("command-palette")).as(typed).isTrue();
      robot.type(KeyCode.ESCAPE);
      assertThat(window.shows("page-overlay")).as(typed).isFalse();
    }
  }

  @Test
  void arrowsChooseAndEscapeLeaves() {
    type("view");
    assertThat(list().getItems()).hasSizeGreaterThan(3);
    assertThat(selected()).isZero();
    robot.type(KeyCode.DOWN, KeyCode.DOWN);
    assertThat(selected()).isEqualTo(2);
    robot.type(KeyCode.UP, KeyCode.UP, KeyCode.UP);
    assertThat(selected()).as("the last one").isEqualTo(list().getItems().size() - 1);

    robot.type(KeyCode.ESCAPE);
    assertThat(window.shows("page-overlay")).isFalse();
    assertThat(onFxThread(() -> window.stage().getScene().getFocusOwner()))
        .isEqualTo(window.scene());
  }

  @Test
  void whatKeysDoIsFoundByItsNameAndDone() {
    enter("pause");
    assertThat(window.snapshot().clock().paused()).isTrue();

    enter("fold log");
    assertThat(window.shows("log-list")).isFalse();
    enter("help");
    assertThat(window.shows("help-page")).isTrue();
  }

  @Test
  void theMenuHasTheSameCommands() {
    assertThat(fire("group-wind", "Wind of 3 m/s")).isTrue();
    assertThat(window.snapshot().arena().wind().mean()).isEqualTo(new Vec3(3, 0, 0));
    assertThat(fire("group-time", "Pause or resume simulated time (F9)")).isTrue();
    assertThat(window.snapshot().clock().paused()).isTrue();

    window.change(() -> window.context().language().localeProperty().set(Locale.GERMAN));
    assertThat(fire("group-theme", "Dunkel")).isTrue();
    assertThat(window.state().themeProperty().get()).isEqualTo(Theme.DARK);
  }

  private boolean fire(String menu, String text) {
    return onFxThread(
        () -> {
          for (MenuItem group : window.find("commands", MenuButton.class).getItems()) {
            if (menu.equals(group.getId())) {
              for (MenuItem item : ((Menu) group).getItems()) {
                if (text.equals(item.getText())) {
                  item.fire();
                  return true;
                }
              }
            }
          }
          return false;
        });
  }

  private void type(String text) {
    robot.push(KeyCode.CONTROL, KeyCode.K).write(text);
  }

  private void enter(String text) {
    type(text);
    robot.type(KeyCode.ENTER);
  }

  private int selected() {
    return list().getSelectionModel().getSelectedIndex();
  }

  private ListView<?> list() {
    return window.find("command-list", ListView.class);
  }
}
