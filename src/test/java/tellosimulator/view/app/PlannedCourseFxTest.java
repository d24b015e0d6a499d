package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;

/**
 * The course of a lesson, planned with the mouse: goals and drones, and the file to which it is
 * saved.
 */
class PlannedCourseFxTest {

  /** A room of 6 by 6 m, so that a metre has the same length on the screen in both directions. */
  private static final String COURSE =
      """
      # the course of the third lesson
      room: {width: 600, depth: 600, height: 250}   # the gym, half of it
      drones:
        - {start: [-200, 0], state-port: 9, video-port: 10}   # at the door
      goals:
        # first up
        - reach: {at: [0, 100, 100], radius: 30}   # over the box
        - land: {at: [-200, 0], radius: 30}   # and back
      in-order: true
      """;

  @RegisterExtension
  final AppFixture window = new AppFixture(() -> new Stage(StageStyle.UNDECORATED));

  private final FxRobot robot = window.robot();
  @TempDir private Path folder;
  private Path file;

  @BeforeEach
  void open() throws IOException {
    file = Files.writeString(folder.resolve("course.yaml"), COURSE);
    change(() -> window.app().open(file));
    robot.type(KeyCode.F10);
    waitUntil(() -> robot.lookup("#plan").query().isVisible());
  }

  @Test
  void aGoalIsAddedDraggedNumberedAndSavedWithTheCommentsOfTheFile() throws IOException {
    addGoal("reach");
    waitUntil(() -> status().startsWith("Goal 3: "));
    Point2D middle = at(0, 0);
    robot.drag(middle).moveTo(at(50, -50)).dropTo(at(100, -100));
    waitUntil(() -> status().equals("Goal 3: reach x 100, y -100, z 100 cm"));
    assertThat(goals()).hasSize(3);

    choose("property-number", 2);
    waitUntil(() -> status().startsWith("Goal 2: reach x 100"));
    assertThat(goals().get(1)).isEqualTo("reach x 100, y -100, z 100 cm");

    control(KeyCode.S);

    waitUntil(() -> !unsaved());
    String added = "  - reach: {at: [100, -100, 100], radius: 30}\n";
    assertThat(Files.readString(file).replaceFirst(" *- reach: \\{at: \\[100, -100.*\n", added))
        .isEqualTo(COURSE.replace("  - land:", added + "  - land:"));
  }

  @Test
  void theRoomsSlidersAreFoldedWhereGoalsAreAskedFor() throws IOException {
    ToggleButton card = robot.lookup("#card-room").queryAs(ToggleButton.class);
    assertThat(card.isSelected()).as("with the goals of the file").isFalse();

    robot.clickOn(card);
    assertThat(card.isSelected()).isTrue();
    addGoal("reach");
    waitUntil(() -> status().startsWith("Goal 3: "));

    assertThat(card.isSelected()).as("as a person left it").isTrue();
  }

  @Test
  void whatWasDoneToGoalsIsUndone() throws IOException {
    addGoal("hover");
    waitUntil(() -> goals().size() == 3);
    robot.drag(at(0, 0)).moveTo(at(20, 20)).dropTo(at(150, 150));
    waitUntil(() -> status().contains("x 150, y 150"));
    choose("property-number", 1);
    waitUntil(() -> goals().get(0).contains("x 150, y 150"));

    control(KeyCode.Z);
    waitUntil(() -> goals().get(2).contains("x 150, y 150"));
    control(KeyCode.Z);
    waitUntil(() -> goals().get(2).contains("x 0, y 0"));
    control(KeyCode.Z);

    waitUntil(() -> !unsaved());
    assertThat(goals()).hasSize(2);
  }

  @Test
  void aDroneIsAddedToASimulationThatBeginsAnewAndUndone() throws IOException {
    robot.clickOn("#plan-add-drone");

    waitUntil(() -> status().startsWith("Start of drone 2"));
    assertThat(window.app().ready()).contains("drone 2");
    waitUntil(this::unsaved);
    robot.drag(at(0, 0)).moveTo(at(20, 20)).dropTo(at(0, 200));
    waitUntil(() -> status().equals("Start of drone 2: X 0, Y 200 cm, 0°"));
    control(KeyCode.S);
    waitUntil(() -> !unsaved());
    assertThat(Files.readAllLines(file))
        .containsSubsequence(COURSE.lines().limit(5).toList())
        .anyMatch(line -> line.matches("  - \\{start: \\[0, 200\\].*\\}"))
        .containsSubsequence(COURSE.lines().skip(5).toList());

    control(KeyCode.Z);
    waitUntil(() -> status().equals("Start of drone 2: X 0, Y 0 cm, 0°"));
    control(KeyCode.Z);
    waitUntil(() -> !window.app().ready().contains("drone 2"));
    control(KeyCode.Y);
    waitUntil(() -> window.app().ready().contains("drone 2"));
  }

  @Test
  void aGoalIsDuplicatedEditedAndTakenAway() {
    robot.clickOn(at(0, 100));
    control(KeyCode.D);
    waitUntil(() -> goals().size() == 3);
    enter("property-height-of-goal", "150");
    waitUntil(() -> goals().get(2).endsWith("z 150 cm"));
    choose("property-drone", 1);
    waitUntil(() -> goals().get(2).startsWith("Drone 1 reach"));

    robot.clickOn("#plan-remove");
    waitUntil(() -> goals().size() == 2);
  }

  private void addGoal(String kind) {
    robot.clickOn("#plan-add-goal");
    waitUntil(() -> robot.lookup("#plan-add-" + kind).tryQuery().isPresent());
    robot.clickOn("#plan-add-" + kind);
  }

  private void choose(String id, int number) {
    change(() -> combo(id).setValue(number));
  }

  @SuppressWarnings("unchecked")
  private ComboBox<Integer> combo(String id) {
    return robot.lookup("#" + id).queryAs(ComboBox.class);
  }

  private void enter(String field, String text) {
    robot.clickOn("#" + field).press(KeyCode.CONTROL).type(KeyCode.A).release(KeyCode.CONTROL);
    robot.write(text).type(KeyCode.ENTER);
  }

  private void control(KeyCode key) {
    robot.press(KeyCode.CONTROL).type(key).release(KeyCode.CONTROL);
  }

  private boolean unsaved() {
    return window.stage().getTitle().startsWith("* ");
  }

  private String status() {
    return window.label("plan-status");
  }

  /** Returns the tasks of the goal panel, each after its drone if there is one. */
  private List<String> goals() {
    return onFxThread(
        () ->
            window.stage().getScene().getRoot().lookupAll(".goal").stream()
                .filter(row -> row.getId() != null)
                .sorted(Comparator.comparing(Node::getId))
                .map(
                    row ->
                        Stream.of(row.lookup(".drone"), row.lookup(".task"))
                            .filter(Objects::nonNull)
                            .map(part -> ((Label) part).getText())
                            .collect(Collectors.joining(" ")))
                .toList());
  }

  /**
   * Returns the position of a place on the floor on the screen, by its coordinates in cm: the room
   * is square.
   */
  private Point2D at(double x, double y) {
    return onFxThread(
        () -> {
          Node plan = window.stage().getScene().lookup("#plan");
          double width = plan.getLayoutBounds().getWidth();
          double height = plan.getLayoutBounds().getHeight();
          double pixels = (Math.min(width, height) - 2 * 34) / 600; // with the margin of the plan
          return plan.localToScreen(width / 2 - y * pixels, height / 2 - x * pixels);
        });
  }
}
