package tellosimulator.headless;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.concurrent.Agent;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.testing.ForPeople;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Room;

class ConsoleTest {

  private static final String HELP =
      "type reset [N], release [N], power on|off [N], battery PERCENT [N], fault TEXT|clear, faults,"
          + " link PRESET, pause, resume, state, help, finish or quit";

  private final Simulation simulation =
      new Simulation(
          SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(2, Vec3.ZERO, Room.DEFAULT)),
          drone -> datagram -> {},
          List.of());
  private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
  private final AtomicBoolean finished = new AtomicBoolean();

  @Test
  void quitEndsItAndTheEndOfInputIsSomethingElse() throws Exception {
    assertThat(type("state", "quit", "foo")).isTrue();
    assertThat(type("state")).isFalse();
    assertThat(type()).isFalse();
    assertThat(printed()).doesNotContain("foo");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "reset ",
        "release ",
        "power ",
        "power on ",
        "battery ",
        "fault ",
        "fault loss ",
        "faults ",
        "link ",
        "state "
      })
  void whateverIsTypedTheAnswerIsForPeople(String command) throws Exception {
    List<String> words =
        List.of(
            "x", "-1", "0", "3", "1e9", "9".repeat(400), "null", "{a=b}", "0x1p3", "NaN", "\u001b");
    for (String word : words) {
      printed.reset();
      type(command + word, command + word + " " + word + " " + word);

      assertThat(printed()).contains("was not done: ");
      ForPeople.check(printed().replace(word, "…"));
      assertThat(printed().chars()).allMatch(c -> c == '\n' || c >= ' ');
    }
  }

  @Test
  void stateDescribesEachDrone() throws Exception {
    type("power on 1");
    type("  state  ", "");

    assertThat(printed())
        .isEqualTo(
            """
            drone 1: standing, x 0.0 y 30.0 z 0.0 cm, yaw 0.0 degrees, battery 100 %, waits for `command`, 0.000 s
            drone 2: off, x 0.0 y -30.0 z 0.0 cm, yaw 0.0 degrees, battery 100 %, waits for `command`, 0.000 s
            """);
  }

  @Test
  void stateTellsTheTimeThatWasLost() throws Exception {
    SimSnapshot present = simulation.snapshot();
    SimSnapshot late =
        new SimSnapshot(
            present.time(),
            new SimSnapshot.Clock(TimeFactor.REAL_TIME, true, 12.34),
            present.seed(),
            present.arena(),
            present.drones());
    BufferedReader in = new BufferedReader(new StringReader("state\n"));
    PrintStream out = new PrintStream(printed, true, StandardCharsets.UTF_8);
    Agent console = new Console(() -> late, control -> {}, in, out).agent(() -> {}, () -> {});
    assertThat(console.doWork()).isEqualTo(Agent.Outcome.WORKED);

    assertThat(printed().lines()).allMatch(line -> line.endsWith(", 0.000 s, 12.3 s lost, paused"));
  }

  @Test
  void powerSwitchesOneDroneOrAll() throws Exception {
    type("power on");
    type("power off 2", "state");

    type("state");
    assertThat(printed().lines().skip(2))
        .satisfiesExactly(
            first -> assertThat(first).startsWith("drone 1: standing"),
            second -> assertThat(second).startsWith("drone 2: off"));
  }

  @Test
  void finishLetsTimeGoOnAndIsPassedOn() throws Exception {
    assertThat(type("pause", "finish")).as("quit").isFalse();

    assertThat(finished).isTrue();
    assertThat(simulation.snapshot().clock().paused()).isFalse();
    type("finish now");
    assertThat(finished).isFalse();
  }

  @Test
  void batteryIsSetForOneDroneOrAll() throws Exception {
    type("battery 40");
    assertThat(percents()).containsExactly(40, 40);

    type("battery 12.5 2", "battery 0 1");
    assertThat(percents().get(0)).isZero();
    assertThat(percents().get(1)).isBetween(12, 13);
  }

  @Test
  void resetPutsADroneBackToItsStart() throws Exception {
    Vec3 elsewhere = new Vec3(1, 1, 0);
    simulation.control(new Control.SetStart(1, elsewhere));
    type("reset 1", "reset");

    assertThat(drone(0).motion().position()).isEqualTo(elsewhere);
    assertThat(printed()).isEmpty();
  }

  @Test
  void pauseLetsTimeStandStillUntilResume() throws Exception {
    type("pause");
    assertThat(simulation.snapshot().clock().paused()).isTrue();

    type("state");
    assertThat(printed()).contains(", paused\n");

    type("resume");
    assertThat(simulation.snapshot().clock().paused()).isFalse();
  }

  @Test
  void helpListsTheCommands() throws Exception {
    type("help");

    assertThat(printed().lines())
        .anyMatch(line -> line.matches("reset \\[N] +put drones back to their start"))
        .anyMatch(line -> line.startsWith("quit "));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          fly            | there is no such command
          QUIT           | there is no such command
          quit now       | there is a word too many, now
          finish 1       | there is a word too many, 1
          state 1        | there is a word too many, 1
          pause 1        | there is a word too many, 1
          resume all     | there is a word too many, all
          reset 1 2      | there is a word too many, 2
          power on 1 2   | there is a word too many, 2
          battery 50 1 2 | there is a word too many, 2
          reset 0        | the drones are 1 to 2
          reset 3        | the drones are 1 to 2
          reset 1.5      | the drones are 1 to 2
          reset all      | expected a drone's number, found all
          power          | expected on or off
          power 1        | expected on or off, found 1
          battery        | expected a percentage
          battery full   | expected a percentage, found full
          battery NaN    | expected a percentage, found NaN
          battery 0x1p3  | expected a percentage, found 0x1p3
          battery 100.5  | battery is 100.5 %, but must be from 0 to 100
          battery -1     | battery is -1.0 %, but must be from 0 to 100
          """)
  void whatCannotBeDoneIsExplainedAndChangesNothing(String line, String reason) throws Exception {
    assertThat(type(line)).isFalse();

    assertThat(printed()).isEqualTo("`" + line + "` was not done: " + reason + "; " + HELP + ".\n");
    assertThat(percents()).containsExactly(100, 100);
    assertThat(simulation.snapshot().clock().paused()).isFalse();
  }

  private boolean type(String... lines) throws Exception {
    String input = String.join("\n", lines);
    PrintStream out = new PrintStream(printed, true, StandardCharsets.UTF_8);
    BufferedReader in = new BufferedReader(new StringReader(input));
    AtomicBoolean quit = new AtomicBoolean();
    finished.set(false);
    Agent console =
        new Console(simulation::snapshot, this::carryOut, in, out)
            .agent(() -> finished.set(true), () -> quit.set(true));
    Agent.Outcome outcome = Agent.Outcome.WORKED;
    while (outcome == Agent.Outcome.WORKED) {
      outcome = console.doWork();
    }
    assertThat(outcome).isEqualTo(Agent.Outcome.FINISHED);
    return quit.get();
  }

  private void carryOut(Control control) {
    simulation.control(control);
    simulation.drain();
  }

  private String printed() {
    return printed.toString(StandardCharsets.UTF_8).replace(System.lineSeparator(), "\n");
  }

  private List<Integer> percents() {
    return List.of(drone(0).energy().battery().percent(), drone(1).energy().battery().percent());
  }

  private DroneState drone(int index) {
    return simulation.snapshot().drones().get(index).state();
  }
}
