package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ScrollPane;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.scenario.Gallery;

/** The gallery, from which scenarios and files are opened. */
class GalleryFxTest {

  @RegisterExtension
  final AppFixture window = new AppFixture(() -> new Stage(StageStyle.UNDECORATED));

  private final FxRobot robot = window.robot();
  @TempDir private Path folder;

  @Test
  void theFolderOpensItAndEscClosesIt() {
    assertThat(shown()).isFalse();

    robot.clickOn("#scenarios");
    assertThat(shown()).isTrue();
    assertThat(robot.lookup(".scenario-card").queryAll()).hasSize(Gallery.NAMES.size());

    robot.type(KeyCode.ESCAPE);
    assertThat(shown()).isFalse();
  }

  @Test
  void arrowsMoveBetweenTheCardsAndEnterOpensOne() {
    robot.clickOn("#scenarios");
    assertThat(focused()).isEqualTo("scenario-empty-room");
    Button open = robot.lookup("#gallery-open").queryButton();
    assertThat(open.isDefaultButton()).as("Enter is for the cards").isFalse();

    robot.type(KeyCode.RIGHT, KeyCode.RIGHT);
    assertThat(focused()).isEqualTo("scenario-slalom");
    robot.type(KeyCode.DOWN);
    assertThat(focused()).isEqualTo("scenario-pad-course");
    robot.type(KeyCode.UP, KeyCode.HOME, KeyCode.LEFT, KeyCode.UP);
    assertThat(focused()).isEqualTo("scenario-empty-room");
    robot.type(KeyCode.END, KeyCode.ENTER);

    waitUntil(() -> window.stage().getTitle().equals("Swarm stage – Tello Simulator"));
    assertThat(shown()).isFalse();
  }

  @Test
  void aClickOpensAScenarioInTheLanguageOfTheProgram() {
    change(() -> language("language-de").fire());
    robot.clickOn("#scenarios");
    Node card = robot.lookup("#scenario-wind").query();
    assertThat(card.getAccessibleText())
        .startsWith("Wind. Schwierigkeit: mittel. Lernen Sie, dass");

    robot.clickOn("#scenario-over-the-wall");

    waitUntil(() -> window.stage().getTitle().equals("Über die Mauer – Tello Simulator"));
    assertThat(window.label("scenario-name")).isEqualTo("Über die Mauer");
  }

  /**
   * All scenarios fit on the smallest screens, without an empty strip below them. A window's frame
   * takes up to 28 pixels of the height.
   */
  @Test
  void allScenariosAreSeenWithoutScrolling() {
    for (String language : List.of("en", "de")) {
      change(() -> language("language-" + language).fire());
      assertSeenWithoutScrolling(1280, 772);
      assertSeenWithoutScrolling(1024, 740);
    }
  }

  private void assertSeenWithoutScrolling(double width, double height) {
    change(() -> size(width, height));
    robot.clickOn("#scenarios");
    for (String name : Gallery.NAMES) {
      ImageView picture = (ImageView) robot.lookup("#scenario-" + name).query().lookup("ImageView");
      waitUntil(() -> picture.getImage() != null);
    }
    ScrollPane scroll = robot.lookup("#gallery .scroll-pane").queryAs(ScrollPane.class);

    double view = onFxThread(() -> scroll.getViewportBounds().getHeight());
    double cards = onFxThread(() -> scroll.getContent().getLayoutBounds().getHeight());
    assertThat(cards).isBetween(view - 2, view + 0.5);
    Bounds last = onFxThread(() -> inScene("scenario-swarm-stage"));
    Bounds button = onFxThread(() -> inScene("gallery-close"));
    assertThat(button.getMinY() - last.getMaxY()).as("the empty strip").isLessThan(40);
    robot.type(KeyCode.ESCAPE);
  }

  private void size(double width, double height) {
    window.stage().setWidth(width);
    window.stage().setHeight(height);
  }

  private Bounds inScene(String id) {
    Node node = robot.lookup("#" + id).query();
    return node.localToScene(node.getLayoutBounds());
  }

  @Test
  void thePicturesComeByThemselves() {
    robot.clickOn("#scenarios");

    for (String name : Gallery.NAMES) {
      ImageView picture = (ImageView) robot.lookup("#scenario-" + name).query().lookup("ImageView");
      waitUntil(() -> picture.getImage() != null);
      assertThat(picture.getFitWidth()).isGreaterThan(100);
    }
  }

  @Test
  void filesThatWereOpenAreListedAndThoseThatAreGoneAreMarked() throws IOException {
    Path kept = Files.writeString(folder.resolve("kept.yaml"), "name: Kept\n");
    Path gone = Files.writeString(folder.resolve("gone.yaml"), "name: Gone\n");
    change(() -> window.app().open(kept));
    change(() -> window.app().open(gone));
    Files.delete(gone);

    robot.clickOn("#scenarios");
    waitUntil(() -> text("recent-1").equals("gone.yaml (gone)"));
    assertThat(text("recent-2")).isEqualTo("kept.yaml");
    robot.clickOn("#recent-2");

    assertThat(window.stage().getTitle()).isEqualTo("kept.yaml – Tello Simulator");
  }

  @Test
  void theEmptyRoomHasNothingToDo() throws IOException {
    Path file = Files.writeString(folder.resolve("room.yaml"), "goals: [{land: {at: [0, 0]}}]\n");
    change(() -> window.app().open(file));
    assertThat(robot.lookup("#goal-panel").query().isVisible()).isTrue();

    robot.clickOn("#scenarios").clickOn("#gallery-empty");

    assertThat(window.stage().getTitle()).isEqualTo("Tello Simulator");
    assertThat(robot.lookup("#goal-panel").query().isVisible()).isFalse();
  }

  @Test
  void aFolderThatIsNoRecordingIsToldInASentence() {
    change(() -> window.app().openRecording(folder));

    waitUntil(() -> robot.lookup("#question-page").tryQuery().isPresent());
    robot.clickOn("#close");
    waitUntil(() -> window.log().contains(folder.getFileName().toString()));
  }

  private MenuItem language(String id) {
    Menu menu = (Menu) robot.lookup("#settings").queryAs(MenuButton.class).getItems().get(0);
    return menu.getItems().stream()
        .filter(item -> item.getId().equals(id))
        .findFirst()
        .orElseThrow();
  }

  private boolean shown() {
    return robot.lookup("#page-overlay").query().isVisible()
        && robot.lookup("#gallery-page").tryQuery().isPresent();
  }

  private String focused() {
    return onFxThread(() -> window.stage().getScene().getFocusOwner().getId());
  }

  private String text(String id) {
    return robot.lookup("#" + id).queryButton().getText();
  }
}
