package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.testing.AppPackets;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.time.WallTime;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.video.picture.Picture;

@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class DroneRecorderTest {

  private static final InetSocketAddress DRONE = SteppedDrone.address("192.168.10.1", 8889);
  private static final InetSocketAddress CLIENT = SteppedDrone.address("127.0.0.1", 9001);

  @TempDir private Path folder;

  private DroneRecorder recorder;
  private long begun;

  @BeforeEach
  void begin() {
    recorder =
        DroneRecorder.start(
            RecordingFolder.at(folder), DRONE.getAddress(), List.of("proxy"), reason -> {});
    begun = WallTime.nanoTime();
  }

  private long nanos(double second) {
    return begun + Math.round(second * 1e9);
  }

  private void command(double second, String text) {
    recorder.command(nanos(second), CLIENT, DRONE, bytes(text));
  }

  private void reply(double second, String text) {
    recorder.sent(nanos(second), Kind.REPLY, DRONE, CLIENT, bytes(text));
  }

  private void state(double second, String text) {
    recorder.sent(nanos(second), Kind.STATE, DRONE, CLIENT, bytes(text));
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /** Returns the commands of each recording, the first recording first. */
  private List<List<String>> recorded() throws Exception {
    recorder.close();
    return RecordingFiles.in(folder).stream().map(DroneRecorderTest::commands).toList();
  }

  private static List<String> commands(RecordingFiles files) {
    try {
      return RecordedFlight.read(files.folder()).commands().stream()
          .map(RecordedCommand::text)
          .toList();
    } catch (UnreadableRecordingException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void aFlightGoesFromTakeoffUntilThreeSecondsAfterLanding() throws Exception {
    command(1, "command");
    reply(1.1, "ok");
    state(1.2, "pitch:0;roll:0;yaw:0;vgx:0;vgy:0;vgz:0;h:0;bat:90;\r\n");
    command(2, "takeoff");
    state(3, "pitch:-3;roll:2;yaw:10;vgx:0;vgy:0;vgz:-8;h:40;bat:89;\r\n");
    reply(7, "ok");
    command(8, "land");
    reply(10, "ok");
    command(12.9, "battery?");
    reply(12.95, "88");
    command(13.1, "wifi?");
    recorder.close();

    RecordingFiles files = RecordingFiles.only(folder);
    assertThat(commands(files)).containsExactly("command", "takeoff", "land", "battery?");
    assertThat(files.wire("state")).hasSize(1);
    assertThat((double) files.run().get("ended") - (double) files.run().get("started"))
        .isBetween(11.0, 11.2);
  }

  @Test
  void commandsThatAreBusyOrRefusedEndNoFlight() throws Exception {
    command(1, "takeoff");
    command(1.5, "battery?");
    reply(1.6, "error Not joystick");
    reply(6, "ok");
    command(7, "forward 300");
    command(8, "land");
    reply(8.1, "error Not joystick");
    reply(12, "ok");
    command(20, "cw 90");
    reply(22, "ok");

    assertThat(recorded())
        .containsExactly(List.of("takeoff", "battery?", "forward 300", "land", "cw 90"));
  }

  @Test
  void aRefusedTakeoffIsARecordingOfItsOwn() throws Exception {
    command(1, "takeoff");
    reply(1.2, "error No valid imu");
    command(2, "takeoff");
    reply(7, "ok");
    command(8, "emergency");
    command(12, "command");

    assertThat(recorded()).containsExactly(List.of("takeoff"), List.of("takeoff", "emergency"));
  }

  @Test
  void aTakeoffInTheAirIsRefusedAndEndsNoFlight() throws Exception {
    command(1, "takeoff");
    reply(6, "ok");
    command(7, "takeoff");
    reply(7.1, "error");
    command(20, "cw 90");
    reply(22, "ok");

    assertThat(recorded()).containsExactly(List.of("takeoff", "takeoff", "cw 90"));
  }

  @Test
  void aTakeoffThatIsRefusedRightAfterALandingEndsItsOwnRecording() throws Exception {
    command(1, "takeoff");
    reply(6, "ok");
    command(7, "land");
    reply(9, "ok");
    command(10, "takeoff");
    reply(10.2, "error No valid imu");
    command(14, "battery?");

    assertThat(recorded()).containsExactly(List.of("takeoff", "land"), List.of("takeoff"));
  }

  @Test
  void aFlightOfWhichNothingIsHeardAnyMoreIsOver() throws Exception {
    command(1, "takeoff");
    reply(6, "ok");
    recorder.tick(nanos(60.9));
    command(60.95, "battery?");
    recorder.tick(nanos(121));
    command(122, "takeoff");

    assertThat(recorded()).containsExactly(List.of("takeoff", "battery?"), List.of("takeoff"));
  }

  @Test
  void thePathIsSummedUpFromTheSpeedsInStateLines() throws Exception {
    command(0, "takeoff");
    for (int i = 0; i <= 20; i++) { // 3 dm/s along x and 1 dm/s to the right, for 2 s
      state(1 + i / 10.0, "pitch:-3;roll:2;yaw:10;vgx:3;vgy:1;vgz:0;templ:60;h:80;bat:89;\r\n");
    }
    recorder.close();

    Path recorded = RecordingFiles.only(folder).folder();
    assertThat(Files.readAllLines(recorded.resolve("flight.csv")))
        .hasSize(22)
        .last()
        .asString()
        .endsWith(",1,60.00,-20.00,80.00,2.00,-3.00,10.00,30.0,-10.0,0.0,,89,,,,,80,,,10,89,");
    RecordedFlight flight = RecordedFlight.read(recorded);
    List<Sample> samples = flight.tracks().get(0).samples();
    Sample last = samples.get(20);
    assertThat(samples).hasSize(21);
    assertThat(last.position().x()).isBetween(0.599, 0.601);
    assertThat(last.position().y()).isBetween(-0.201, -0.199);
    assertThat(last.position().z()).isEqualTo(0.8);
    assertThat(last.angles()).isEqualTo(new Sample.Angles(2, -3, 10));
    assertThat(last.batteryPercent()).isEqualTo(89);
    assertThat(flight.remarks())
        .extracting(remark -> remark.english())
        .contains(
            "a real drone flew: its path is summed up from the speeds in its state lines, and the"
                + " room is not known");
  }

  /** The datagrams of a real drone have 1460 bytes, except for the last one of a NAL unit. */
  @Test
  void theFilmIsPutTogetherFromItsDatagrams() throws Exception {
    command(0, "takeoff");
    H264Encoder encoder = new H264Encoder(64, 48);
    for (int i = 0; i < 5; i++) {
      AccessUnit encoded = encoder.encode(new Picture(64, 48), i == 1);
      for (int unit = 0; unit < encoded.nalUnits(); unit++) {
        byte[] nal =
            java.util.Arrays.copyOfRange(
                encoded.bytes(), encoded.start(unit), encoded.start(unit + 1));
        recorder.sent(nanos(1 + i / 30.0), Kind.VIDEO, DRONE, CLIENT, nal);
      }
      recorder.sent(nanos(1 + i / 30.0), Kind.VIDEO, DRONE, CLIENT, new byte[] {7});
    }
    recorder.close();

    RecordingFiles files = RecordingFiles.only(folder);
    assertThat(files.has("video-1.mp4")).isTrue();
    assertThat((List<?>) files.run().get("videos")).hasSize(1);
  }

  @Test
  void aFlightWithTheAppGoesOnForTenSecondsAfterTheAnswerToItsLanding() throws Exception {
    command(0, AppPackets.CONNECT);
    reply(0.1, AppPackets.ACKNOWLEDGEMENT);
    command(1, AppPackets.TAKEOFF);
    reply(1.1, AppPackets.TAKEOFF_DONE);
    command(5, AppPackets.LAND);
    reply(5.1, AppPackets.LAND_DONE);
    command(6, AppPackets.STOP_LANDING);
    command(20, AppPackets.LAND);
    reply(20.1, AppPackets.LAND_DONE);
    recorder.tick(nanos(33));
    recorder.tick(nanos(33.2)); // 20.1 + 10 + 3
    command(34, "battery?");

    assertThat(recorded())
        .containsExactly(
            List.of(
                AppPackets.CONNECT,
                AppPackets.TAKEOFF,
                AppPackets.LAND,
                AppPackets.STOP_LANDING,
                AppPackets.LAND));
  }

  @Test
  void aTakeoffThatTheAppIsRefusedIsARecordingOfItsOwn() throws Exception {
    command(1, AppPackets.TAKEOFF);
    reply(1.1, AppPackets.TAKEOFF_REFUSED);
    recorder.tick(nanos(4.2));
    command(5, "command");

    assertThat(recorded()).containsExactly(List.of(AppPackets.TAKEOFF));
  }

  /** The app's datagrams have two bytes in front, the second of which marks the last of a unit. */
  @Test
  void theFilmOfTheAppIsPutTogetherToo() throws Exception {
    command(0, AppPackets.TAKEOFF);
    H264Encoder encoder = new H264Encoder(64, 48);
    int number = 0;
    for (int i = 0; i < 5; i++) {
      AccessUnit encoded = encoder.encode(new Picture(64, 48), i == 1);
      for (int unit = 0; unit < encoded.nalUnits(); unit++) {
        byte[] nal =
            java.util.Arrays.copyOfRange(
                encoded.bytes(), encoded.start(unit), encoded.start(unit + 1));
        int half = Math.max(5, nal.length / 2); // behind the start code
        film(1 + i / 30.0, number, 0, nal, 0, half);
        film(1 + i / 30.0, number, 0x81, nal, half, nal.length);
        number++;
      }
    }
    recorder.close();

    RecordingFiles files = RecordingFiles.only(folder);
    assertThat(files.has("video-1.mp4")).isTrue();
    assertThat((List<?>) files.run().get("videos")).hasSize(1);
  }

  private void film(double second, int number, int index, byte[] nal, int from, int to) {
    byte[] datagram = new byte[2 + to - from];
    datagram[0] = (byte) number;
    datagram[1] = (byte) index;
    System.arraycopy(nal, from, datagram, 2, to - from);
    recorder.sent(nanos(second), Kind.VIDEO, DRONE, CLIENT, datagram);
  }
}
