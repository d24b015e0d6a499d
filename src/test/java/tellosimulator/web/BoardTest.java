package tellosimulator.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.AddressPlan;
import tellosimulator.pilot.OperatorSocket;
import tellosimulator.scenario.Gallery;
import tellosimulator.testing.HeadlessSimulators;

/** The teacher's board with simulators, over real sockets. */
@Timeout(value = 40, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
final class BoardTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final String ID = "0123456789abcdef0123456789abcdef";

  private WebServer server;
  private WebClient teacher;
  private WebClient student;
  private URI board;

  @BeforeEach
  void open() throws Exception {
    server = WebServer.board(new InetSocketAddress(LOOPBACK, 0));
    String link = server.lines().get(0);
    board = URI.create(server.lines().get(1).replaceFirst("board: ", ""));
    teacher = new WebClient(server.port(), link.replaceFirst(".*\\?", ""));
    student = new WebClient(server.port(), board.getQuery());
  }

  @AfterEach
  void close() {
    server.close();
  }

  private String awaitState(String part) throws IOException {
    return teacher.awaitEvent("state", data -> data.contains(part));
  }

  private String report(String id, String line) {
    return WebClient.dense(student.post("seat?id=" + id, line).body());
  }

  private static HeadlessSimulator simulator() {
    return HeadlessSimulators.of(
        Gallery.find("gate-race").orElseThrow(), AddressPlan.of(List.of(LOOPBACK), 0));
  }

  @Test
  void simulatorsAppearWithTheirPictureAndWhatFailed() throws Exception {
    try (HeadlessSimulator simulator = simulator()) {
      simulator.switchOn();
      BoardReporter reporter = BoardReporter.start(simulator, board, "Ada", "Red");
      try (OperatorSocket operator =
          OperatorSocket.open(simulator.current().simulation().addresses(1).get(0))) {
        awaitState("\"name\":\"Ada\"");
        var picture =
            ImageIO.read(new ByteArrayInputStream(teacher.bytes("picture?seat=1").body()));
        assertThat(picture.getWidth()).isEqualTo(480);

        operator.send("command");
        operator.send("forward 9");

        assertThat(awaitState("\"failed\":\"forward 9 "))
            .contains("\"team\":\"Red\"")
            .contains("\"title\":\"Gate race\"")
            .contains("\"operator\":\"127.0.0.1\"")
            .contains("\"goals\":4");
      } finally {
        reporter.close();
      }
      awaitState("\"gone\":true");
    }
  }

  @Test
  void theTeacherStopsAndStartsAll() throws Exception {
    try (HeadlessSimulator simulator = simulator()) {
      simulator.switchOn();
      BoardReporter reporter = BoardReporter.start(simulator, board, "Ada", "");
      try {
        awaitState("Ada");

        assertThat(teacher.post("do", "{\"do\": \"pause\", \"on\": true}").statusCode())
            .isEqualTo(200);
        while (!simulator.current().simulation().snapshot().clock().paused()) {
          Thread.onSpinWait();
        }
        teacher.post("do", "{\"do\": \"pause\", \"on\": false}");
        teacher.post("do", "{\"do\": \"power-all\", \"on\": false}");
        while (simulator.current().simulation().snapshot().drones().get(0).state().phase()
            != FlightPhase.OFF) {
          Thread.onSpinWait();
        }
        double before = simulator.current().simulation().snapshot().time().seconds();
        teacher.post("do", "{\"do\": \"course\", \"seed\": 42}"); // the same: all courses are
        while (simulator.current().simulation().snapshot().time().seconds() > before) {
          Thread.onSpinWait();
        }
        assertThat(simulator.current().number()).isEqualTo(1);
      } finally {
        reporter.close();
      }
    }
  }

  @Test
  void aReportIsAnsweredWithTheLanguageAndTheOrders() throws IOException {
    assertThat(report(ID, "{\"name\": \"Ada\"}")).isEqualTo("{\"language\":\"en\",\"orders\":[]}");
    teacher.post("do", "{\"do\": \"reset\"}");
    teacher.post("do", "{\"do\": \"reset\"}");

    assertThat(taken("{\"name\": \"Ada\"}")).contains("\"orders\":[{\"do\":\"reset\"}]");
  }

  @Test
  void ofSeveralOrdersOfAKindTheLastCounts() throws IOException {
    report(ID, "{}");
    teacher.post("do", "{\"do\": \"pause\", \"on\": true}");
    teacher.post("do", "{\"do\": \"pause\", \"on\": false}");
    teacher.post("do", "{\"do\": \"course\", \"seed\": 1}");
    teacher.post("do", "{\"do\": \"course\", \"seed\": 2}");

    assertThat(taken("{}"))
        .contains("\"orders\":[{\"do\":\"pause\",\"on\":false},{\"do\":\"course\",\"seed\":2}]");
  }

  @Test
  void afterAResetResultsNoLongerCount() throws IOException {
    report(ID, "{\"points\": 10}");
    teacher.post("do", "{\"do\": \"reset\"}");
    taken("{\"points\": 10}");
    taken("{\"points\": 0}");

    assertThat(awaitState("ranking")).doesNotContain("\"points\":10");
  }

  /** Reports until it is not too soon. */
  private String taken(String line) {
    String answer = report(ID, line);
    while (answer.equals("{}")) {
      answer = report(ID, line);
    }
    return answer;
  }

  @Test
  void theLeaderboardHasTheBestFirst() throws IOException {
    report(ID, "{\"name\": \"Ada\", \"points\": 3}");
    report(ID.replace('0', '1'), "{\"name\": \"Bob\", \"points\": 5}");

    assertThat(awaitState("Bob")).containsSubsequence("ranking", "Bob", "Ada");
  }

  @Test
  void theTokenOfTheClassOpensNothingElse() {
    assertThat(student.get("").statusCode()).isEqualTo(403);
    assertThat(student.get("state").statusCode()).isEqualTo(403);
    assertThat(student.get("seat").statusCode()).isEqualTo(403);
    assertThat(student.post("do", "{\"do\": \"reset\"}").statusCode()).isEqualTo(403);
    assertThat(student.post("seat/do", "{\"do\": \"reset\"}").statusCode()).isEqualTo(403);
    assertThat(new WebClient(server.port(), "class=wrong").post("seat?id=" + ID, "{}").statusCode())
        .isEqualTo(403);
  }

  @Test
  void theBoardAsksForNothingElse() {
    assertThat(teacher.post("do", "{\"do\": \"inject\", \"fault\": \"x\"}").statusCode())
        .isEqualTo(400);
    assertThat(teacher.post("do", "{\"do\": \"open\"}").statusCode()).isEqualTo(400);
  }

  @Test
  void whatAStudentSendsIsOnlyText() throws IOException {
    assertThat(student.post("seat?id=x", "{}").statusCode()).isEqualTo(400);
    assertThat(student.post("seat?id=" + ID, "no report").statusCode()).isEqualTo(400);
    assertThat(student.post("seat?id=" + ID, new byte[WebRequest.MOST_BYTES + 1]).statusCode())
        .isEqualTo(400);
    assertThat(student.post("seat?id=" + ID, "{}\n<script>").body())
        .isEqualTo("the picture is not a small JPEG file");
    report(ID, "{\"name\": \"<img src=x onerror=alert(1)>\", \"goals\": \"many\"}");

    assertThat(awaitState("onerror")).contains("\"goals\":0.0");
    assertThat(teacher.get("picture?seat=1").headers().map())
        .containsEntry("content-type", List.of("image/jpeg"))
        .containsEntry("x-content-type-options", List.of("nosniff"));
  }

  @Test
  void thereIsPlaceForAHundredSimulators() {
    IntStream.range(0, 100).parallel().forEach(i -> report(String.format("%032x", i), "{}"));

    assertThat(student.post("seat?id=" + ID, "{}").body())
        .isEqualTo("There are 100 simulators already.");
  }
}
