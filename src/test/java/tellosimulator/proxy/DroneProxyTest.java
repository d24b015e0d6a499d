package tellosimulator.proxy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.LocalNetworks;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.DroneRecorder;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.RecordedCommand.Outcome;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFiles;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.testing.AppPackets;
import tellosimulator.testing.CapturedLog;

@Timeout(value = 120, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class DroneProxyTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  @TempDir private Path folder;

  private WireEnd drone;
  private WireEnd operator;
  private WireEnd states;
  private WireEnd pictures;
  private DroneProxy proxy;

  @BeforeEach
  void open() throws IOException {
    drone = WireEnd.loopback();
    operator = WireEnd.loopback();
    states = WireEnd.loopback();
    pictures = WireEnd.loopback();
    proxy = DroneProxy.start(plan(drone.address(), 0), recorder());
  }

  private ProxyPlan plan(InetSocketAddress to, int statePort) {
    return new ProxyPlan(
        to,
        AddressPlan.portPerDrone(1, List.of(LOOPBACK), 0),
        new StreamPorts(statePort, 0),
        new StreamPorts(states.port(), pictures.port()));
  }

  private DroneRecorder recorder() {
    return DroneRecorder.start(
        RecordingFolder.at(folder), LOOPBACK, List.of("proxy"), reason -> {});
  }

  @AfterEach
  void close() {
    proxy.close();
    List.of(drone, operator, states, pictures).forEach(WireEnd::close);
  }

  private InetSocketAddress here() {
    return proxy.addresses().get(0);
  }

  /** Returns the address that receives the drone's state. */
  private InetSocketAddress stateInlet() {
    return new InetSocketAddress(LOOPBACK, proxy.streamPorts().statePort());
  }

  private InetSocketAddress videoInlet() {
    return new InetSocketAddress(LOOPBACK, proxy.streamPorts().videoPort());
  }

  /** Sends a command that the drone receives and answers. */
  private void exchange(WireEnd by, String command, String reply) throws IOException {
    by.send(command, here());
    assertThat(drone.receive()).isEqualTo(command);
    drone.send(reply, drone.sender());
    assertThat(by.receive()).isEqualTo(reply);
    assertThat(by.sender()).isEqualTo(here());
  }

  @Test
  void commandsAndRepliesPassUnchangedAndInOrder() throws IOException {
    byte[] largest = new byte[65_507];
    new Random(1).nextBytes(largest);
    List<byte[]> datagrams =
        List.of(
            "command".getBytes(java.nio.charset.StandardCharsets.US_ASCII),
            new byte[0],
            new byte[] {0, (byte) 0xff, '\r', '\n', (byte) 0xc3, 0x28},
            largest,
            new byte[2000]);

    for (byte[] each : datagrams) {
      operator.send(each, here());
    }
    for (byte[] each : datagrams) {
      assertThat(drone.receiveBytes()).isEqualTo(each);
    }
    for (byte[] each : datagrams) {
      drone.send(each, drone.sender());
    }
    for (byte[] each : datagrams) {
      assertThat(operator.receiveBytes()).isEqualTo(each);
    }
  }

  @Test
  void repliesFindTheOperatorThatAsked() throws IOException {
    try (WireEnd second = WireEnd.loopback()) {
      operator.send("command", here());
      drone.receive();
      InetSocketAddress toFirst = drone.sender();
      second.send("battery?", here());
      assertThat(drone.receive()).isEqualTo("battery?");
      InetSocketAddress toSecond = drone.sender();

      drone.send("87\r\n", toSecond);
      drone.send("ok", toFirst);

      assertThat(second.receive()).isEqualTo("87\r\n");
      assertThat(operator.receive()).isEqualTo("ok");
    }
  }

  @Test
  void stateAndVideoComeFromWhereCommandsAreTaken() throws IOException {
    exchange(operator, "command", "ok");
    for (int i = 0; i < 100; i++) {
      drone.send("mid:-1;n:" + i + ";\r\n", stateInlet());
      drone.send(new byte[] {0, 0, 0, 1, (byte) i}, videoInlet());
    }

    for (int i = 0; i < 100; i++) {
      assertThat(states.receive()).isEqualTo("mid:-1;n:" + i + ";\r\n");
      assertThat(states.sender()).isEqualTo(here());
      assertThat(pictures.receiveBytes()).isEqualTo(new byte[] {0, 0, 0, 1, (byte) i});
      assertThat(pictures.sender()).isEqualTo(here());
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX) // other systems have no 127.0.0.2 by default
  void stateGoesToTheHostThatSentCommandLast() throws IOException {
    InetAddress other = InetAddress.getByName("127.0.0.2");
    try (WireEnd second = new WireEnd(new InetSocketAddress(other, 0));
        WireEnd secondStates = new WireEnd(new InetSocketAddress(other, states.port()))) {
      exchange(operator, "command", "ok");
      drone.send("to the first", stateInlet());
      assertThat(states.receive()).isEqualTo("to the first");

      exchange(second, "battery?", "50");
      drone.send("still to the first", stateInlet());
      assertThat(states.receive()).isEqualTo("still to the first");

      exchange(second, "command\r\n", "ok");
      drone.send("to the second", stateInlet());
      assertThat(secondStates.receive()).isEqualTo("to the second");
      assertThat(states.isSilent()).isTrue();
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void nobodyElseCanSpeakForTheDrone() throws IOException {
    exchange(operator, "command", "ok");
    try (WireEnd stranger =
        new WireEnd(new InetSocketAddress(InetAddress.getByName("127.0.0.3"), 0))) {
      stranger.send("forged", stateInlet());
      stranger.send("forged", drone.sender());
    }
    drone.send("true", stateInlet());
    drone.send("right", drone.sender());

    assertThat(states.receive()).isEqualTo("true");
    assertThat(operator.receive()).isEqualTo("right");
  }

  @Test
  void anAbsentDroneEndsNothing() throws Exception {
    InetSocketAddress place = drone.address();
    drone.close();
    try (CapturedLog log = CapturedLog.of(DroneWatch.class)) {
      for (int i = 0; i < 200; i++) {
        operator.send("command", here());
      }
      assertThat(log.next())
          .isEqualTo(
              "The drone at 127.0.0.1:"
                  + place.getPort()
                  + " does not answer: switch it on, and join its network");
      drone = new WireEnd(place);
      exchange(operator, "battery?", "87");
      assertThat(log.next()).isEqualTo("The drone at 127.0.0.1 answers again");
    }
  }

  @Test
  void anOperatorThatIsGoneEndsNothing() throws IOException {
    exchange(operator, "command", "ok");
    operator.close();
    states.close();
    for (int i = 0; i < 50; i++) {
      drone.send("late", drone.sender());
      drone.send("state", stateInlet());
    }
    operator = WireEnd.loopback();
    exchange(operator, "command", "ok");
  }

  @Test
  void moreOperatorsThanThereAreSocketsForAreServed() throws IOException {
    for (int i = 0; i < 200; i++) {
      try (WireEnd each = WireEnd.loopback()) {
        exchange(each, "battery? " + i, "ok " + i);
      }
    }
    exchange(operator, "command", "ok");
  }

  @Test
  void aPortThatAnotherProgramHasIsASentence() {
    assertThatThrownBy(() -> DroneProxy.start(plan(drone.address(), states.port()), recorder()))
        .isInstanceOf(PortTakenException.class)
        .hasMessageStartingWith("Port " + states.port() + " of 127.0.0.1 is not available")
        .hasMessageContaining("the drone sends its state there")
        .hasMessageContaining("--state-port");
  }

  /** Without being woken, the relay would block forever, because there is no next check. */
  @Test
  void closeDoesNotWaitForTheNextLook() throws IOException {
    Relay.Polling never = new Relay.Polling(LocalNetworks::look, TimeUnit.DAYS.toMillis(1));
    proxy.close();
    proxy = DroneProxy.start(plan(drone.address(), 0), recorder(), never);
    exchange(operator, "command", "ok");
    assertThat(List.of(operator.isSilent(), drone.isSilent())).as("it waits").containsOnly(true);

    InetSocketAddress before = here();
    proxy.close();

    try (WireEnd free = new WireEnd(before)) {
      assertThat(free.address()).isEqualTo(before);
    }
  }

  @Test
  void aFlightIsRecordedAsItPassed() throws Exception {
    exchange(operator, "command", "ok");
    exchange(operator, "sdk?", "20");
    operator.send("takeoff", here());
    assertThat(drone.receive()).isEqualTo("takeoff");
    drone.send("pitch:0;roll:0;yaw:3;vgx:0;vgy:0;vgz:-8;h:40;bat:87;\r\n", stateInlet());
    assertThat(states.receive()).contains("h:40");
    drone.send(new byte[] {0, 0, 0, 1, 0x41, 1, 2, 3}, videoInlet());
    pictures.receiveBytes();
    drone.send("ok", drone.sender());
    operator.receive();
    exchange(operator, "up 50", "error Motor stop");
    exchange(operator, "land", "ok");
    proxy.close();

    RecordingFiles files = RecordingFiles.only(folder);
    RecordedFlight flight = RecordedFlight.read(files.folder());
    assertThat(files.run())
        .containsEntry("realDrone", "127.0.0.1")
        .containsKeys("program", "begun", "started", "ended")
        .doesNotContainKeys("seed", "room");
    assertThat(flight.run().realDrone()).hasValue("127.0.0.1");
    assertThat(flight.commands())
        .extracting(RecordedCommand::text)
        .containsExactly("command", "sdk?", "takeoff", "up 50", "land");
    assertThat(flight.commands())
        .extracting(RecordedCommand::outcome)
        .containsExactly(
            Outcome.ANSWERED,
            Outcome.ANSWERED,
            Outcome.ANSWERED,
            Outcome.REFUSED,
            Outcome.ANSWERED);
    assertThat(files.wire("state"))
        .singleElement()
        .satisfies(line -> assertThat(line.get("to")).isEqualTo("127.0.0.1:" + states.port()));
    assertThat(files.wire("video"))
        .singleElement()
        .satisfies(line -> assertThat(line.get("size")).isEqualTo(8L));
    assertThat(files.has("flight.csv")).isTrue();
    assertThat(files.has("events.jsonl")).isFalse();
  }

  @Test
  void aSessionOfTheAppPassesWithItsVideo() throws Exception {
    int asked = pictures.port();
    operator.send(connection("conn_req:", asked), here());
    byte[] request = drone.receiveBytes();
    assertThat(request).isEqualTo(connection("conn_req:", videoInlet().getPort()));
    drone.send(connection("conn_ack:", videoInlet().getPort()), drone.sender());
    assertThat(operator.receiveBytes()).isEqualTo(connection("conn_ack:", asked));

    exchange(operator, AppPackets.TAKEOFF, AppPackets.TAKEOFF_DONE);
    drone.send(AppPackets.FLIGHT_DATA, drone.sender());
    assertThat(operator.receive()).isEqualTo(AppPackets.FLIGHT_DATA);
    drone.send(new byte[] {7, (byte) 0x80, 0, 0, 0, 1, 9}, videoInlet());
    assertThat(pictures.receiveBytes()).startsWith(7, 0x80, 0, 0, 0, 1, 9);
    proxy.close();

    RecordingFiles files = RecordingFiles.only(folder);
    assertThat(files.objects("wire.jsonl"))
        .filteredOn(line -> !line.get("kind").equals("video"))
        .extracting(line -> line.get("kind") + " " + line.get("words"))
        .containsExactly(
            "command conn_req (app)",
            "reply conn_ack (app)",
            "command takeoff (app)",
            "reply takeoff (app)",
            "state flight data (app)");
  }

  private static byte[] connection(String words, int port) {
    return (words + (char) (port & 0xff) + (char) (port >> 8))
        .getBytes(StandardCharsets.ISO_8859_1);
  }
}
