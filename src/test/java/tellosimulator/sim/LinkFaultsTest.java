package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.command.OperatorRule;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.model.FlightPhase;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.testing.SteppedDrone.Sent;
import tellosimulator.time.PendingWork;
import tellosimulator.time.TimeFactor;

/** The effects of link faults on the wire. */
class LinkFaultsTest {

  /** An operator that receives state lines no matter how long it is silent. */
  private static final InetSocketAddress NEIGHBOR = SteppedDrone.address("127.0.0.1", 9000);

  @Test
  void lossOfStateLosesThatShareOfTheLines() {
    SteppedDrone drone = with("loss state 20%");
    drone.send(NEIGHBOR, "command");
    drone.advance(500);

    assertThat(drone.stateLines().size()).isBetween(3900, 4100); // of 5000, ± 3.5 sigma
  }

  @Test
  void burstsLoseAsManyButInARow() {
    SteppedDrone drone = with("loss state 20% burst 5");
    drone.send(NEIGHBOR, "command");
    drone.advance(500);

    List<Integer> gaps = gaps(drone.stateLines());
    assertThat(gaps.stream().mapToInt(Integer::intValue).sum()).isBetween(800, 1200);
    assertThat(gaps.stream().mapToInt(Integer::intValue).average().orElseThrow())
        .isBetween(4.0, 6.0);
  }

  @Test
  void aLostCommandIsNeverCarriedOutAndTheLogSaysWhy() {
    SteppedDrone drone = with("loss commands 100% after \"command\"");
    drone.ask("command");
    drone.send("takeoff");
    drone.advance(5);

    assertThat(drone.replies()).extracting(Sent::text).containsExactly("ok");
    assertThat(drone.state().motion().position().z()).isZero();
    assertThat(words(drone))
        .contains(
            "`takeoff` from 192.168.10.2:9000 was lost by the fault loss commands 100% after"
                + " \"command\"");
  }

  @Test
  void aLostReplyBelongsToACommandThatIsCarriedOut() {
    SteppedDrone drone = with("loss replies 100% after takeoff for 5s");
    drone.ask("command");
    drone.send("takeoff");
    drone.advance(6);

    assertThat(drone.replies()).extracting(Sent::text).containsExactly("ok");
    assertThat(drone.state().motion().position().z()).isGreaterThan(0.2);
    assertThat(drone.ask("forward 50")).isEqualTo("ok");
  }

  @Test
  void aDelayedReplyComesLater() {
    SteppedDrone drone = with("delay replies 100ms");
    drone.send("command");
    drone.advance(0.095);
    assertThat(drone.replies()).isEmpty();
    drone.advance(0.005);
    assertThat(drone.replies()).extracting(Sent::text).containsExactly("ok");
  }

  @Test
  void aDelayedCommandIsCarriedOutLater() {
    SteppedDrone drone = with("delay commands 200ms");
    drone.ask("command");

    assertThat(drone.events())
        .filteredOn(SimEvent.CommandReceived.class::isInstance)
        .extracting(event -> event.time().seconds())
        .containsExactly(0.2);
  }

  @Test
  void aDuplicatedCommandIsCarriedOutTwice() {
    SteppedDrone drone = with("duplicate commands 100%");
    drone.send("command");
    drone.send("battery?");

    assertThat(drone.replies())
        .extracting(Sent::text)
        .containsExactly("ok", "ok", "100\r\n", "100\r\n");
  }

  @Test
  void duplicatedStateLinesAreTheSame() {
    SteppedDrone drone = with("duplicate state 100%");
    drone.ask("command");
    drone.advance(1);

    List<Sent> lines = drone.stateLines();
    assertThat(lines).hasSize(22);
    IntStream.range(0, 11)
        .forEach(i -> assertThat(lines.get(2 * i)).isEqualTo(lines.get(2 * i + 1)));
  }

  @Test
  void reorderedStateLinesAreOlderThanTheLineBefore() {
    SteppedDrone drone = with("reorder state 30%");
    drone.ask("command");
    drone.ask("takeoff");
    drone.advance(10);

    List<Integer> times =
        drone.stateLines().stream()
            .map(line -> Integer.parseInt(line.text().replaceFirst("(?s).*;time:(\\d+);.*", "$1")))
            .toList();
    assertThat(times).isNotEqualTo(times.stream().sorted().toList());
  }

  @Test
  void aCorruptCommandIsUnknownOrNothing() {
    SteppedDrone drone = with("corrupt commands 100% after \"command\"");
    drone.ask("command");
    drone.send("takeoff");
    drone.advance(1);

    assertThat(drone.state().motion().position().z()).isZero();
    assertThat(drone.events())
        .filteredOn(SimEvent.CommandReceived.class::isInstance)
        .extracting(event -> ((SimEvent.CommandReceived) event).text())
        .doesNotContain("takeoff");
  }

  @Test
  void aCorruptStateLineHasTheSameLengthAndOtherBytes() {
    SteppedDrone drone = with("corrupt state 100%");
    SteppedDrone sound = with();
    for (SteppedDrone each : List.of(drone, sound)) {
      each.ask("command");
      each.advance(0.5);
    }

    for (int i = 0; i < sound.stateLines().size(); i++) {
      String wrong = drone.stateLines().get(i).text();
      assertThat(wrong).hasSameSizeAs(sound.stateLines().get(i).text());
      assertThat(wrong).isNotEqualTo(sound.stateLines().get(i).text());
    }
  }

  /**
   * A state line of about 160 bytes with 42 bytes of headers takes 0.2 s at 8.08 kbit/s, twice its
   * period.
   */
  @Test
  void aSlowLinkLetsHalfOfTheStateLinesThrough() {
    SteppedDrone drone = with("bandwidth state 8.08");
    drone.ask("command");
    drone.advance(20);

    assertThat(drone.stateLines()).hasSizeBetween(95, 101);
  }

  @Test
  void aLinkThatIsCutLetsNothingThroughUntilItIsOver() {
    SteppedDrone drone = with("cut after 2nd \"battery?\" for 2s");
    drone.ask("command");
    drone.ask("battery?");
    drone.send("battery?");
    drone.send("battery?");
    int lines = drone.stateLines().size();
    drone.advance(1.95);
    assertThat(drone.replies()).hasSize(2);
    assertThat(drone.stateLines()).hasSize(lines);

    drone.advance(0.1);
    assertThat(drone.ask("battery?")).isEqualTo("100\r\n");
    assertThat(words(drone))
        .contains(
            "the answer `100` to 192.168.10.2:9000 was lost by the fault cut after 2nd \"battery?\""
                + " for 2s");
  }

  @Test
  void aLateReplyComesAfterTheNextOne() {
    SteppedDrone drone = with("late-reply after \"battery?\" for 1s");
    drone.ask("command");
    drone.send("battery?");
    drone.advance(2);
    assertThat(drone.ask("speed?")).isEqualTo("100.0\r\n");
    drone.advance(8.1);

    assertThat(drone.replies())
        .extracting(Sent::text)
        .containsExactly("ok", "100.0\r\n", "100\r\n");
  }

  @Test
  void strayDatagramsComeFromTheCommandSocketTwiceASecond() {
    SteppedDrone drone = with("stray-binary");
    drone.advance(1);
    assertThat(drone.replies()).as("nobody is there").isEmpty();
    drone.ask("command");
    drone.advance(1.5);

    List<String> strays = drone.replies().stream().map(Sent::text).skip(1).toList();
    assertThat(strays).extracting(String::length).containsExactly(12, 13, 35);
    assertThat(strays).allMatch(text -> text.charAt(0) == 0xcc);
  }

  @Test
  void aStrangerIsTurnedAwayUnlessAnyoneMayFly() {
    SteppedDrone drone = with("stranger every 1s");
    drone.ask("command");
    drone.ask("takeoff");
    drone.advance(5);
    assertThat(drone.state().phase()).isEqualTo(FlightPhase.FLYING);
    assertThat(drone.events()).hasAtLeastOneElementOfType(SimEvent.TurnedAway.class);

    SteppedDrone open =
        SteppedDrone.of(config("stranger every 1s").withOperators(OperatorRule.ANYONE));
    open.ask("command");
    open.ask("takeoff");
    open.advance(5);
    assertThat(open.state().phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(open.replies()).extracting(Sent::to).containsOnly(SteppedDrone.CLIENT);
    assertThat(open.ask("forward 50")).isEqualTo("error Motor stop");
  }

  @Test
  void aFaultCanBeInjectedAndClearedWhileItRuns() {
    SteppedDrone drone = with();
    drone.ask("command");
    drone.control(new Control.InjectFault(Fault.of("cut state")));
    assertThat(drone.snapshot().faults().faults()).containsExactly(Fault.of("cut state"));
    drone.advance(0.2);
    int lines = drone.stateLines().size();
    drone.advance(1);
    assertThat(drone.stateLines()).hasSize(lines);

    drone.control(new Control.ClearFaults());
    drone.advance(1);
    assertThat(drone.stateLines()).hasSize(lines + 10);
    assertThat(words(drone)).contains("the fault cut state begins", "the fault cut state is over");
  }

  @Test
  void aFaultOfADroneThatIsNotThereIsRefused() {
    assertThatThrownBy(() -> with().control(new Control.InjectFault(Fault.of("cut drone 2"))))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("there is no drone 2, the drones are 1 to 1");
  }

  @Test
  void puttingADroneBackLetsTheFaultsOfTheScenarioHappenAgain() {
    SteppedDrone drone = with("cut state at 0s for 1s");
    for (int i = 1; i <= 2; i++) {
      drone.ask("command");
      drone.ask("takeoff");
      assertThat(words(drone))
          .filteredOn("the fault cut state at 0s for 1s begins"::equals)
          .hasSize(i);
      drone.control(new Control.Reset(1));
    }
  }

  @Test
  void aRestartBeginsWithTheRandomNumbersAnew() {
    SteppedDrone drone = with("loss replies 50%");
    List<String> first = tenAnswers(drone);
    drone.control(new Control.NewRun(config("loss replies 50%")));
    drone.control(new Control.Power(1, true));

    assertThat(tenAnswers(drone)).isEqualTo(first);
    assertThat(tenAnswers(drone)).isNotEqualTo(first);
  }

  private static List<String> tenAnswers(SteppedDrone drone) {
    int before = drone.replies().size();
    for (int i = 0; i < 10; i++) {
      drone.send(i == 0 ? "command" : "foo " + i);
      drone.advance(0.1);
    }
    return drone.replies().stream().skip(before).map(Sent::text).toList();
  }

  @Test
  void withTimeFactorMaxTimePassesWhileSomethingIsOnItsWay() {
    Simulation simulation =
        new Simulation(
            config("delay commands 100ms", "delay replies 200ms").withTimeFactor(TimeFactor.MAX),
            drone -> datagram -> {},
            List.of());
    simulation.control(new Control.Power(1, true));
    simulation.submit(1, new Peer(NEIGHBOR, SteppedDrone.DRONE), WireText.encode("battery?"));
    simulation.submit(1, new Peer(NEIGHBOR, SteppedDrone.DRONE), WireText.encode("command"));
    simulation.drain();
    assertThat(simulation.demand()).isEqualTo(PendingWork.REPLY);
    assertThat(simulation.pending()).as("the second one waits for its turn").isTrue();
    while (simulation.demand() == PendingWork.REPLY || simulation.pending()) {
      simulation.step();
    }

    assertThat(simulation.pending()).isFalse();
    assertThat(simulation.snapshot().time().seconds()).isBetween(0.4, 0.5);
  }

  private static SimConfig config(String... faults) {
    return SimConfig.DEFAULT
        .withLink(LinkPreset.IDEAL)
        .withFaults(List.of(faults).stream().map(Fault::of).toList());
  }

  private static SteppedDrone with(String... faults) {
    return SteppedDrone.of(config(faults));
  }

  private static List<String> words(SteppedDrone drone) {
    return drone.events().stream().map(SimEvent::words).toList();
  }

  /** Returns the number of missing lines in each gap. */
  private static List<Integer> gaps(List<Sent> lines) {
    List<Integer> missing = new ArrayList<>();
    IntStream.range(1, lines.size())
        .map(i -> (int) Math.round((lines.get(i).seconds() - lines.get(i - 1).seconds()) * 10) - 1)
        .filter(gap -> gap > 0)
        .forEach(missing::add);
    return missing;
  }
}
