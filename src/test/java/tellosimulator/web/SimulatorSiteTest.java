package tellosimulator.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.json.Json;
import tellosimulator.network.AddressPlan;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Gallery;
import tellosimulator.testing.HeadlessSimulators;

/** The page's server with a simulator, over real sockets. */
@Timeout(value = 40, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
final class SimulatorSiteTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  @TempDir private Path folder;
  private HeadlessSimulator simulator;
  private String link;
  private WebClient client;

  @BeforeEach
  void open() throws Exception {
    simulator =
        HeadlessSimulators.of(Gallery.find("gate-race").orElseThrow(), AddressPlan.ofMachine(3, 0));
    simulator.record(RecordingFolder.at(folder), List.of());
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    simulator.openWeb(
        new InetSocketAddress(LOOPBACK, 0), new PrintStream(out, true, StandardCharsets.UTF_8));
    simulator.switchOn();
    link = out.toString(StandardCharsets.UTF_8).strip();
    client = viewer("a");
  }

  @AfterEach
  void close() {
    simulator.close();
  }

  private WebClient viewer(String name) {
    int port = Integer.parseInt(link.replaceFirst(".*:([0-9]+)/.*", "$1"));
    return new WebClient(port, link.replaceFirst(".*\\?", "") + "&viewer=" + name);
  }

  private void act(String action) {
    var answer = client.post("do", action.replace('\'', '"'));
    assertThat(answer.body()).isEqualTo("{}");
    assertThat(answer.statusCode()).isEqualTo(200);
  }

  private String refused(String action) {
    var answer = client.post("do", action.replace('\'', '"'));
    assertThat(answer.statusCode()).isEqualTo(400);
    return answer.body();
  }

  private String awaitState(String part) throws IOException {
    return client.awaitEvent("state", data -> data.contains(part));
  }

  @SuppressWarnings("unchecked")
  private Map<String, Object> state() throws IOException {
    return (Map<String, Object>) Json.value(awaitState("time"));
  }

  @Test
  void theStateHasWhatThePageShows() throws IOException {
    assertThat(state())
        .containsEntry("number", 1L)
        .containsEntry("title", "Gate race")
        .containsEntry("paused", false)
        .containsEntry("factor", "1.0")
        .containsEntry("link", "ideal")
        .containsEntry("report", false)
        .containsEntry("demo", false);
    assertThat(awaitState("goals"))
        .contains("fly through gate A")
        .contains("\"word\":\"standing\"")
        .contains("\"battery\":100");
    assertThat(client.awaitEvent("begin", data -> true)).contains("is on and waits for commands");
  }

  @Test
  void theStateSpeaksGerman() throws IOException {
    try (InputStream stream = client.stream("state?language=de")) {
      assertThat(new String(stream.readNBytes(3000), StandardCharsets.UTF_8))
          .contains("Torrennen")
          .contains("durch Tor A fliegen");
    }
  }

  @Test
  void picturesAreAsLargeAsWanted() throws IOException {
    try (InputStream stream = client.stream("room?width=321&height=200")) {
      var picture = ImageIO.read(new ByteArrayInputStream(WebClient.picture(stream)));

      assertThat(picture.getWidth()).isEqualTo(320);
      assertThat(picture.getHeight()).isEqualTo(200);
    }
    try (InputStream stream = client.stream("room?width=9999&height=abc")) {
      var picture = ImageIO.read(new ByteArrayInputStream(WebClient.picture(stream)));

      assertThat(picture.getWidth()).isEqualTo(1280);
      assertThat(picture.getHeight()).isEqualTo(540);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "{'do': 'turn', 'right': 0.2, 'down': 0}",
        "{'do': 'zoom', 'factor': 0.5}",
        "{'do': 'look', 'view': 'top'}",
        "{'do': 'follow'}"
      },
      quoteCharacter = '`')
  void eachViewerHasACameraOfHisOwn(String action) throws IOException {
    act("{'do': 'pause', 'on': true}");
    try (InputStream mine = client.stream("room?width=320&height=180");
        InputStream other = viewer("b").stream("room?width=320&height=180")) {
      byte[] before = WebClient.picture(mine);
      assertThat(WebClient.picture(other)).isEqualTo(before);

      act(action);

      assertThat(WebClient.picture(mine)).isNotEqualTo(before);
      act("{'do': 'look', 'view': 'start'}");
      assertThat(WebClient.picture(mine)).isEqualTo(before);
    }
  }

  @Test
  void theFilmIsThatOfTheDrone() throws IOException {
    try (InputStream stream = client.stream("room?width=160&height=160&film=true")) {
      var picture = ImageIO.read(new ByteArrayInputStream(WebClient.picture(stream)));
      while (picture.getWidth() == 160) { // that of the room
        picture = ImageIO.read(new ByteArrayInputStream(WebClient.picture(stream)));
      }

      assertThat(picture.getWidth()).isEqualTo(960);
      assertThat(picture.getHeight()).isEqualTo(720);
    }
  }

  @Test
  void aViewerFliesByHand() throws IOException {
    act("{'do': 'fly', 'command': 'takeoff'}");
    awaitState("\"outcome\":\"done\",\"reply\":\"ok\"");
    act("{'do': 'fly', 'command': 'rc 0 60 0 0'}");
    act("{'do': 'fly', 'command': 'land'}");
    awaitState("\"text\":\"land\",\"outcome\":\"done\"");

    assertThat(client.awaitEvent("begin", data -> true)).contains("took off").contains("landed");
  }

  @Test
  void thePageSendsNoOtherCommands() {
    assertThat(refused("{'do': 'fly', 'command': 'reboot'}"))
        .isEqualTo("the page flies only with takeoff, land, stop, emergency, flip and rc");
  }

  @Test
  void theDemoFliesTheGoalsAndIsReported() throws IOException {
    act("{'do': 'time-factor', 'factor': '10'}");
    act("{'do': 'demo'}");
    awaitState("\"demo\":true");

    awaitState("\"status\":\"reached\"");
    awaitState("\"report\":true");

    assertThat(client.get("report").body()).contains("Gate race").contains("takeoff");
    List<String> names = new ArrayList<>();
    try (ZipInputStream zip =
        new ZipInputStream(new ByteArrayInputStream(client.bytes("recording.zip").body()))) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        names.add(entry.getName().replaceFirst("[^/]*/", ""));
      }
    }
    assertThat(names).contains("run.json");
  }

  @Test
  void aDemoEndsWhenAskedAgain() throws IOException {
    act("{'do': 'demo'}");
    awaitState("\"phase\":\"flying\"");

    assertThat(client.post("do", "{\"do\": \"demo\"}").statusCode()).isEqualTo(200);

    awaitState("\"demo\":false");
    awaitState("\"phase\":\"grounded\"");
  }

  @Test
  void aDemoEndsWithItsScenario() throws IOException {
    act("{'do': 'demo'}");
    awaitState("\"phase\":\"flying\"");

    act("{'do': 'open', 'scenario': 'empty-room'}");

    assertThat(awaitState("\"number\":2")).contains("\"demo\":false");
    act("{'do': 'fly', 'command': 'takeoff'}");
    awaitState("\"phase\":\"flying\"");
  }

  @Test
  void withoutAFlightThereIsNoReport() {
    var answer = client.get("report?language=de");

    assertThat(answer.statusCode()).isEqualTo(404);
    assertThat(answer.body()).startsWith("Noch kein Flug ist vorbei");
  }

  @Test
  void timePauses() throws IOException {
    act("{'do': 'pause', 'on': true}");
    String paused = awaitState("\"paused\":true");
    assertThat(awaitState("\"paused\":true")).isEqualTo(paused);

    act("{'do': 'pause', 'on': false}");
    awaitState("\"paused\":false");
  }

  @Test
  void whatProgramsCanAskPagesCanAskToo() throws IOException {
    act("{'do': 'wind', 'speed': 50, 'towards': -90}");
    awaitState("\"wind\":50,\"towards\":90");
    act("{'do': 'inject', 'fault': 'loss state 20% for 10s'}");
    awaitState("loss state 20% for 10s");
    act("{'do': 'power', 'drone': 1, 'on': false}");
    awaitState("\"phase\":\"off\"");
    act("{'do': 'power-all', 'on': true}");
    awaitState("\"phase\":\"grounded\"");
    assertThat(refused("{'do': 'inject', 'fault': 'bogus'}")).contains("expected one of");
    assertThat(refused("{'do': 'jump'}")).contains("there is no request `jump`");
    assertThat(refused("jump")).isNotEmpty();
    assertThat(refused("{'do': 'zoom', 'factor': 'x'}")).isEqualTo("factor must be a number");
    assertThat(refused("{'do': 'time-factor', 'factor': 'x'}"))
        .isEqualTo("factor must be a number or max");
  }

  @Test
  void aScenarioOfTheGalleryIsOpened() throws IOException {
    assertThat(WebClient.dense(client.get("gallery").body())).contains("\"name\":\"swarm-stage\"");
    try (InputStream room = client.stream("room?width=320&height=180")) {
      WebClient.picture(room);

      act("{'do': 'open', 'scenario': 'swarm-stage'}");

      room.readAllBytes(); // the stream of the old scenario ends
    }
    assertThat(awaitState("\"number\":2")).contains("Swarm stage").contains("\"drone\":3");
    client.post("do?drone=3", "{\"do\": \"fly\", \"command\": \"takeoff\"}");
    awaitState("\"drone\":3,\"text\":\"takeoff\"");
    assertThat(refused("{'do': 'open', 'scenario': '../x'}"))
        .isEqualTo("there is no such scenario");
  }

  @Test
  void aScenarioIsUploaded() throws IOException {
    String text =
        "name: <script>alert(1)</script>\nroom:\n  width: 400\n  depth: 400\n  height: 250\n";

    assertThat(client.post("scenario?name=mine.yaml", text).statusCode()).isEqualTo(200);

    assertThat(awaitState("\"number\":2")).contains("<script>alert(1)</script>"); // as text
  }

  @Test
  void aWrongScenarioIsExplainedAndNothingChanges() throws IOException {
    var answer = client.post("scenario?name=mine.yaml&language=de", "room:\n  widht: 400\n");

    assertThat(answer.statusCode()).isEqualTo(400);
    assertThat(answer.body()).contains("mine.yaml").contains("widht");
    assertThat(state()).containsEntry("number", 1L);
  }

  @Test
  void aScenarioWithPicturesOfTheServerIsRefused() throws IOException {
    var answer =
        client.post(
            "scenario?name=mine.yaml",
            "arena:\n  posters:\n  - {wall: front, picture: /etc/passwd, width: 50}\n");

    assertThat(answer.statusCode()).isEqualTo(400);
    assertThat(state()).containsEntry("number", 1L);
  }

  @Test
  void thereAreAtMostEightViewers() throws IOException {
    List<InputStream> streams = new ArrayList<>();
    for (int i = 1; i <= SimulatorSite.MOST_VIEWERS; i++) {
      InputStream stream = viewer("v" + i).stream("room?width=160&height=160");
      WebClient.picture(stream);
      streams.add(stream);
    }

    var answer = viewer("more").get("room");

    assertThat(answer.statusCode()).isEqualTo(503);
    assertThat(answer.body()).isEqualTo("There are 8 viewers already; close another page.");
    for (InputStream stream : streams) {
      stream.close();
    }
  }

  @Test
  void aNewStreamEndsTheOldOneOfThePage() throws IOException {
    try (InputStream old = client.stream("room?width=160&height=160")) {
      WebClient.picture(old);

      try (InputStream room = client.stream("room?width=320&height=180")) {
        WebClient.picture(room);

        old.readAllBytes(); // up to its end
      }
    }
  }
}
