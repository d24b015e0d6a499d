package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.MenuButton;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.HBox;
import javafx.stage.Stage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.testfx.util.WaitForAsyncUtils;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.recording.RecordingFiles;
import tellosimulator.testing.CapturedLog;

/** The window records flights until the user disables recording. */
@Timeout(value = 180, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RecordedFlightsFxTest {

  private static final int PATIENCE_SECONDS = 60;

  @RegisterExtension private final AppFixture window = new AppFixture(Stage::new);

  @Test
  void aFlightIsRecordedUntilThatIsSwitchedOffWhichIsRemembered() throws Exception {
    CheckMenuItem item = item();
    assertThat(item.isSelected()).isTrue();
    window.app().switchAllOn();
    int port = Integer.parseInt(window.app().ready().replaceAll(".*:", ""));
    assertThat(List.of(ask("command", port), ask("takeoff", port))).containsExactly("ok", "ok");
    await(() -> recorded("run.json") && recorded("wire.jsonl"));

    change(() -> item.setSelected(false));

    RecordingFiles files = RecordingFiles.only(window.recordings());
    await(() -> files.run().containsKey("ended"));
    assertThat(files.events("command"))
        .extracting(event -> event.get("command"))
        .containsExactly("command", "takeoff");
    await(
        () ->
            Files.exists(window.settings())
                && Files.readString(window.settings()).contains("record-flights=false"));
  }

  @Test
  void theReportOfTheLastFlightIsOneClickAway() throws Exception {
    Button report = window.robot().lookup("#log-report").queryButton();
    assertThat(report.isDisabled()).as("no drone has flown").isTrue();
    window.app().switchAllOn();
    int port = Integer.parseInt(window.app().ready().replaceAll(".*:", ""));
    assertThat(List.of(ask("command", port), ask("takeoff", port))).containsExactly("ok", "ok");
    await(() -> recorded("wire.jsonl"));
    assertThat(report.isDisabled()).as("the flight is not over").isTrue();

    change(() -> item().setSelected(false)); // which ends the recording
    await(() -> !report.isDisabled());
    window.robot().clickOn(report);
    await(() -> window.openedReports().size() == 1 && !report.isDisabled());
    window.removeBrowser();
    window.robot().type(KeyCode.F4);
    window.robot().clickOn("#folded-report");
    await(() -> window.openedReports().size() == 2 && !report.isDisabled());

    Path file = RecordingFiles.only(window.recordings()).folder().resolve("report.html");
    assertThat(window.openedReports()).containsOnly(file);
    assertThat(Files.readString(file)).contains("takeoff").endsWith("</html>\n");
    await(
        () ->
            window.log().contains("The report of the last flight is open in the browser: " + file)
                && window.log().contains("No browser could be opened"));

    window.robot().type(KeyCode.F4);
    window.breakBrowser();
    try (CapturedLog log = CapturedLog.of(ErrorPolicy.class)) {
      window.robot().clickOn(report);
      await(
          () -> window.log().contains("could not be created because of an error in the simulator"));
      await(() -> !report.isDisabled());
      assertThat(log.next()).startsWith("The report of a flight failed; please report this");
    }
  }

  @Test
  void theLastFlightIsGradedWithAnAssignment() throws Exception {
    Path course = course("course", "reach: {at: [0, 0, 80], radius: 60, points: 5}");
    Path assignment = assignment("task", "course.yaml");
    change(() -> window.app().gradeFlight(assignment));
    await(() -> window.log().contains("There is no flight to grade with " + assignment));
    change(() -> window.app().open(course));
    window.app().switchAllOn();
    int port = Integer.parseInt(window.app().ready().replaceAll(".*:", ""));
    assertThat(List.of(ask("command", port), ask("takeoff", port))).containsExactly("ok", "ok");
    change(() -> item().setSelected(false)); // which ends the recording
    Button report = window.robot().lookup("#log-report").queryButton();
    await(() -> !report.isDisabled());

    change(() -> window.app().gradeFlight(assignment));
    await(() -> window.openedReports().size() == 1 && !report.isDisabled());

    Path file = RecordingFiles.only(window.recordings()).folder().resolve("feedback.html");
    assertThat(window.openedReports()).containsExactly(file);
    assertThat(Files.readString(file))
        .contains("5 of 5 points", "grade 6", "All goals were reached, after", "+5")
        .contains("href=\"course-1-1.html\"")
        .doesNotContain("The program");
    assertThat(file.resolveSibling("course-1-1.html")).exists();
    course("other", "land: {at: [100, 0], radius: 30}");
    Path another = assignment("another", "other.yaml");
    change(() -> window.app().gradeFlight(another));
    await(() -> window.log().contains("on none of the courses of " + another));
    change(() -> window.app().gradeFlight(course));
    await(() -> window.log().contains(course + ":1:1: "));
    assertThat(window.openedReports()).hasSize(1);
  }

  private Path course(String name, String goal) throws IOException {
    Path file = window.settings().resolveSibling(name + ".yaml");
    return Files.writeString(file, "goals:\n  - " + goal + "\n");
  }

  private Path assignment(String name, String course) throws IOException {
    Path file = window.settings().resolveSibling(name + ".yaml");
    String scale = "scale: {kind: range, from: 1, to: 6}";
    return Files.writeString(file, "name: Task\ncourses: [" + course + "]\n" + scale + "\n");
  }

  @Test
  void withoutRecordingsThereIsNoReport() throws Exception {
    HBox frame = (HBox) window.robot().lookup("#log-report").query().getParent();
    assertThat(tooltip(frame)).isEqualTo("The report appears here as soon as a flight is over.");

    change(() -> item().setSelected(false));

    await(() -> tooltip(frame).startsWith("There is no report, because flights are not recorded"));
  }

  /** Returns the tooltip that the toolkit stores for a node that is not a control. */
  private static String tooltip(Node node) {
    return ((Tooltip) node.getProperties().get("javafx.scene.control.Tooltip")).getText();
  }

  private boolean recorded(String file) throws IOException {
    return RecordingFiles.in(window.recordings()).stream().anyMatch(each -> each.has(file));
  }

  private CheckMenuItem item() {
    MenuButton settings = window.robot().lookup("#settings").queryAs(MenuButton.class);
    return settings.getItems().stream()
        .filter(item -> "record-flights".equals(item.getId()))
        .map(CheckMenuItem.class::cast)
        .findFirst()
        .orElseThrow();
  }

  private static void await(Callable<Boolean> condition) throws TimeoutException {
    WaitForAsyncUtils.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS, condition);
  }

  private static String ask(String text, int port) throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(PATIENCE_SECONDS * 1000);
      byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
      socket.send(new DatagramPacket(bytes, bytes.length, AppFixture.LOOPBACK, port));
      DatagramPacket reply = new DatagramPacket(new byte[100], 100);
      socket.receive(reply);
      return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII);
    }
  }
}
