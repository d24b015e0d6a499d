package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.Control;
import javafx.scene.control.Labeled;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToolBar;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.profile.Profile;
import tellosimulator.view.testing.QuickRobot;

/** All controls of the window can be reached by keyboard, and have names for screen readers. */
class KeyboardWindowFxTest {

  private final FxRobot robot = new QuickRobot();
  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    window = WholeWindow.ofDrones(2, folder);
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void eachControlIsReachedByTabAndHasAName() {
    assertReachableAndNamed();
  }

  @Test
  void eachControlOfThePlanIsReachedByTabAndHasAName() {
    robot.type(KeyCode.F10);

    assertReachableAndNamed();
    assertThat(controls()).extracting(Node::getId).contains("plan-add-box");
  }

  @Test
  void theSceneIsOneStop() {
    assertThat(owner()).isEqualTo(window.scene());
    assertThat(window.scene().getAccessibleText()).startsWith("The room");

    robot.type(KeyCode.TAB);
    assertThat(owner()).isNotEqualTo(window.scene());
    robot.press(KeyCode.SHIFT).type(KeyCode.TAB).release(KeyCode.SHIFT);
    assertThat(owner()).isEqualTo(window.scene());
  }

  @Test
  void whoSwitchesKeyboardFlightOnByKeyboardCanFly() {
    window.change(() -> window.find("keyboard-flight").requestFocus());

    robot.type(KeyCode.SPACE);

    assertThat(owner()).isEqualTo(window.scene());
  }

  @Test
  void arrowKeysChooseInAGroup() {
    window.change(() -> window.find("profile-edu").requestFocus());

    robot.type(KeyCode.RIGHT);

    assertThat(owner().getId()).isEqualTo("profile-tello");
    assertThat(window.snapshot().drones().get(0).product().profile()).isEqualTo(Profile.TELLO);
  }

  private void assertReachableAndNamed() {
    List<Node> controls = controls();
    assertThat(controls).hasSizeGreaterThan(15).filteredOn(node -> name(node).isBlank()).isEmpty();
    Set<Node> reached = new LinkedHashSet<>();
    do {
      robot.type(KeyCode.TAB);
    } while (reached.add(owner()));
    assertThat(reached).containsAll(controls);
    assertThat(reached).filteredOn(node -> name(node).isBlank()).isEmpty();
  }

  private Node owner() {
    return onFxThread(() -> window.stage().getScene().getFocusOwner());
  }

  /** Returns the controls that are enabled now, outside of lists. */
  private List<Node> controls() {
    return onFxThread(
        () -> {
          List<Node> found = new ArrayList<>();
          collect(window.stage().getScene().getRoot(), found);
          return found;
        });
  }

  private static void collect(Node node, List<Node> found) {
    if (!node.isVisible() || node.isDisabled()) {
      return;
    }
    boolean holder = node instanceof ScrollPane || node instanceof ToolBar;
    boolean passive = node instanceof Labeled && !node.isFocusTraversable() && !presses(node);
    if (node instanceof Control && !holder && !passive) {
      if (presses(node) || (node.isFocusTraversable() && !isAside(node))) {
        found.add(node);
      }
    } else if (node instanceof Parent parent) {
      parent.getChildrenUnmodifiable().forEach(child -> collect(child, found));
    }
  }

  private static boolean presses(Node node) {
    return node instanceof ButtonBase && !isAside(node);
  }

  /** Returns whether arrow keys reach the node from the selected one of its group. */
  private static boolean isAside(Node node) {
    return node instanceof ToggleButton button
        && button.getToggleGroup() != null
        && !button.isSelected();
  }

  private static String name(Node node) {
    if (node.getAccessibleText() != null) {
      return node.getAccessibleText();
    }
    return node instanceof Labeled labeled && labeled.getText() != null ? labeled.getText() : "";
  }
}
