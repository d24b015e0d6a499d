package tellosimulator.protocol.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.command.WireText;
import tellosimulator.fault.Fault;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.AppPackets;
import tellosimulator.testing.SteppedDrone;

class AppProtocolTest {

  private static final int ASK = 0x48;
  private static final int SET = 0x68;
  private static final int SILENT = 0x60;
  private static final InetSocketAddress STRANGER = SteppedDrone.address("192.168.10.3", 9000);

  private SteppedDrone drone = SteppedDrone.of(Profile.EDU, Behavior.REPORT);
  private int sequence;

  @BeforeEach
  void connect() {
    drone.send("conn_req:\u0096\u0017");
  }

  private void send(int kind, int id, int... payload) {
    send(SteppedDrone.CLIENT, kind, id, payload);
  }

  private void send(InetSocketAddress client, int kind, int id, int... payload) {
    byte[] bytes = new byte[payload.length];
    for (int i = 0; i < payload.length; i++) {
      bytes[i] = (byte) payload[i];
    }
    sequence++;
    drone.send(client, WireText.decode(new Packet(kind, id, sequence, bytes).bytes()));
  }

  private void sticks(String hex) {
    byte[] payload = HexFormat.of().parseHex(hex.replace(" ", "") + "0000000000");
    drone.send(WireText.decode(new Packet(SILENT, 0x50, 0, payload).bytes()));
  }

  private static Packet packet(SteppedDrone.Sent sent) {
    return Packet.parse(WireText.encode(sent.text())).orElseThrow();
  }

  private Stream<Packet> notifications(int id) {
    return Stream.concat(drone.stateLines().stream(), drone.replies().stream())
        .filter(sent -> sent.text().charAt(0) == 0xcc)
        .map(AppProtocolTest::packet)
        .filter(one -> one.kind() == Packet.NOTIFICATION && one.id() == id);
  }

  private Packet lastReply() {
    List<SteppedDrone.Sent> replies = drone.replies();
    return packet(replies.get(replies.size() - 1));
  }

  private ByteBuffer flightData() {
    List<Packet> all = notifications(0x56).toList();
    return ByteBuffer.wrap(all.get(all.size() - 1).payload()).order(ByteOrder.LITTLE_ENDIAN);
  }

  private List<String> received() {
    List<String> texts = new ArrayList<>();
    for (SimEvent event : drone.events()) {
      if (event instanceof SimEvent.CommandReceived received) {
        texts.add(received.request().text());
      }
    }
    return texts;
  }

  // --- session ---

  @Test
  void aConnectionIsAcknowledgedWithTheSameTwoBytes() {
    assertThat(drone.replies()).hasSize(1);
    assertThat(drone.replies().get(0).text()).isEqualTo("conn_ack:\u0096\u0017");
    assertThat(drone.link().app()).isTrue();
    assertThat(drone.link().videoPort()).isEqualTo(6038);
  }

  @Test
  void videoBeginsWithTheNextPacketOrALittleLater() {
    drone.advance(0.4);
    assertThat(drone.state().video().on()).isFalse();
    drone.advance(0.2);
    assertThat(drone.state().video().on()).isTrue();

    drone.send("conn_req:\u0096\u0017");
    int starts = drone.state().video().starts();
    send(SILENT, 0x25);
    drone.advance(0.1);
    assertThat(drone.state().video().starts()).isEqualTo(starts + 1);
  }

  /** A connection request with a forged sender must not make the drone an amplifier. */
  @Test
  void beforeTheNextPacketAConnectionRequestCausesLittleTraffic() {
    drone.advance(0.5);

    int bytes =
        Stream.concat(drone.replies().stream(), drone.stateLines().stream())
            .mapToInt(sent -> sent.text().length())
            .sum();
    assertThat(bytes).isLessThan(1000);
    assertThat(drone.state().video().on()).isFalse();
  }

  @ParameterizedTest
  @ValueSource(strings = {"conn_req:", "conn_req:x", "conn_req:123"})
  void aRequestWithoutAPortIsIgnoredAndSaidSo(String request) {
    int replies = drone.replies().size();
    drone.send(request);

    assertThat(drone.replies()).hasSize(replies);
    assertThat(drone.events())
        .anyMatch(event -> event.line().contains("there must be two bytes with the video port"));
  }

  @Test
  void packetsBeforeAConnectionHaveNoEffect() {
    SteppedDrone fresh = SteppedDrone.of(Profile.EDU, Behavior.REPORT);

    fresh.send(WireText.decode(new Packet(SET, 0x54, 1, new byte[0]).bytes()));
    fresh.advance(1);

    assertThat(fresh.replies()).isEmpty();
    assertThat(fresh.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void commandEndsTheNotificationsUntilTheDroneIsSwitchedOff() {
    drone.advance(1);
    assertThat(drone.ask("command")).isEqualTo("ok");
    int before = (int) notificationsSoFar();
    drone.advance(1);

    assertThat(notificationsSoFar()).isEqualTo(before);
    assertThat(drone.stateLines()).anyMatch(line -> line.text().startsWith("mid:"));
    drone.send("conn_req:\u0096\u0017");
    assertThat(drone.link().app()).isFalse();

    drone.control(new Control.Power(1, false));
    drone.control(new Control.Power(1, true));
    drone.send("conn_req:\u0096\u0017");
    assertThat(drone.link().app()).isTrue();
  }

  private long notificationsSoFar() {
    return drone.stateLines().stream().filter(one -> one.text().charAt(0) == 0xcc).count();
  }

  @Test
  void textsAreAnsweredWhileConnected() {
    assertThat(drone.ask("battery?")).isEqualTo("100\r\n");
    drone.advance(1);
    assertThat(drone.stateLines()).noneMatch(line -> line.text().startsWith("mid:"));
  }

  @Test
  void anotherHostHasNoEffect() {
    send(STRANGER, SET, 0x54);
    drone.send(STRANGER, "conn_req:\u0096\u0017");
    drone.advance(1);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(drone.link().operator().orElseThrow().address()).isEqualTo(SteppedDrone.CLIENT);
  }

  @Test
  void theSsidIsAnsweredInASessionOfTextsToo() {
    SteppedDrone text = SteppedDrone.of(Profile.EDU, Behavior.REPORT);
    text.ask("command");
    text.send(WireText.decode(new Packet(ASK, 0x11, 9, new byte[0]).bytes()));

    Packet answer = packet(text.replies().get(1));
    assertThat(answer.kind()).isEqualTo(0x90);
    assertThat(new String(answer.payload(), 2, answer.payload()[1], StandardCharsets.US_ASCII))
        .startsWith("TELLO-");
  }

  @Test
  void anAcknowledgementCanBeLost() {
    drone.control(new Control.InjectFault(Fault.of("conn-ack-lost")));
    int replies = drone.replies().size();
    drone.send("conn_req:\u0096\u0017");
    assertThat(drone.replies()).hasSize(replies);
    assertThat(drone.link().app()).isTrue();

    drone.control(new Control.ClearFaults());
    drone.send("conn_req:\u0096\u0017");
    assertThat(drone.replies()).hasSize(replies + 1);
  }

  @Test
  void withoutPowerThereIsNoSession() {
    drone.advance(1);
    drone.control(new Control.Power(1, false));
    long before = notificationsSoFar();
    drone.control(new Control.Power(1, true));
    drone.advance(2);
    send(SET, 0x54);
    drone.advance(2);

    assertThat(notificationsSoFar()).isEqualTo(before);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void afterAResetTheSessionGoesOn() {
    takeOff();
    sticks(sticksOf(0, 1, 0, 0));
    drone.control(new Control.Reset(1));
    drone.advance(2);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);

    takeOff();
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
    assertThat(drone.state().motion().velocity().norm()).isLessThan(0.01);
  }

  @Test
  void anotherHostConnectsWhenTheDroneIsFree() {
    drone.control(new Control.Release(1));
    drone.send(STRANGER, "conn_req:g+");

    assertThat(drone.link().operator().orElseThrow().address()).isEqualTo(STRANGER);
    assertThat(drone.link().videoPort()).isEqualTo(11111);
  }

  /** The same packets at the same moments cause the same bytes. */
  @Test
  void aSessionIsDeterministic() {
    assertThat(flownAgain()).isEqualTo(flownAgain()).hasSizeGreaterThan(200);
  }

  private static List<SteppedDrone.Sent> flownAgain() {
    AppProtocolTest flight = new AppProtocolTest();
    flight.drone = SteppedDrone.of(Profile.EDU, Behavior.MEASURED);
    flight.connect();
    flight.send(0x50, 0x1050, 0x2c, 0x43);
    flight.takeOff();
    for (int i = 0; i < 40; i++) {
      flight.sticks(sticksOf(0.3, 0.5, 0.1, 0.025 * i));
      flight.drone.advance(0.05);
    }
    return Stream.concat(flight.drone.replies().stream(), flight.drone.stateLines().stream())
        .toList();
  }

  // --- flight ---

  @Test
  void aTakeoffIsAnsweredAtOnceAndFlown() {
    send(SET, 0x54);

    assertThat(lastReply().kind()).isEqualTo(0xb0);
    assertThat(lastReply().sequence()).isEqualTo(sequence);
    assertThat(lastReply().payload()).containsExactly(0);
    drone.advance(5);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
    assertThat(received()).containsExactly("conn_req (app)", "takeoff (app)");

    assertThat(drone.state().motion().position().z()).isGreaterThan(0.2);
    send(SET, 0x55, 0);
    send(SET, 0x55, 0);
    assertThat(lastReply().payload()).containsExactly(0);
    drone.advance(5);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  /** CTello sends orders two to four times. */
  @Test
  void aRepeatedOrderIsAcceptedAtAnyTime() {
    for (int i = 0; i < 20; i++) {
      send(SET, 0x54);
      assertThat(lastReply().payload()).containsExactly(0);
      drone.advance(0.2);
    }
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
    for (int i = 0; i < 20; i++) {
      send(SET, 0x55, 0);
      assertThat(lastReply().payload()).containsExactly(0);
      drone.advance(0.2);
    }
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void landingWorksRightAfterATakeoff() {
    send(SET, 0x54);
    send(SET, 0x55, 0);
    drone.advance(8);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void aRefusedTakeoffIsAnsweredWithOne() {
    drone.control(new Control.SetBattery(1, 5));

    send(SET, 0x54);

    assertThat(lastReply().payload()).containsExactly(1);
    drone.advance(2);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void aLandingIsStopped() {
    send(SET, 0x54);
    drone.advance(5);
    sticks("00 04 20 a5 01 08"); // up
    drone.advance(1);
    send(SET, 0x55, 0);
    drone.advance(0.6);
    send(SET, 0x55, 1);
    drone.advance(5);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
  }

  @ParameterizedTest
  @CsvSource({
    "00 a4 34 00 01 08, 1, 0, 0, 0",
    "94 06 20 00 01 08, 0, -1, 0, 0",
    "00 04 20 a5 01 08, 0, 0, 1, 0",
    "00 04 20 00 29 0d, 0, 0, 0, -1"
  })
  void sticksMoveTheDroneAndAreLetGo(String hex, int x, int y, int z, int heading) {
    send(SET, 0x54);
    drone.advance(5);
    double before = drone.state().motion().attitude().heading();
    var start = drone.state().motion().position();
    for (int i = 0; i < 10; i++) {
      sticks(hex);
      drone.advance(0.05);
    }
    var moved = drone.state().motion().velocity();
    drone.advance(4);

    assertThat(sign(moved.x())).isEqualTo(x);
    assertThat(sign(moved.y())).isEqualTo(y);
    assertThat(sign(moved.z())).isEqualTo(z);
    assertThat(sign(drone.state().motion().attitude().heading() - before)).isEqualTo(heading);
    assertThat(drone.state().motion().velocity().norm()).isLessThan(0.05);
    assertThat(drone.state().motion().position().distanceTo(start)).isLessThan(2);
  }

  private static int sign(double value) {
    return Long.signum(Math.round(value * 10));
  }

  @Test
  void aDroneThatHearsNothingLandsAfterAQuarterOfAMinute() {
    send(SET, 0x54);
    drone.advance(14);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);

    drone.advance(12);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @ParameterizedTest
  @CsvSource({"0, f", "1, l", "2, b", "3, r", "4, f", "5, b", "6, b", "7, f"})
  void flipsAreFlown(int number, String letter) {
    send(SET, 0x54);
    drone.advance(5);

    send(0x70, 0x5c, number);

    assertThat(lastReply().payload()).containsExactly(0);
    assertThat(received()).endsWith("flip " + letter + " (app)");
  }

  @Test
  void smartVideoTurnsOnce() {
    send(SET, 0x54);
    drone.advance(5);
    send(SET, 0x80, (1 << 2) | 1);
    drone.advance(2);
    assertThat(drone.state().motion().rate().norm()).isGreaterThan(0.1);
    drone.advance(15);

    assertThat(drone.state().motion().attitude().heading()).isCloseTo(0, within(0.05));
  }

  @Test
  void smartVideoFliesACircleAndComesBack() {
    takeOff();
    send(SET, 0x80, (2 << 2) | 1);
    double farthest = 0;
    for (int i = 0; i < 300; i++) {
      drone.advance(0.1);
      farthest = Math.max(farthest, drone.state().motion().position().x());
    }

    assertThat(farthest).isCloseTo(2, within(0.1));
    assertThat(drone.state().motion().position().horizontal().norm()).isLessThan(0.1);
  }

  @Test
  void smartVideoFliesUpAndOut() {
    takeOff();
    send(SET, 0x80, (3 << 2) | 1);
    drone.advance(10);

    assertThat(drone.state().motion().position().x()).isCloseTo(-2, within(0.1));
    assertThat(drone.state().motion().position().z()).isCloseTo(1.3, within(0.1));
  }

  @Test
  void aDroneBouncesUntilItIsTold() {
    takeOff();
    send(SET, 0x1053, 0x30);
    double highest = 0;
    for (int i = 0; i < 100; i++) {
      drone.advance(0.1);
      highest = Math.max(highest, drone.state().motion().position().z());
    }
    assertThat(highest).isCloseTo(0.6, within(0.1));

    send(SET, 0x1053, 0x31);
    drone.advance(4);
    assertThat(drone.state().motion().velocity().norm()).isLessThan(0.01);
  }

  @Test
  void aThrowTakesOffAndAPalmLands() {
    send(ASK, 0x5d, 0);
    drone.advance(5);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);

    send(SET, 0x5e, 0);
    drone.advance(8);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
  }

  @Test
  void bothSticksDownAndInwardsStartTheMotorsAndTheThrottleTakesOff() {
    String inwards = sticksOf(-1, -1, -1, 1);
    for (int i = 0; i < 30; i++) {
      sticks(inwards);
      drone.advance(0.05);
    }
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.IDLING);

    sticks(sticksOf(0, 0, 0.5, 0));
    drone.advance(5);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
  }

  /** Returns the payload of sticks from -1 to 1. */
  private static String sticksOf(double right, double forward, double up, double clockwise) {
    long bits = 0;
    double[] values = {right, forward, up, clockwise};
    for (int i = 0; i < values.length; i++) {
      bits |= Math.round(1024 + 660 * values[i]) << (11 * i);
    }
    byte[] bytes = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN).putLong(bits).array();
    return HexFormat.of().formatHex(bytes, 0, 6);
  }

  private void takeOff() {
    send(SET, 0x54);
    drone.advance(5);
  }

  @Test
  void aClimbEndsAtTheHeightLimit() {
    send(SET, 0x58, 1, 0);
    send(ASK, 0x1056);
    assertThat(lastReply().payload()).containsExactly(0, 1, 0);
    takeOff();
    for (int i = 0; i < 100; i++) {
      sticks(sticksOf(0, 0, 1, 0));
      drone.advance(0.05);
    }

    assertThat(drone.state().motion().position().z()).isBetween(0.8, 1.2);
  }

  @Test
  void theAttitudeLimitMakesTheDroneSlower() {
    takeOff();
    ByteBuffer limit = ByteBuffer.allocate(4).order(ByteOrder.LITTLE_ENDIAN).putFloat(12.5f);
    byte[] bytes = limit.array();
    send(SET, 0x1058, bytes[0], bytes[1], bytes[2], bytes[3]);
    send(ASK, 0x1059);
    assertThat(ByteBuffer.wrap(lastReply().payload()).order(ByteOrder.LITTLE_ENDIAN).getFloat(1))
        .isEqualTo(12.5f);
    for (int i = 0; i < 30; i++) {
      sticks(sticksOf(0, 1, 0, 0));
      drone.advance(0.05);
    }

    assertThat(drone.state().motion().velocity().x()).isBetween(0.3, 0.55);
  }

  @Test
  void theBatteryThresholdIsToldAndSetsTheFlag() {
    drone.control(new Control.SetBattery(1, 50));
    send(ASK, 0x1057);
    assertThat(lastReply().payload()).containsExactly(0, 20, 0);

    send(SET, 0x1055, 60);
    drone.advance(0.3);

    assertThat(flightData().get(17) & 0x20).isEqualTo(0x20);
  }

  // --- telemetry ---

  @Test
  void flightDataComesTenTimesASecondAndTheRestTwice() {
    int before = (int) notifications(0x56).count();
    drone.advance(10);

    assertThat(notifications(0x56).count() - before).isBetween(99L, 101L);
    assertThat(notifications(0x1a)).hasSizeBetween(20, 21);
    assertThat(notifications(0x35)).hasSizeBetween(20, 21);
    assertThat(notifications(0x46)).hasSize(1);
  }

  @Test
  void flightDataTellsWhatTheDroneDoes() {
    drone.advance(0.2);
    ByteBuffer standing = flightData();
    assertThat(standing.get(12)).isEqualTo((byte) 100);
    assertThat(standing.getShort(15)).isBetween((short) 4100, (short) 4200);
    assertThat(standing.get(17) & 3).isEqualTo(2);
    assertThat(standing.get(18)).isEqualTo((byte) 1);

    send(SET, 0x54);
    drone.advance(1);
    assertThat(flightData().get(18)).isEqualTo((byte) 11);
    drone.advance(4);
    ByteBuffer flying = flightData();
    assertThat(flying.getShort(0)).isEqualTo((short) 3);
    assertThat(flying.get(17) & 11).isEqualTo(1 | 8);
    assertThat(flying.get(18)).isEqualTo((byte) 6);
    assertThat(flying.getShort(8)).isGreaterThan((short) 30);
  }

  @Test
  void theLogBeginsWhenItsHeaderIsAnswered() {
    drone.advance(6);
    assertThat(notifications(0x1050)).hasSize(3);
    assertThat(notifications(0x1051)).isEmpty();

    send(0x50, 0x1050, 0, 0x2c, 0x43);
    drone.advance(2);

    assertThat(notifications(0x1050)).hasSize(3);
    List<Packet> log = notifications(0x1051).toList();
    assertThat(log).hasSizeBetween(38, 41);
    assertThat(log).allMatch(packet -> packet.payload().length <= 1001);
    assertThat(log.stream().flatMap(packet -> records(packet).stream()).filter(id -> id == 29))
        .hasSizeBetween(9, 11);
  }

  /** Returns the ids of the records, and checks their checksums. */
  private static List<Integer> records(Packet packet) {
    List<Integer> ids = new ArrayList<>();
    ByteBuffer in = ByteBuffer.wrap(packet.payload()).order(ByteOrder.LITTLE_ENDIAN);
    assertThat(in.get()).isZero();
    while (in.hasRemaining()) {
      int at = in.position();
      int length = in.getShort(at + 1);
      byte[] record = new byte[length];
      in.get(record);
      assertThat(record[0]).isEqualTo((byte) 0x55);
      assertThat(length).isBetween(13, 255);
      assertThat(Byte.toUnsignedInt(record[3])).isEqualTo(Checksum.ofHeader(record));
      assertThat(Short.toUnsignedInt(in.getShort(at + length - 2)))
          .isEqualTo(Checksum.of(record, length - 2));
      ids.add((int) in.getShort(at + 4));
    }
    return ids;
  }

  @Test
  void theLogTellsTheTruePosition() {
    send(0x50, 0x1050, 0x2c, 0x43); // as the Rust library answers
    send(SET, 0x54);
    drone.advance(5);
    sticks("00 a4 34 00 01 08");
    drone.advance(1);
    List<Packet> log = notifications(0x1051).toList();
    ByteBuffer position = null;
    for (Packet packet : log) {
      position = visualPosition(packet).orElse(position);
    }

    assertThat((double) position.getFloat(8)).isCloseTo(truth().x(), within(0.3));
    assertThat((double) position.getFloat(12)).isCloseTo(0, within(0.3));
    assertThat(-(double) position.getFloat(16)).isCloseTo(truth().z(), within(0.3));
  }

  private Vec3 truth() {
    return drone.state().motion().position();
  }

  private static Optional<ByteBuffer> visualPosition(Packet packet) {
    ByteBuffer in = ByteBuffer.wrap(packet.payload()).order(ByteOrder.LITTLE_ENDIAN);
    for (int at = 1; at < in.capacity(); at += in.getShort(at + 1)) {
      if (in.getShort(at + 4) == 29) {
        byte[] payload = new byte[in.getShort(at + 1) - 12];
        for (int i = 0; i < payload.length; i++) {
          payload[i] = (byte) (in.get(at + 10 + i) ^ in.get(at + 6));
        }
        return Optional.of(ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN));
      }
    }
    return Optional.empty();
  }

  // --- settings ---

  @Test
  void theVersionHasThirtyOneBytes() {
    send(ASK, 0x45);

    assertThat(lastReply().payload()).hasSize(31);
  }

  @Test
  void theBitRateIsSetAndTold() {
    send(SET, 0x20, 5);
    assertThat(drone.state().video().megabits()).isEqualTo(4);

    send(ASK, 0x28);
    assertThat(lastReply().payload()).containsExactly(0, 5);
  }

  @Test
  void keyPicturesAreLimitedToFourASecond() {
    int before = drone.state().video().keyPictures();
    for (int i = 0; i < 40; i++) {
      drone.advance(0.05);
      send(SILENT, 0x25);
    }

    assertThat(drone.state().video().keyPictures() - before).isBetween(7, 8);
  }

  @ParameterizedTest
  @ValueSource(ints = {0x12, 0x14, 0x16, 0x21, 0x24, 0x32, 0x34, 0x37, 0x5a})
  void ordersWithoutEffectAreAccepted(int id) {
    send(SET, id, 1);

    assertThat(lastReply().kind()).isEqualTo(0xb0);
    assertThat(lastReply().payload()).containsExactly(0);
  }

  @Test
  void theDroneIsCalibrated() {
    send(ASK, 0x5b);

    assertThat(lastReply().payload()).containsExactly(0, 0x3f, 0, 100, 0);
  }

  @Test
  void thePictureIsWideOrNot() {
    send(SET, 0x31, 1);
    assertThat(drone.state().video().wide()).isTrue();
    send(SET, 0x31, 2);
    assertThat(lastReply().payload()).containsExactly(1);
    send(SET, 0x31, 0);
    assertThat(drone.state().video().wide()).isFalse();
  }

  // --- photos ---

  /** Takes a photo of some chunks and a part of one. */
  private byte[] takePhoto() {
    byte[] photo = new byte[20 * 1024 + 7];
    new Random(1).nextBytes(photo);
    drone.setCamera((number, quality) -> Optional.of(() -> photo));
    send(SET, 0x30);
    assertThat(lastReply().kind()).isEqualTo(0xb0);
    assertThat(lastReply().payload()).containsExactly(0);
    drone.advance(1.1);
    return photo;
  }

  @Test
  void aPhotoIsSentInPieces() {
    byte[] photo = takePhoto();
    Packet size = notifications(0x62).findFirst().orElseThrow();
    assertThat(size.unsigned(0)).isEqualTo(1);
    assertThat(size.integer(1)).isEqualTo(photo.length);
    send(0x50, 0x62, 0);

    for (int piece = 0; piece < 3; piece++) {
      drone.advance(0.02);
      assertThat(notifications(0x63).count()).isEqualTo(Math.min(21, 8 * (piece + 1)));
      if (piece < 2) {
        send(0x50, 0x63, 0, 0, 0, piece, 0, 0, 0);
      }
    }
    byte[] received = new byte[photo.length];
    for (Packet chunk : notifications(0x63).toList()) {
      ByteBuffer in = ByteBuffer.wrap(chunk.payload()).order(ByteOrder.LITTLE_ENDIAN);
      int number = in.getInt(6);
      assertThat(in.getInt(2)).isEqualTo(number / 8);
      assertThat((int) in.getShort(10)).isEqualTo(chunk.payload().length - 12);
      in.position(12).get(received, number * 1024, in.remaining());
    }
    assertThat(received).isEqualTo(photo);
    send(0x50, 0x63, 1, 0, 0, 9, 0, 0, 0); // TelloLib names another piece
    send(ASK, 0x64, 0, 0, 7, 80, 0, 0);
    drone.advance(10);
    assertThat(notifications(0x63)).hasSize(21);
  }

  @Test
  void whatIsNotAcknowledgedIsRepeatedTenTimes() {
    takePhoto();
    drone.advance(10);
    assertThat(notifications(0x62)).hasSize(10);

    takePhoto();
    send(0x50, 0x62, 0);
    drone.advance(10);
    assertThat(notifications(0x63)).hasSize(80);
  }

  @Test
  void aSizeThatIsSentBackIsAnswered() {
    takePhoto();
    Packet size = notifications(0x62).findFirst().orElseThrow();
    assertThat(size.kind()).isEqualTo(0x88);
    drone.send(WireText.decode(size.bytes()));

    assertThat(lastReply().kind()).isEqualTo(0x50);
    assertThat(lastReply().sequence()).isEqualTo(size.sequence());
    assertThat(lastReply().payload()).containsExactly(0);
    drone.advance(0.1);
    assertThat(notifications(0x63)).hasSize(8);
  }

  @Test
  void onePhotoIsSentAtATime() {
    takePhoto();
    send(SET, 0x30);

    assertThat(lastReply().payload()).containsExactly(1);
  }

  @Test
  void withoutACameraAPhotoIsRefused() {
    send(SET, 0x30);
    assertThat(lastReply().payload()).containsExactly(1);
    drone.advance(2);
    assertThat(notifications(0x62)).isEmpty();
  }

  @Test
  void afterAPhotoThatFailedThereCanBeAnother() {
    drone.setCamera((number, quality) -> Optional.of(() -> new byte[0]));
    send(SET, 0x30);
    drone.advance(2);
    assertThat(notifications(0x62)).isEmpty();

    takePhoto();
    assertThat(notifications(0x62)).isNotEmpty();
  }

  @Test
  void aMillionDamagedPacketsMoveNothing() {
    Random random = new Random(2);
    List<byte[]> packets = new ArrayList<>();
    for (MessageId id : MessageId.values()) {
      packets.add(new Packet(SET, id.number(), 1, new byte[11]).bytes());
    }
    int replies = drone.replies().size();
    for (int i = 0; i < 1_000_000; i++) {
      byte[] damaged = packets.get(i % packets.size()).clone();
      for (int change = random.nextInt(4); change >= 0; change--) {
        damaged[random.nextInt(damaged.length)] ^= (byte) (1 + random.nextInt(255));
      }
      damaged = Arrays.copyOf(damaged, damaged.length - random.nextInt(2));
      if (Packet.parse(damaged).isEmpty()) {
        drone.send(WireText.decode(damaged));
      }
    }
    drone.advance(1);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(drone.replies().stream().skip(replies))
        .noneMatch(sent -> sent.text().charAt(0) == 0xcc);
    takeOff();
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
  }

  @Test
  void damagedPacketsHaveNoEffect() {
    byte[] takeoff = new Packet(SET, 0x54, 1, new byte[0]).bytes();
    int replies = drone.replies().size();
    for (int bit = 0; bit < takeoff.length * 8; bit++) {
      byte[] damaged = takeoff.clone();
      damaged[bit / 8] ^= (byte) (1 << (bit % 8));
      drone.send(WireText.decode(damaged));
    }
    drone.advance(1);

    assertThat(drone.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(drone.replies().stream().skip(replies))
        .noneMatch(sent -> sent.text().charAt(0) == 0xcc);
  }

  // --- what listeners see ---

  private List<String> words() {
    return drone.events().stream().map(SimEvent::words).toList();
  }

  @Test
  void settingsAndQuestionsAreReportedWithTheirAnswers() {
    send(SET, 0x58, 10, 0);
    send(SET, 0x58, 0, 0);
    send(ASK, 0x1056);
    send(ASK, 0x11);
    send(SILENT, 0x25);

    assertThat(words())
        .contains(
            "`conn_req (app)` answered `conn_ack`",
            "`height limit 10 (app)` answered `ok`",
            "`height limit 0 (app)` refused: the value is out of range; answered `error`",
            "`height limit? (app)` answered `10`",
            "`ssid? (app)` answered `TELLO-000001`");
    assertThat(received()).as("without the key picture, which has no answer").hasSize(5);
  }

  @Test
  void lostPacketsAreNamedInWords() {
    drone.control(new Control.InjectFault(Fault.of("loss commands 100%")));
    drone.send(AppPackets.TAKEOFF);
    drone.control(new Control.ClearFaults());
    drone.control(new Control.InjectFault(Fault.of("loss replies 100%")));
    drone.send(AppPackets.TAKEOFF);

    assertThat(words())
        .contains(
            "`takeoff (app)` from 192.168.10.2:9000 was lost by the fault loss commands 100%",
            "the answer `ok` to 192.168.10.2:9000 was lost by the fault loss replies 100%");
  }

  @Test
  void aPacketToADroneThatIsOffIsNamedInWords() {
    drone.control(new Control.Power(1, false));
    drone.advance(5);
    drone.send(AppPackets.TAKEOFF);

    assertThat(words())
        .contains("`takeoff (app)` from 192.168.10.2:9000 ignored: the drone is off");
  }

  @Test
  void sticksAreWholeNumbersWithoutANegativeZero() {
    sticks("ff 03 20 00 01 08"); // roll 1023, just left of the middle

    assertThat(received()).endsWith("rc 0 0 0 0 (app)");
  }
}
