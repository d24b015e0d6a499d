package tellosimulator.comparison;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.comparison.FlownCommand.Motion;
import tellosimulator.comparison.Tolerance.Aspect;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.testing.AppPackets;

/** Compares recordings that contain only datagrams, like those of real drones. */
class FlightComparisonTest {

  private static final String RUN =
      """
      {"format":1,"started":0,"drones":[{"number":1}],"ended":60}
      """;

  @TempDir private Path folder;
  private int flights;

  /** Writes datagrams: consecutive commands, and a state line every 0.1 s. */
  private static final class Wire {
    private final StringBuilder lines = new StringBuilder();
    private double time;
    private double yaw;
    private double height;

    /** Creates a drone with an initial yaw [degrees]. */
    Wire(double yaw) {
      this.yaw = yaw;
    }

    Wire command(String text, double seconds, String reply) {
      return moving(text, seconds, reply, 0, 0, 0);
    }

    /** Sets the drone's speed over the ground [dm/s], its climb [cm] and its turn [degrees]. */
    Wire moving(
        String text, double seconds, String reply, double speed, double climb, double turn) {
      line("in", "command", time, text);
      int states = (int) Math.round(seconds / 0.1);
      for (int i = 0; i <= states; i++) {
        double part = (double) i / states;
        double along = Math.toRadians(yaw);
        line(
            "out",
            "state",
            time + 0.001 + i * 0.0998,
            String.format(
                Locale.ROOT,
                "yaw:%.0f;vgx:%.2f;vgy:%.2f;vgz:0;tof:10;h:%.0f;bat:90;\\r\\n",
                yaw + part * turn,
                speed * Math.cos(along),
                speed * Math.sin(along),
                height + part * climb));
      }
      time += seconds;
      yaw += turn;
      height += climb;
      line("out", "reply", time, reply);
      time += 0.5;
      return this;
    }

    private void line(String direction, String kind, double at, String text) {
      lines.append(
          String.format(
              Locale.ROOT,
              "{\"t\":%.3f,\"drone\":1,\"dir\":\"%s\",\"kind\":\"%s\",\"text\":\"%s\"}%n",
              at,
              direction,
              kind,
              text));
    }
  }

  private Flight flight(Wire wire) throws IOException, UnreadableRecordingException {
    Path flown = folder.resolve("flight-" + flights++);
    new RecordingFixture(flown).run(RUN).with("wire.jsonl", wire.lines.toString());
    return Flight.read(flown);
  }

  private FlightComparison compare(Wire first, Wire second)
      throws IOException, UnreadableRecordingException {
    return FlightComparison.of(flight(first), flight(second), Tolerance.DEFAULT);
  }

  private static Wire square(double yaw) {
    return new Wire(yaw)
        .command("command", 0.1, "ok")
        .moving("takeoff", 3, "ok", 0, 80, 0)
        .moving("forward 100", 2, "ok", 5, 0, 0)
        .moving("cw 90", 2, "ok", 0, 0, 90)
        .command("land", 2, "ok");
  }

  @Test
  void whereADroneLookedAtFirstMakesNoDifference() throws Exception {
    FlightComparison comparison = compare(square(0), square(-26));

    assertThat(comparison.alike()).isTrue();
    assertThat(comparison.pairs())
        .extracting(CommandPair::text)
        .containsExactly("command", "takeoff", "forward 100", "cw 90", "land");
    Motion motion = comparison.pairs().get(2).second().orElseThrow().motion().orElseThrow();
    assertThat(motion.forward()).isCloseTo(100, within(1.0));
    assertThat(motion.left()).isCloseTo(0, within(1.0));
    Motion turn = comparison.pairs().get(3).second().orElseThrow().motion().orElseThrow();
    assertThat(turn.turn()).isCloseTo(90, within(1.0));
  }

  @ParameterizedTest
  @CsvSource({
    "2.0, ok,                5,  0,   0,",
    "2.2, ok,                5,  0,   0,",
    "2.8, ok,                3.6, 0,  0, DURATION",
    "2.0, error Not joystick, 5, 0,   0, REPLY",
    "2.0, ok,                7,  0,   0, DISTANCE",
    "2.0, ok,               -5,  0,   0, DISTANCE",
    "2.0, ok,                5, 35,   0, HEIGHT",
    "2.0, ok,                5,  0,  12, TURN",
  })
  void whatDiffersByMoreThanIsToleratedIsNamed(
      double seconds, String reply, double speed, double climb, double turn, Aspect expected)
      throws Exception {
    Wire first = new Wire(10).moving("forward 100", 2, "ok", 5, 0, 0);
    Wire second = new Wire(10).moving("forward 100", seconds, reply, speed, climb, turn);

    CommandPair pair = compare(first, second).pairs().get(0);

    if (expected == null) {
      assertThat(pair.differing()).isEmpty();
    } else {
      assertThat(pair.differing()).containsExactly(expected);
    }
  }

  @Test
  void turnsAcrossTheBackAreNoDifference() throws Exception {
    Wire first = new Wire(0).moving("cw 180", 3, "ok", 0, 0, 178);
    Wire second = new Wire(0).moving("cw 180", 3, "ok", 0, 0, -178);

    assertThat(compare(first, second).alike()).isTrue();
  }

  @Test
  void valuesThatAreReadMayDiffer() throws Exception {
    Wire first = new Wire(0).command("battery?", 0.1, "87");
    Wire second = new Wire(0).command("battery?", 0.1, "86");

    assertThat(compare(first, second).alike()).isTrue();
  }

  @Test
  void aCommandThatOneFlightLacksShiftsNoOther() throws Exception {
    Wire first = new Wire(0).command("command", 0.1, "ok").command("land", 2, "ok");
    Wire second =
        new Wire(0)
            .command("command", 0.1, "ok")
            .command("flip l", 2, "ok")
            .command("land", 2, "ok");

    FlightComparison comparison = compare(first, second);

    assertThat(comparison.pairs())
        .extracting(pair -> pair.text() + " " + pair.differing())
        .containsExactly("command []", "flip l [MISSING]", "land []");
    assertThat(comparison.pairs().get(1).first()).isEmpty();
    assertThat(comparison.alike()).isFalse();
  }

  @Test
  void theTableHasBothValuesWhereTheyDiffer() throws Exception {
    Wire first = new Wire(0).moving("forward 100", 2, "ok", 5, 0, 0);
    Wire second = new Wire(0).moving("forward 100", 3, "ok", 5, 0, 0).command("stop", 0.1, "ok");

    assertThat(table(compare(first, second)))
        .containsExactly(
            "drone  command      reply   s            forward cm  left cm  up cm  turn deg  verdict",
            "1      forward 100  ok      2.00 | 3.00  100 | 150   0        0      0         differs:"
                + " duration, distance",
            "1      stop         - | ok  - | 0.10     -           -        -      -         only in"
                + " the second",
            "2 of 2 commands differ by more than 15 % or 0.5 s, 30 cm, 10 degrees");
  }

  private static List<String> table(FlightComparison comparison) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    new ComparisonTable(comparison, Tolerance.DEFAULT)
        .print(new PrintStream(bytes, true, StandardCharsets.UTF_8));
    return bytes.toString(StandardCharsets.UTF_8).lines().toList();
  }

  @Test
  void stateLinesThatAreDamagedAreLeftOut() throws Exception {
    Wire wire = new Wire(0).moving("forward 100", 2, "ok", 5, 0, 0);
    wire.lines.append("{\"t\":3.0,\"kind\":\"state\",\"text\":\"yaw:x;h:0;vgx:0;vgy:0;vgz:0\"}\n");
    wire.lines.append("{\"t\":3.1,\"kind\":\"state\",\"te");

    Flight flight = flight(wire);

    assertThat(flight.states()).hasSize(21);
  }

  private static Wire appFlight(String... more) {
    Wire wire =
        new Wire(0).command(escaped(AppPackets.TAKEOFF), 0.1, escaped(AppPackets.TAKEOFF_DONE));
    for (String packet : more) {
      wire.line("in", "command", wire.time, escaped(packet));
    }
    return wire.command(escaped(AppPackets.LAND), 0.1, escaped(AppPackets.LAND_DONE));
  }

  private static String escaped(String text) {
    String json = Json.text(text);
    return json.substring(1, json.length() - 1);
  }

  @Test
  void packetsOfTheAppAreComparedInWordsAndSticksAreLeftOut() throws Exception {
    FlightComparison comparison =
        compare(appFlight(AppPackets.STICKS), appFlight(AppPackets.FLIP_BACK));

    assertThat(comparison.pairs())
        .extracting(pair -> pair.text() + " " + pair.differing())
        .containsExactly("takeoff (app) []", "flip b (app) [MISSING]", "land (app) []");
  }
}
