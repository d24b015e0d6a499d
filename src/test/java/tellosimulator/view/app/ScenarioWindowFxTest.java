package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.view.app.AppFixture.change;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.testfx.api.FxRobot;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.LocalizedText;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenario.ScenarioFile;

/** Scenarios opened, saved and reloaded in the window. */
class ScenarioWindowFxTest {

  private static final String SLALOM =
      """
      name: Small slalom
      teaches: to fly around things
      room: {width: 400, depth: 600, height: 250}
      obstacles:
        - cylinder: {name: pole, at: [100, 0], radius: 10, height: 200}
      drones:
        - {start: [-200, 50], heading: 90, state-port: 9, video-port: 10}
        - {start: [-200, -50], state-port: 9, video-port: 10}
      goals:
        - reach: {at: [200, 0, 100], radius: 30}
        - land: {at: [-200, 50], radius: 30}
      in-order: true
      time-limit: 60
      """;

  @RegisterExtension
  final AppFixture window = new AppFixture(() -> new Stage(StageStyle.UNDECORATED));

  private final FxRobot robot = window.robot();
  @TempDir private Path folder;
  private Path file;
  private SimulatorApp app;
  private Stage stage;

  @BeforeEach
  void open() throws IOException {
    file = Files.writeString(folder.resolve("slalom.yaml"), SLALOM);
    app = window.app();
    stage = window.stage();
  }

  @Test
  void anotherScenarioTakesThePlaceOfTheFirst() {
    double width = stage.getWidth();
    assertThat(robot.lookup("#goal-panel").query().isVisible()).isFalse();
    waitUntil(() -> window.log().contains("Welcome"));

    change(() -> app.open(file));

    assertThat(stage.getTitle()).isEqualTo("slalom.yaml – Tello Simulator");
    assertThat(stage.getWidth()).isEqualTo(width);
    assertThat(window.label("scenario-name")).isEqualTo("Small slalom");
    assertThat(window.label("scenario-teaches")).isEqualTo("Learn to fly around things");
    assertThat(window.label("goal-time")).isEqualTo("Task 0.0 of 60 s");
    assertThat(bounds("goal-time").getMinY())
        .as("below the name, which has the whole width")
        .isGreaterThan(bounds("scenario-name").getMaxY());
    assertThat(robot.lookup("#goal-time").queryLabeled().getTooltip().getText())
        .contains("since the first takeoff")
        .contains("simulation time");
    assertThat(robot.lookup("#drone-list").query().isVisible()).isTrue();
    assertThat(robot.lookup(".goal").queryAll()).hasSize(2);
    waitUntil(
        () -> window.log().contains("Welcome") && window.log().contains("slalom.yaml is open"));
    assertThat(robot.lookup("#start-x-value").queryTextInputControl().getText()).isEqualTo("-200");
  }

  private Bounds bounds(String id) {
    Node part = robot.lookup("#" + id).query();
    return part.localToScene(part.getLayoutBounds());
  }

  @Test
  void thePaletteOpensAScenarioByItsName() {
    robot.push(KeyCode.CONTROL, KeyCode.K).write("slalom").type(KeyCode.ENTER);

    waitUntil(() -> window.label("scenario-name").equals("Slalom"));
  }

  @Test
  void aGoalOfOneDroneHasItsColorAsInTheRoom() throws IOException {
    Files.writeString(
        file,
        """
        name: Colors
        drones:
          - {start: [0, 0], colour: "#d01020"}
          - {start: [0, 100], colour: "#ffee80"}
        goals:
          - hover: {at: [0, 0, 60], radius: 45, seconds: 3, drone: 1}
          - hover: {at: [0, 100, 60], radius: 45, seconds: 3, drone: 2}
          - land: {at: [100, 0], radius: 30}
        """);

    change(() -> app.open(file));

    assertThat(mark(1)).contains("#d01020").contains("#ffffff");
    assertThat(mark(2)).contains("#ffee80").contains("#000000");
    assertThat(mark(3)).as("of any drone").isEmpty();
    assertThat(label(".mark", 2)).as("the goal's number").isEqualTo("2");
    assertThat(label(".drone", 2)).as("of one drone").isEqualTo("Drone 2");
    assertThat(drone(2).getStyle()).isEqualTo(mark(2));
    assertThat(label(".task", 2)).isEqualTo("stay 3 s at x 0, y 100, z 60 cm");
    assertThat(robot.lookup("#goal-3 .drone").queryAll()).as("of any drone").isEmpty();
  }

  @Test
  void theNextGoalOfOneDroneHasItsColorForTheClassToo() throws IOException {
    Files.writeString(
        file,
        """
        name: Colors
        drones:
          - {start: [0, 0], colour: "#d01020"}
        goals:
          - reach: {at: [0, 0, 60], radius: 45, drone: 1}
          - reach: {at: [100, 0, 60], radius: 45, drone: 1}
        in-order: true
        """);
    change(() -> app.open(file));

    project();

    waitUntil(() -> projected(1).contains("#d01020"));
    assertThat(projected(2)).as("comes later").isEmpty();
    assertThat(tickedForTheClass(1)).as("not reached").isFalse();
  }

  /** Shows the projector view, or the whole window again. */
  private void project() {
    robot.press(KeyCode.SHIFT).type(KeyCode.F11).release(KeyCode.SHIFT);
  }

  private boolean tickedForTheClass(int goal) {
    return robot.lookup("#projector-goal-" + goal).queryLabeled().getGraphic() != null;
  }

  private String projected(int goal) {
    return robot.lookup("#projector-goal-" + goal).query().getStyle();
  }

  private String label(String part, int goal) {
    return robot.lookup("#goal-" + goal + " " + part).queryLabeled().getText();
  }

  private Node drone(int goal) {
    return robot.lookup("#goal-" + goal + " .drone").query();
  }

  private String mark(int goal) {
    return robot.lookup("#goal-" + goal + " .mark").query().getStyle();
  }

  @Test
  void aScenarioThatAsksAndSaysNothingHasNoCard() throws IOException {
    Files.writeString(file, "name: Bare\ndrones:\n  - {start: [0, 0], state-port: 9}\n");

    change(() -> app.open(file));

    assertThat(robot.lookup("#goal-panel").query().isVisible()).isFalse();
  }

  @Test
  void dronesThatWereOnAreOnAgainAndKeysActOnTheNewOnes() {
    robot.clickOn("#power");
    change(() -> app.open(file));

    waitUntil(() -> app.ready().contains("drone 2"));
    waitUntil(() -> window.label("drones-heading").equals("2 of 2 on"));
    robot.type(KeyCode.F10);
    assertThat(robot.lookup("#plan-pane").query().isVisible()).isTrue();
  }

  @Test
  void anotherScenarioIsReachedFromWhereTheFirstOneWas() {
    robot.interact(() -> robot.lookup("#reachable").queryAs(CheckBox.class).fire());

    change(() -> app.open(file));

    assertThat(robot.lookup("#reachable").queryAs(CheckBox.class).isSelected()).isTrue();
  }

  @Test
  void whatIsRememberedStays() {
    boolean shown = trailButton();
    robot.clickOn("#show-trail");
    assertThat(trailButton()).isEqualTo(!shown);

    change(() -> app.open(file));

    assertThat(trailButton()).isEqualTo(!shown);
  }

  @Test
  void aFileWithMistakesLeavesTheSceneAndAllAreShown() throws IOException {
    Path wrong = folder.resolve("wrong.yaml");
    Files.writeString(wrong, "rooms: {}\ndrones:\n  - {start: [0, abc]}\n");

    change(() -> app.open(wrong));

    assertThat(robot.lookup("#mistakes-page").tryQuery()).isPresent();
    List<String> lines =
        robot.lookup(".lines .label").queryAllAs(Label.class).stream().map(Label::getText).toList();
    assertThat(lines).hasSize(2);
    assertThat(lines.get(0)).contains("wrong.yaml:1:1:");
    assertThat(lines.get(1)).contains("wrong.yaml:3:17:").contains("abc");
    assertThat(stage.getTitle()).isEqualTo("Tello Simulator");
    waitUntil(() -> window.log().contains("wrong.yaml:3:17:"));

    robot.clickOn("#mistakes-close");
    assertThat(robot.lookup("#mistakes-page").tryQuery()).isEmpty();
  }

  @Test
  void aChangedFileIsReadAgain() throws IOException {
    change(() -> app.open(file));
    Files.writeString(file, SLALOM.replace("Small slalom", "Larger slalom"));
    Files.setLastModifiedTime(file, FileTime.fromMillis(1_000_000_000));

    waitUntil(() -> window.label("scenario-name").equals("Larger slalom"));
    waitUntil(() -> window.log().contains("has changed and is read again"));
  }

  @Test
  void anotherCourseIsDrawnFromTheNextSeed() throws Exception {
    assertThat(robot.lookup("#goal-course").query().isVisible()).as("no ranges").isFalse();
    Files.writeString(file, SLALOM.replace("at: [100, 0]", "at: [100, -90..90]") + "seed: 41\n");
    change(() -> app.open(file));
    assertThat(window.label("goal-rules")).endsWith("This course: seed 41.");

    change(() -> robot.lookup("#goal-course").queryButton().fire());

    waitUntil(() -> window.label("goal-rules").endsWith("This course: seed 42."));
    assertThat(stage.getTitle()).as("unchanged").isEqualTo("slalom.yaml – Tello Simulator");
    Path copy = folder.resolve("course.yaml");
    change(() -> app.save(copy));
    assertThat(copy).as("keeps the range").hasSameTextualContentAs(file);
    robot.push(KeyCode.CONTROL, KeyCode.K).write("seed").type(KeyCode.ENTER);
    waitUntil(() -> window.label("goal-rules").endsWith("This course: seed 43."));
  }

  @Test
  void whatWasMovedIsSavedWithTheGoals() throws ScenarioException {
    change(() -> app.open(file));
    robot.type(KeyCode.F10).clickOn("#plan-add-box");
    Path copy = folder.resolve("copy.yaml");

    change(() -> app.save(copy));

    Scenario saved = ScenarioFile.read(copy);
    assertThat(saved.description().name()).isEqualTo(LocalizedText.of("Small slalom"));
    assertThat(saved.challenge().goals()).hasSize(2);
    assertThat(saved.config().arena().obstacles()).extracting("name").contains("pole", "box 1");
    assertThat(saved.config().starts().get(0).position()).isEqualTo(new Vec3(-2, 0.5, 0));
    assertThat(saved.config().starts().get(0).attitude().heading())
        .isCloseTo(Math.PI / 2, within(1e-9));
    assertThat(stage.getTitle()).isEqualTo("copy.yaml – Tello Simulator");
  }

  @Test
  void aFileThatCannotBeWrittenIsToldInTheLog() {
    change(() -> app.save(folder.resolve("missing").resolve("room.yaml")));

    waitUntil(() -> window.log().contains("could not be saved"));
    assertThat(window.log()).contains("there is no folder for");
    assertThat(stage.getTitle()).isEqualTo("Tello Simulator");
  }

  @Test
  void goalsAreTickedAndRestart() throws IOException {
    Files.writeString(
        file,
        """
        name: First flight
        time-factor: max
        drones:
          - {start: [0, 0], state-port: 9, video-port: 10}
        goals:
          - reach: {at: [0, 0, 30], radius: 10}
          - land: {at: [0, 0], radius: 20}
        in-order: true
        """);
    change(() -> app.open(file));
    robot.clickOn("#power");
    assertThat(robot.lookup("#goal-banner").query().isVisible()).isFalse();

    assertThat(fly("command", "takeoff", "land")).isEqualTo("ok");

    waitUntil(() -> window.label("goal-banner").startsWith("Reached in "));
    assertThat(robot.lookup("#goal-banner").query().isVisible()).isTrue();
    assertThat(ticked()).isEqualTo(2);
    assertThat(robot.lookup(".goal .mark").queryAllAs(Label.class))
        .as("the numbers that they have in the room")
        .extracting(Label::getText)
        .containsExactlyInAnyOrder("1", "2");

    project();
    assertThat(robot.lookup("#projector-goal-1").queryLabeled().getText()).isEqualTo("1");
    waitUntil(() -> tickedForTheClass(1) && tickedForTheClass(2));
    project();

    robot.clickOn("#goal-again");
    waitUntil(() -> ticked() == 0);
    assertThat(robot.lookup("#goal-banner").query().isVisible()).isFalse();
    assertThat(window.label("goal-time")).isEqualTo("Task 0.0 s");
  }

  @Test
  void aFailureIsToldWithItsReasonAndTheGoalsStayThere() throws IOException {
    openWithObstacleAhead();
    assertThat(detailsShown()).isTrue();

    fly("command", "takeoff", "forward 100");

    waitUntil(
        () -> window.label("goal-banner").equals("Failed: drone 1 touched the obstacle \"pole\""));
    assertThat(detailsShown()).isTrue();
    assertThat(window.label("goal-advice")).startsWith("The red mark shows where");
    assertThat(robot.lookup("#scenario-name").query().isVisible()).isTrue();

    robot.clickOn("#goal-fold").push(KeyCode.CONTROL, KeyCode.N);
    waitUntil(() -> !robot.lookup("#goal-banner").query().isVisible());
    assertThat(window.label("goal-advice")).isEmpty();
    assertThat(detailsShown()).as("somebody has folded them").isFalse();
  }

  @Test
  void whenTimeIsOverItSaysToFlyFaster() throws IOException {
    Files.writeString(file, SLALOM.replace("time-limit: 60", "time-limit: 1"));
    change(() -> app.open(file));
    robot.clickOn("#power");

    fly("command", "takeoff");

    waitUntil(() -> window.label("goal-banner").equals("Failed: time is over"));
    assertThat(window.label("goal-advice")).startsWith("Fly faster");
  }

  @Test
  void theGoalsAreFoldedWhileTheDronesFilmIsLarge() throws IOException {
    openWithObstacleAhead();
    assertThat(detailsShown()).isTrue();

    robot.type(KeyCode.DIGIT5);
    assertThat(detailsShown()).isFalse();

    robot.type(KeyCode.DIGIT5);
    assertThat(detailsShown()).isTrue();
  }

  private boolean detailsShown() {
    return robot.lookup("#goal-details").query().isVisible();
  }

  /**
   * Opens a scenario in which the first drone is on, and touches the pole if it moves forward by
   * 100 cm.
   */
  private void openWithObstacleAhead() throws IOException {
    Files.writeString(
        file,
        SLALOM
            .replace("time-limit: 60", "touch: forbidden")
            .replace("drones:", "time-factor: max\ndrones:")
            .replace("heading: 90", "heading: 0")
            .replace("at: [100, 0]", "at: [-150, 50]"));
    change(() -> app.open(file));
    robot.clickOn("#power");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          gate: {name: a, at: [0, 0], shape: ring, diameter: 90, centre: 99} | pass: {gate: a}
          id: 3, at: [0, 0]                                                  | land-on: {pad: 3}
          """)
  void whatAGoalNamesIsNotRemovedAndTheStatusSaysWhy(String piece, String goal) throws Exception {
    String there = (piece.startsWith("gate") ? "obstacles" : "pads") + ": [{" + piece + "}]";
    Files.writeString(
        file, there + "\ndrones: [{start: [-200, 0], state-port: 9}]\ngoals: [{" + goal + "}]\n");
    change(() -> app.open(file));
    robot.type(KeyCode.F10).clickOn("#plan-add-box").clickOn("#plan");

    robot.type(KeyCode.DELETE);

    assertThat(window.label("plan-status"))
        .isEqualTo("A goal refers to this: remove the goal first.");
    change(() -> app.save(file));
    assertThat(ScenarioFile.read(file).challenge().goals()).hasSize(1);

    robot.press(KeyCode.CONTROL).type(KeyCode.Z).release(KeyCode.CONTROL);
    assertThat(window.label("plan-status")).doesNotStartWith("A goal");
    change(() -> app.save(file));
    assertThat(Files.readString(file)).doesNotContain("box 1").contains(goal);
  }

  private long ticked() {
    return robot.lookup(".goal").queryAll().stream()
        .filter(goal -> goal.getPseudoClassStates().toString().contains("reached"))
        .count();
  }

  /** Sends commands to the first drone, one after another, and returns the last reply. */
  private String fly(String... commands) throws IOException {
    Pattern listening = Pattern.compile("drone 1 at 127.0.0.1:([1-9]\\d*)");
    waitUntil(() -> listening.matcher(app.ready()).find()); // the switch acts asynchronously
    Matcher port = listening.matcher(app.ready());
    assertThat(port.find()).isTrue();
    InetSocketAddress drone =
        new InetSocketAddress(AppFixture.LOOPBACK, Integer.parseInt(port.group(1)));
    try (DatagramSocket socket = new DatagramSocket(0, AppFixture.LOOPBACK)) {
      socket.setSoTimeout(20_000);
      String reply = "";
      for (String command : commands) {
        byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
        socket.send(new DatagramPacket(bytes, bytes.length, drone));
        DatagramPacket answer = new DatagramPacket(new byte[2048], 2048);
        socket.receive(answer);
        reply = new String(answer.getData(), 0, answer.getLength(), StandardCharsets.US_ASCII);
      }
      return reply;
    }
  }

  private boolean trailButton() {
    return robot.lookup("#show-trail").queryAs(ToggleButton.class).isSelected();
  }
}
