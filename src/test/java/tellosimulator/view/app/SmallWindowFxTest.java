package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Control;
import javafx.scene.control.Labeled;
import javafx.scene.control.ListView;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.text.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.sim.SimConfig;
import tellosimulator.view.testing.QuickRobot;

/** The window on the smallest screens: nothing is cut off, and what does not fit is folded. */
class SmallWindowFxTest {

  private final FxRobot robot = new QuickRobot();
  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    window = WholeWindow.ofDrones(3, folder);
    window.passFrames(80); // it keeps its opening size for more than a second
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void nothingIsCutOff() {
    assertNothingIsCutOff("while all is off");

    window.switchOn();
    assertThat(window.fly("command", "battery?")).isNotBlank();
    robot.clickOn("#keyboard-flight");
    assertNothingIsCutOff("while all is on");

    window.asAtFirst();
    assertNothingIsCutOff("while parts are folded away");
  }

  private void assertNothingIsCutOff(String when) {
    for (Locale language : List.of(Locale.ENGLISH, Locale.GERMAN)) {
      window.change(() -> window.context().language().localeProperty().set(language));
      assertNothingIsCutOff(1024, 768, when);
      assertNothingIsCutOff(1280, 800, when);
    }
  }

  private void assertNothingIsCutOff(double width, double height, String when) {
    resize(width, height);
    window.passFrames(5);
    assertThat(problems()).as("%s, at a width of %s", when, width).isEmpty();
  }

  @Test
  void cardsForWhichThereIsNoRoomAreFoldedAndOpenOnClick() {
    resize(1024, 600);
    waitUntil(() -> !isOpen("card-product"));
    assertThat(window.shows("wind-speed")).isFalse();
    assertThat(window.shows("power")).isTrue();

    robot.clickOn("#card-wind");
    assertThat(window.shows("wind-speed")).isTrue();

    robot.type(KeyCode.F4);
    resize(1280, 800);
    waitUntil(() -> isOpen("card-product"));
    assertThat(window.shows("profile")).as("there is room without the log").isTrue();
    robot.clickOn("#card-product");
    window.close();
    window = WholeWindow.open(SimConfig.DEFAULT, folder.resolve("settings"));
    assertThat(window.shows("profile")).as("remembered").isFalse();
    assertThat(window.shows("wind-speed")).as("remembered").isTrue();
  }

  @Test
  void whatIsSeldomChangedIsFoldedAtFirstAndThenAsItWasLeft() {
    resize(1280, 800);
    assertThat(isOpen("card-more")).isFalse();
    robot.clickOn("#card-more");
    assertThat(isOpen("card-more")).isTrue();

    window.close();
    window = WholeWindow.open(SimConfig.DEFAULT, folder.resolve("settings"));

    assertThat(isOpen("card-more")).as("remembered").isTrue();
  }

  @Test
  void aNarrowSceneHasIconsAndFoldsWhatLiesOverIt() {
    resize(1280, 800);
    waitUntil(() -> shown("demo-flight") == ContentDisplay.LEFT);
    assertThat(window.shows("drones")).isTrue();

    resize(1024, 768);
    waitUntil(() -> shown("demo-flight") == ContentDisplay.GRAPHIC_ONLY);
    assertThat(window.shows("drones")).isFalse();
    assertThat(window.find("demo-flight", Control.class).getTooltip().getText())
        .isEqualTo("Demo flight");

    robot.clickOn("#drones-fold");
    assertThat(window.shows("drones")).isTrue();

    System.gc(); // weakly referenced listeners would be gone
    window.asAtFirst();
    waitUntil(() -> shown("pilot-power") == ContentDisplay.LEFT);
    resize(980, 768);
    waitUntil(() -> shown("pilot-power") == ContentDisplay.GRAPHIC_ONLY);
  }

  @Test
  void asManyButtonsOfTheBarHaveWordsAsThereIsRoomFor() {
    assertWordsHaveRoom(Locale.ENGLISH, "Scenarios", "Settings");
    assertWordsHaveRoom(Locale.GERMAN, "Szenarien", "Einstellungen");
  }

  private void assertWordsHaveRoom(Locale language, String first, String other) {
    window.change(() -> window.context().language().localeProperty().set(language));
    resize(1280, 800);
    waitUntil(() -> shown("settings") == ContentDisplay.LEFT);
    assertThat(window.text("settings")).isEqualTo(other);
    assertThat(shown("scenarios")).as("more important").isEqualTo(ContentDisplay.LEFT);
    assertThat(window.text("scenarios")).isEqualTo(first);
    assertThat(shown("show-plan")).as("all of a group or none").isEqualTo(shown("show-inset"));
    assertThat(overflows()).isFalse();

    resize(1024, 768);
    waitUntil(() -> shown("view-follow") == ContentDisplay.GRAPHIC_ONLY);
    assertThat(window.find("view-follow", Control.class).getTooltip().getText()).isNotBlank();
    assertThat(shown("view-fit")).as("all of a group or none").isEqualTo(shown("view-follow"));
    assertThat(shown("show-network")).as("the most important").isEqualTo(ContentDisplay.LEFT);
    assertThat(overflows()).isFalse();

    resize(1280, 800);
    waitUntil(() -> shown("settings") == ContentDisplay.LEFT);
  }

  /** Returns whether buttons of the bar have moved into the overflow menu. */
  private boolean overflows() {
    return onFxThread(() -> window.find("window-bar").lookup(".tool-bar-overflow-button"))
        .isVisible();
  }

  private void resize(double width, double height) {
    window.change(
        () -> {
          window.stage().setWidth(width);
          window.stage().setHeight(height);
        });
    waitUntil(() -> window.stage().getScene().getHeight() == height);
  }

  private boolean isOpen(String card) {
    return window.find(card, ToggleButton.class).isSelected();
  }

  private ContentDisplay shown(String id) {
    return window.find(id, Labeled.class).getContentDisplay();
  }

  /** Returns the nodes that are cut off, or lie outside their parent. */
  private List<String> problems() {
    return onFxThread(
        () -> {
          List<String> problems = new ArrayList<>();
          Parent root = window.stage().getScene().getRoot();
          examine(root, root.localToScene(root.getLayoutBounds()), problems);
          return problems;
        });
  }

  private static void examine(Node node, Bounds room, List<String> problems) {
    if (!node.isVisible()) {
      return;
    }
    if (node instanceof Labeled labeled) {
      if (cutOff(labeled)) {
        problems.add("'" + labeled.getText() + "' is cut off in " + labeled);
      }
    }
    Bounds place = node.localToScene(node.getLayoutBounds());
    if (node instanceof Control && !almost(room).contains(place)) {
      problems.add(node + " at " + place + " lies outside of " + room);
    }
    boolean scrolls = node instanceof ListView || node instanceof ScrollPane;
    if (node instanceof Parent parent && !(node instanceof ListView)) {
      Bounds inside = scrolls ? everywhere() : node instanceof Control ? place : room;
      parent.getChildrenUnmodifiable().forEach(child -> examine(child, inside, problems));
    }
  }

  private static boolean cutOff(Labeled labeled) {
    boolean written = labeled.getContentDisplay() != ContentDisplay.GRAPHIC_ONLY;
    return written
        && labeled.lookup(".text") instanceof Text text
        && text.getParent() == labeled
        && !labeled.getText().isEmpty()
        && !text.getText().equals(labeled.getText());
  }

  /**
   * Returns slightly larger bounds: borders may exceed them by half a pixel, and focus rings by
   * more.
   */
  private static Bounds almost(Bounds room) {
    return new BoundingBox(
        room.getMinX() - 1, room.getMinY() - 1, room.getWidth() + 2, room.getHeight() + 2);
  }

  private static Bounds everywhere() {
    double far = 100_000;
    return new BoundingBox(-far, -far, 2 * far, 2 * far);
  }
}
