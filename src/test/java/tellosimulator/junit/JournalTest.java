package tellosimulator.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.junit.Times.atLeast;
import static tellosimulator.junit.Times.atMost;
import static tellosimulator.junit.Times.times;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import tellosimulator.junit.JournalEntry.Outcome;
import tellosimulator.testing.AppPackets;

@TelloTest
class JournalTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @Test
  void eachTextHasItsOutcomeItsRepliesAndTheirDelay(SimulatedDrone drone) throws IOException {
    ScriptedOperator.fly(drone, "command", "takeoff", "forward 1000", "stop", "battery?");

    List<JournalEntry> entries = drone.journal().entries();
    assertThat(entries)
        .extracting(JournalEntry::outcome)
        .containsExactly(
            Outcome.ANSWERED,
            Outcome.ANSWERED,
            Outcome.REFUSED,
            Outcome.ANSWERED,
            Outcome.ANSWERED);
    assertThat(entries.get(1).replies()).hasSize(1);
    assertThat(entries.get(1).replies().get(0).delay()).isCloseTo(3.0, Offset.offset(1e-9));
    assertThat(entries.get(2).reply()).isEqualTo("out of range");
    assertThat(entries.get(2).explanation()).contains("20", "500");
    assertThat(drone.journal().refused()).containsExactly(entries.get(2));
  }

  @Test
  void bothAnswersToStopBelongToIt(SimulatedDrone drone, TelloSimulation simulation)
      throws IOException {
    ScriptedOperator.fly(drone, "command", "takeoff", "stop");
    simulation.awaitStill();

    assertThat(drone.journal().entries().get(2).replies())
        .extracting(JournalEntry.Answer::text)
        .containsExactly("ok", "forced stop");
  }

  @Test
  void aCommandIsWaitedForUntilItIsAnswered(SimulatedDrone drone) throws IOException {
    ScriptedOperator.send(drone, "command", "takeoff");

    JournalEntry takeoff = drone.journal().await("takeoff", PATIENCE);

    assertThat(takeoff.reply()).isEqualTo("ok");
    assertThat(drone.truth().flying()).isTrue();
    ScriptedOperator.send(drone, "rc 0 0 20 0");
    assertThat(drone.journal().await("rc", PATIENCE).replies()).isEmpty();
    assertThatThrownBy(() -> drone.journal().await("flip", Duration.ofMillis(5)))
        .isInstanceOf(AssertionError.class)
        .hasMessageStartingWith("drone 1: `flip` did not come within 0.0 s")
        .hasMessageContaining("`takeoff` → `ok` after 3.000 s");
  }

  @Test
  void commandsAreCounted(SimulatedDrone drone) throws IOException {
    ScriptedOperator.fly(drone, "command", "takeoff", "forward 50", "forward 60", "forwards 50");
    Journal journal = drone.journal();

    journal.verify(times(2), "forward");
    journal.verify(times(1), "forward 60");
    journal.verify(atLeast(1), "takeoff");
    journal.verify(atMost(2), "forward");
    journal.never("back");
    assertThatThrownBy(() -> journal.verify(times(1), "forward"))
        .isInstanceOf(AssertionError.class)
        .hasMessageMatching(
            "(?s)drone 1: expected `forward` 1 time, but it came 2 times\\R"
                + " +\\d+\\.\\d{3} s  `forward 50` → `ok` after \\d\\.\\d{3} s\\R"
                + " +\\d+\\.\\d{3} s  `forward 60` → `ok` after \\d\\.\\d{3} s");
    assertThatThrownBy(() -> journal.never("takeoff"))
        .hasMessageStartingWith("drone 1: expected `takeoff` 0 times, but it came 1 time");
    assertThatThrownBy(() -> journal.verify(atMost(1), "forward"))
        .hasMessageStartingWith("drone 1: expected `forward` at most 1 time, but it came 2 times");
    assertThatIllegalArgumentException().isThrownBy(() -> times(-1));
  }

  @Test
  void whatIsNoCommandIsKeptButNotCounted(SimulatedDrone drone) throws IOException {
    ScriptedOperator.send(drone, "takeoff"); // before `command`

    assertThat(drone.journal().await("takeoff", PATIENCE))
        .hasToString("    0.000 s  `takeoff` ignored: the drone waits for `command` first");
    assertThat(drone.journal().commands()).isEmpty();
  }

  @Test
  void manyAlikeAreToldInOneLine(SimulatedDrone drone) throws IOException {
    ScriptedOperator.fly(drone, "command");
    for (int i = 0; i < 20; i++) {
      ScriptedOperator.send(drone, "rc 0 0 0 " + i);
    }
    drone.journal().await("rc 0 0 0 19", PATIENCE);

    assertThat(drone.journal().toString().lines())
        .hasSize(3)
        .last()
        .asString()
        .contains("19 more `rc`");
  }

  @Test
  void anEmptyJournalSaysSo(SimulatedDrone drone) {
    assertThat(drone.journal()).hasToString("  nothing came to drone 1");
  }

  @Test
  void whatFaultsTakeAwayIsExplained(SimulatedDrone drone, TelloSimulation simulation)
      throws IOException {
    ScriptedOperator.fly(drone, "command");
    simulation.faults().inject("loss replies 100%");
    ScriptedOperator.send(drone, "battery?");
    JournalEntry unheard = drone.journal().await("battery?", PATIENCE);
    simulation.awaitStill();
    assertThat(drone.journal().entries().get(1).explanation())
        .isEqualTo("the answer was lost by the fault loss replies 100%");
    assertThat(unheard.reply()).isEqualTo("100");

    simulation.faults().inject("loss commands 100%");
    assertThat(simulation.faults().running(1))
        .containsExactly("loss replies 100%", "loss commands 100%");
    ScriptedOperator.send(drone, "takeoff");

    assertThat(drone.journal().await("takeoff", PATIENCE).outcome()).isEqualTo(Outcome.LOST);
    assertThat(drone.journal().commands()).containsExactly("command", "battery?");
    simulation.faults().clear();
    assertThat(ScriptedOperator.fly(drone, "takeoff")).containsExactly("ok");
  }

  @Test
  void faultsThatCannotBeAreNamed(TelloSimulation simulation) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> simulation.faults().inject("lass state 10%"))
        .withMessageContaining("did you mean loss?");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> simulation.faults().inject("loss state 10% drone 2"))
        .withMessage("there is no drone 2, only drone 1");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> simulation.faults().link("labb"))
        .withMessageContaining("did you mean lab?");
  }

  @TelloTest(link = "lab", faults = "loss state 50%", seed = 3)
  void aTestBeginsWithItsOwn(TelloSimulation simulation) {
    assertThat(simulation.faults().running(1)).containsExactly("loss state 50%");
  }

  @Test
  void packetsOfTheAppAreNamedInWords(SimulatedDrone drone) throws IOException {
    ScriptedOperator.send(
        drone, AppPackets.CONNECT, AppPackets.SSID, AppPackets.TAKEOFF, AppPackets.STICKS);
    Journal journal = drone.journal();

    assertThat(journal.await("takeoff", PATIENCE).reply()).isEqualTo("ok");
    assertThat(journal.await("rc", PATIENCE).replies()).isEmpty();
    assertThat(journal.await("ssid? (app)", PATIENCE).reply()).isEqualTo("TELLO-000001");
    assertThat(journal.commands())
        .startsWith("conn_req (app)", "ssid? (app)", "takeoff (app)", "rc 0 50 0 -100 (app)");
    journal.never("land");
  }
}
