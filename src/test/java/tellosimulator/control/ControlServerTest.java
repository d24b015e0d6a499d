package tellosimulator.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.entry;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.junit.SimulatedDrone;
import tellosimulator.junit.TelloSimulator;
import tellosimulator.network.PortTakenException;

/** Sends each request over a real socket. */
@Timeout(60)
class ControlServerTest {

  private static final int PATIENCE_MS = 30_000;

  private final TelloSimulator simulator = TelloSimulator.builder().drones(2).video(false).start();
  private ControlServer server;
  private ControlClient client;

  @BeforeEach
  void open() throws IOException {
    server = new ControlServer(() -> new Requests(simulator), 0);
    client = new ControlClient(server.port(), server.token());
  }

  @AfterEach
  void close() throws IOException {
    client.close();
    server.close();
    simulator.close();
  }

  private static List<String> fly(SimulatedDrone drone, String... commands) throws IOException {
    List<String> replies = new ArrayList<>();
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(PATIENCE_MS);
      for (String command : commands) {
        send(socket, drone, command);
        DatagramPacket reply = new DatagramPacket(new byte[2048], 2048);
        socket.receive(reply);
        replies.add(new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII));
      }
    }
    return replies;
  }

  private static void send(DatagramSocket socket, SimulatedDrone drone, String command)
      throws IOException {
    byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
    socket.send(new DatagramPacket(bytes, bytes.length, drone.address()));
  }

  // --- requests ---

  @Test
  void dronesTellsWhereProgramsReachThem() throws IOException {
    List<Map<String, Object>> drones = client.objects("drones");

    SimulatedDrone second = simulator.drone(2);
    assertThat(drones).hasSize(2);
    assertThat(drones.get(1))
        .containsExactly(
            entry("drone", 2),
            entry("host", "127.0.0.1"),
            entry("commandPort", second.commandPort()),
            entry("statePort", second.statePort()),
            entry("videoPort", second.videoPort()));
  }

  @Test
  void truthTellsWhatADroneReallyDid() throws IOException {
    fly(simulator.drone(2), "command", "takeoff", "forward 100", "land");

    Map<String, Object> truth = client.object("truth", "\"drone\": 2");
    assertThat(truth)
        .containsEntry("landed", true)
        .containsEntry("flying", false)
        .containsEntry("crashed", false)
        .containsEntry("takeoffs", 1)
        .containsEntry("touched", List.of())
        .containsKeys("x", "y", "z", "height", "heading", "battery", "visited", "highest");
    assertThat((Double) truth.get("farthest")).isBetween(99.0, 101.0);
    assertThat((List<?>) truth.get("path")).hasSizeGreaterThan(20);
    assertThat(client.object("truth")).containsEntry("takeoffs", 0);
  }

  @Test
  void journalTellsWhatCameAndWhatBecameOfIt() throws IOException {
    fly(simulator.drone(), "command", "foward 100");

    List<Map<String, Object>> journal = client.objects("journal", "\"drone\": 1");
    assertThat(journal).hasSize(2);
    assertThat(journal.get(0))
        .containsEntry("text", "command")
        .containsEntry("outcome", "answered")
        .containsEntry("reply", "ok");
    assertThat(journal.get(1))
        .containsEntry("outcome", "refused")
        .containsEntry("explanation", "there is no such command, did you mean `forward 100`?")
        .containsKeys("sender", "seconds", "replies");
    assertThat(client.ask("explanation")).asString().contains("last command to drone 1", "foward");
  }

  @Test
  void faultsAreInjectedNamedAndCleared() throws IOException {
    client.ask("inject", "\"fault\": \"no-valid-imu drone 1\"");

    assertThat(client.list("faults")).containsExactly("no-valid-imu 10cm/s drone 1");
    assertThat(client.list("faults", "\"drone\": 2")).isEmpty();
    assertThat(fly(simulator.drone(), "command", "takeoff", "forward 50"))
        .last()
        .isEqualTo("error No valid imu");

    client.ask("clear-faults");
    client.ask("link", "\"preset\": \"lab\"");
    assertThat(client.list("faults")).isEmpty();
  }

  @Test
  void timeIsAdvancedThoughNobodyWaits() throws IOException {
    Map<String, Object> before = client.object("advance", "\"seconds\": 0");
    Map<String, Object> after = client.object("advance", "\"seconds\": 2.5");

    assertThat((Double) after.get("seconds") - (Double) before.get("seconds")).isBetween(2.4, 2.7);
  }

  @Test
  void aCommandAndTheEndOfAllMovementAreAwaited() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      send(socket, simulator.drone(), "command");
      client.ask("await", "\"command\": \"command\"");
      send(socket, simulator.drone(), "takeoff");
      Map<String, Object> takeoff =
          client.object("await", "\"command\": \"takeoff\", \"timeout\": 20");
      client.ask("await-still");

      assertThat(takeoff).containsEntry("reply", "ok");
      assertThat(client.object("truth")).containsEntry("flying", true);
      assertThat(client.error("await", "\"command\": \"land\", \"timeout\": 0.1"))
          .isEqualTo("drone 1: `land` did not come within 0.1 s");
    }
  }

  @Test
  void batteryPlacePowerAndWindAreAsInTheKit() throws IOException {
    client.ask("battery", "\"drone\": 2, \"percent\": 42");
    client.ask("place", "\"drone\": 2, \"x\": 100, \"y\": -50, \"heading\": 90");
    client.ask("wind", "\"speed\": 50, \"towards\": 90");

    assertThat(client.object("truth", "\"drone\": 2"))
        .containsEntry("battery", 42)
        .containsEntry("x", 100.0)
        .containsEntry("y", -50.0)
        .containsEntry("heading", 90.0)
        .containsEntry("start", List.of(100.0, -50.0, 0.0));

    client.ask("power", "\"drone\": 1, \"on\": false");
    assertThatThrownBy(() -> flyImpatiently(simulator.drone())).isInstanceOf(IOException.class);
    client.ask("power", "\"drone\": 1, \"on\": true");
    assertThat(fly(simulator.drone(), "command")).containsExactly("ok");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "inject|\"fault\": \"motor-stop\"",
        "inject|\"fault\": \"low-battery\"",
        "inject|\"fault\": \"overheat\"",
        "inject|\"fault\": \"silent-land\"",
        "inject|\"fault\": \"reboot\"",
        "battery|\"percent\": 4",
        "battery|\"percent\": 0"
      })
  void whatBringsADroneDownMovesUntilItLies(String act) throws IOException {
    fly(simulator.drone(), "command", "takeoff", "up 60");

    client.ask(act.substring(0, act.indexOf('|')), act.substring(act.indexOf('|') + 1));
    client.ask("await-still");

    Map<String, Object> truth = client.object("truth");
    assertThat(truth).containsEntry("flying", false);
    assertThat((Double) truth.get("height")).isBetween(-0.1, 0.1);
  }

  /** The second client advances the time by less, so its request is completed first. */
  @Test
  void timePassesForAllWhoWaitForIt() throws Exception {
    try (ControlClient other = new ControlClient(server.port(), server.token())) {
      other.send(other.request("advance", "\"seconds\": 600"));
      client.ask("advance", "\"seconds\": 1");

      Map<String, Object> answer = ControlClient.parsed(other.read());
      assertThat(answer).containsEntry("ok", true);
    }
  }

  @Test
  void timeThatWillNotPassIsToldAfterAReset() throws Exception {
    try (ControlClient other = new ControlClient(server.port(), server.token())) {
      client.ask("advance", "\"seconds\": 2");
      other.send(other.request("advance", "\"seconds\": 3600"));
      while (simulator.simulation().time().toSeconds() < 3) {
        Thread.onSpinWait(); // until it has begun
      }
      client.ask("reset");

      Map<String, Object> answer = ControlClient.parsed(other.read());
      assertThat(answer)
          .containsEntry("ok", false)
          .containsEntry("error", "the simulation was restarted before 3600.0 s had passed");
      Map<String, Object> again = client.object("advance", "\"seconds\": 2");
      assertThat((Double) again.get("seconds"))
          .as("a step may have passed since the reset")
          .isBetween(2.0, 2.01);
    }
  }

  private static void flyImpatiently(SimulatedDrone drone) throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(200);
      send(socket, drone, "command");
      socket.receive(new DatagramPacket(new byte[64], 64));
    }
  }

  @Test
  void resetWhileSomethingFliesBeginsAnew() throws IOException {
    client.ask("inject", "\"fault\": \"state-stopped\"");
    client.ask("battery", "\"percent\": 50");
    fly(simulator.drone(), "command", "takeoff");
    try (DatagramSocket socket = new DatagramSocket()) {
      send(socket, simulator.drone(), "forward 200"); // never ends

      client.ask("reset");
    }

    assertThat(client.object("truth"))
        .containsEntry("takeoffs", 0)
        .containsEntry("flying", false)
        .containsEntry("battery", 100)
        .containsEntry("z", 0.0);
    assertThat(client.list("faults")).isEmpty();
    assertThat(fly(simulator.drone(), "command", "takeoff", "land"))
        .containsExactly("ok", "ok", "ok");
    assertThat(client.objects("journal"))
        .extracting(entry -> entry.get("text"))
        .endsWith("command", "takeoff", "land")
        .hasSizeBetween(3, 4); // a datagram in transit may arrive after the reset
  }

  @Test
  void goalsAreToldAndAwaited() throws IOException {
    try (TelloSimulator race = TelloSimulator.start("table-landing");
        ControlServer other = new ControlServer(() -> new Requests(race), 0);
        ControlClient watcher = new ControlClient(other.port(), other.token())) {
      Map<String, Object> goals = watcher.object("goals");

      assertThat(goals).containsEntry("reached", false).containsEntry("done", List.of());
      assertThat((List<?>) goals.get("open")).isNotEmpty();
      assertThat(watcher.error("await-goals", "\"timeout\": 0.1"))
          .isEqualTo("the goals were not reached within 0.1 s");
    }
    assertThat(client.error("await-goals", "")).isEqualTo("the scenario has no goals to wait for");
  }

  @Test
  void twoClientsAreServedBesideEachOther() throws IOException {
    try (ControlClient other = new ControlClient(server.port(), server.token())) {
      client.send(client.request("await", "\"command\": \"command\""));

      assertThat(other.object("truth")).containsEntry("flying", false);
      fly(simulator.drone(), "command");

      assertThat(ControlClient.parsed(client.read())).containsEntry("ok", true);
    }
  }

  // --- refusals ---

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          {"id": 3, "do": "truth"}                     | the token is missing: it stands in the line that begins with `control:`
          {"id": 3, "token": "0a", "do": "truth"}      | the token is wrong: it stands in the line that begins with `control:`
          {"id": 3, "token": 7, "do": "reset"}         | the token is wrong: it stands in the line that begins with `control:`
          """)
  void aWrongTokenIsToldAndEndsTheConnection(String line, String sentence) throws IOException {
    assertThat(ControlClient.parsed(client.line(line)))
        .containsExactly(entry("id", 3), entry("ok", false), entry("error", sentence));
    assertThat(client.read()).isNull();

    try (ControlClient next = new ControlClient(server.port(), server.token())) {
      assertThat(next.list("drones")).hasSize(2);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "command", "takeoff", "{", "[]", "GET / HTTP/1.1", "\u0000\u00ff"})
  void garbageIsOneSentenceAndEndsNothing(String line) throws IOException {
    assertThat(ControlClient.parsed(client.line(line)))
        .containsEntry("id", null)
        .containsEntry("ok", false)
        .containsEntry(
            "error",
            "expected a JSON object such as {\"id\": 1, \"token\": \"…\", \"do\": \"truth\"}");

    assertThat(client.list("drones")).hasSize(2);
    assertThat(client.list("journal")).as("no command of a drone").isEmpty();
  }

  @Test
  void aLineThatIsTooLongIsSkipped() throws IOException {
    int most = ControlConnection.LONGEST_LINE;
    String start = client.request("battery", "\"percent\": \"");

    assertThat(ControlClient.parsed(client.line("x".repeat(1_000_000))))
        .containsEntry("error", "a request must have at most 65536 bytes, but this has more");
    assertThat(client.line("x".repeat(most + 1))).contains("at most 65536 bytes");
    assertThat(client.line(start.replace("}", "") + "x".repeat(most - start.length() - 1) + "\"}"))
        .contains("must be a number");
    assertThat(client.list("drones")).hasSize(2);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      textBlock =
          """
          trut     |                             | there is no request `trut`, did you mean truth?
          truth    | "dron": 1                   | truth has no parameter `dron`, did you mean drone?
          goals    | "quickly": true             | goals has no parameter `quickly`; it has none
          truth    | "drone": 3                  | there is no drone 3, the drones are 1 to 2
          truth    | "drone": 1.5                | drone of truth must be a drone's number, but is 1.5
          truth    | "drone": "one"              | drone of truth must be a drone's number, but is `one`
          battery  |                             | battery needs percent, a number
          battery  | "percent": "full"           | percent of battery must be a number, but is `full`
          battery  | "percent": 101              | battery is 101.0 %, but must be from 0 to 100
          place    | "x": 9000, "y": 0           | x 9000, y 0 cm is not in the room, where drone 1 should stand
          place    | "x": 0, "y": 0, "heading": 361 | heading is 361.0 degrees, but must be from -360 to 360
          wind     | "speed": -50                | speed is -50.0 cm/s, but must be from 0 to 2000
          wind     | "speed": 2001               | speed is 2001.0 cm/s, but must be from 0 to 2000
          wind     | "speed": 5, "towards": -400 | towards is -400.0 degrees, but must be from -360 to 360
          power    | "on": 1                     | on of power must be true or false, but is 1
          await    |                             | await needs command, a text
          await    | "command": 1                | command of await must be a text, but is 1
          advance  | "seconds": -1               | seconds of advance must be from 0 to 3600 seconds, but is -1.0
          advance  | "seconds": 1e300            | seconds of advance must be from 0 to 3600 seconds, but is 1.0E300
          truth    | "drone": [1]                | drone must be a text, a number, true or false, but is something nested
          """)
  void whatMakesNoSenseIsOneSentence(String name, String parameters, String sentence)
      throws IOException {
    assertThat(client.error(name, parameters == null ? "" : parameters)).isEqualTo(sentence);
    assertThat(client.list("drones")).hasSize(2);
  }

  @Test
  void aRequestWithoutAnythingToDoNamesWhatThereIs() throws IOException {
    String nothing = "{\"id\": \"a\", \"token\": \"" + server.token() + "\"}";

    assertThat(ControlClient.parsed(client.line(nothing)))
        .containsEntry("id", "a")
        .extractingByKey("error")
        .asString()
        .startsWith("the request needs do, one of drones, truth, journal");
    assertThat(client.error("fly-me-to-the-moon", "")).contains("; there are drones, truth");
    assertThat(client.error("inject", "\"fault\": \"no-vaild-imu\"")).contains("no-valid-imu");
    assertThat(client.error("link", "\"preset\": \"labb\"")).contains("lab");
  }

  @Test
  void oneClientTooManyIsToldSo() throws IOException {
    List<ControlClient> clients = new ArrayList<>();
    try {
      for (int i = 1; i < ControlServer.MOST_CONNECTIONS; i++) {
        clients.add(new ControlClient(server.port(), server.token()));
      }
      try (ControlClient last = new ControlClient(server.port(), server.token())) {
        assertThat(last.read()).contains("there are 8 connections already; close one of them");
        assertThat(last.read()).isNull();
      }
      assertThat(client.list("drones")).hasSize(2);
    } finally {
      for (ControlClient one : clients) {
        one.close();
      }
    }
  }

  @Test
  void aPortThatIsTakenIsASentence() {
    assertThatThrownBy(() -> new ControlServer(() -> new Requests(simulator), server.port()))
        .isInstanceOf(PortTakenException.class)
        .message()
        .startsWith("Port " + server.port() + " of 127.0.0.1 is not available (")
        .endsWith("): choose another one with --control, or 0 for a free one.");
  }

  @Test
  void theEndOfTheServerEndsItsConnections() throws IOException {
    assertThat(server.line())
        .isEqualTo("control: 127.0.0.1:" + server.port() + " token " + server.token());
    assertThat(server.token()).matches("[0-9a-f]{32}");
    client.ask("drones");

    server.close();

    assertThat(client.read()).isNull();
    assertThatThrownBy(() -> new ControlClient(server.port(), server.token()).close())
        .isInstanceOf(IOException.class);
  }

  @Test
  void thePageNamesEachRequest() throws IOException {
    String page = Files.readString(Path.of("docs", "testing.md"));

    assertThat(new Requests(simulator).names())
        .hasSizeGreaterThan(15)
        .allSatisfy(name -> assertThat(page).contains("| `" + name + "` |"));
  }
}
