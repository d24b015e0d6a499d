package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javafx.scene.control.Label;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;

/** Unsaved changes of a scenario are detected, saved, and not lost without a question. */
class UnsavedEditsFxTest {

  private static final String SLALOM =
      """
      # handed out in May
      name: Small slalom
      teaches: to fly around things
      room: {width: 400, depth: 600, height: 250}
      obstacles:
        - cylinder: {name: pole, at: [100, 0], radius: 10, height: 200}   # wood
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
  void editsAreMarkedAndControlSSavesThemToTheirFile() throws Exception {
    openWithBox();

    assertThat(stage.getTitle()).isEqualTo("* slalom.yaml – Tello Simulator");

    control(KeyCode.S);

    waitUntil(() -> stage.getTitle().equals("slalom.yaml – Tello Simulator"));
    List<String> lines = new ArrayList<>(Files.readAllLines(file));
    assertThat(lines.removeIf(line -> line.startsWith("  - box: {name: box 1, at: ["))).isTrue();
    assertThat(lines).as("all other lines").isEqualTo(SLALOM.lines().toList());
    assertThat(asked()).isFalse();
  }

  @Test
  void whatWasUndoneNeedsNoSaving() {
    openWithBox();

    control(KeyCode.Z);

    waitUntil(() -> stage.getTitle().equals("slalom.yaml – Tello Simulator"));
    control(KeyCode.Q);
    waitUntil(() -> !stage.isShowing());
  }

  @Test
  void closingAsksBeforeEditsAreLost() {
    openWithBox();

    control(KeyCode.Q);
    waitUntil(this::asked);
    assertThat(robot.lookup("#question-page .title-3").queryAs(Label.class).getText())
        .isEqualTo("Save the changes of " + file + "?");
    robot.clickOn("#go-on");
    assertThat(stage.isShowing()).isTrue();

    control(KeyCode.Q);
    waitUntil(this::asked);
    robot.clickOn("#do-not-save");
    waitUntil(() -> !stage.isShowing());
    assertThat(file).hasContent(SLALOM);
  }

  @Test
  void openingAnotherOneAsksAndSaves() throws Exception {
    openWithBox();

    change(() -> app.openKnown("wind"));
    waitUntil(this::asked);
    robot.clickOn("#save");

    waitUntil(() -> stage.getTitle().equals("Wind – Tello Simulator"));
    assertThat(Files.readString(file)).contains("# wood\n  - box: {name: box 1");
  }

  @Test
  void whatAnotherProgramHasWrittenIsNotOverwrittenSilently() throws Exception {
    openWithBox();
    String foreign = SLALOM.replace("in May", "in June");
    Files.writeString(file, foreign);

    change(() -> app.save(file));

    waitUntil(this::asked);
    assertThat(file).hasContent(foreign);
    robot.clickOn("#overwrite-it");
    assertThat(Files.readString(file)).contains("in May").contains("box 1");
  }

  private void openWithBox() {
    change(() -> app.open(file));
    robot.type(KeyCode.F10).clickOn("#plan-add-box");
    waitUntil(() -> stage.getTitle().startsWith("* "));
  }

  private boolean asked() {
    return robot.lookup("#question-page").tryQuery().isPresent();
  }

  private void control(KeyCode key) {
    robot.press(KeyCode.CONTROL).type(key).release(KeyCode.CONTROL);
  }
}
