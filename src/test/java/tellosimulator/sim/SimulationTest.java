package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.testing.SteppedDrone.address;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.fault.Fault;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.testing.CapturedLog;
import tellosimulator.testing.TextPort;
import tellosimulator.time.PendingWork;
import tellosimulator.time.SimTime;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;
import tellosimulator.world.Wind;

class SimulationTest {

  /** Capacity of the inbox for hosts that operate no drone. */
  private static final int INBOX = 3072;

  private static final int AT_ONCE = 256;
  private static final Peer PEER =
      new Peer(address("192.168.10.2", 9000), address("192.168.10.1", 8889));

  private final List<String> replies = new ArrayList<>();
  private final List<String> states = new ArrayList<>();
  private final List<SimEvent> events = new ArrayList<>();
  private final List<SimTime> steps = new ArrayList<>();
  private final SimListener recorder =
      new SimListener() {
        @Override
        public void event(SimEvent event) {
          events.add(event);
        }

        @Override
        public void stepped(SimSnapshot snapshot) {
          steps.add(snapshot.time());
        }
      };

  private final Simulation simulation = simulation(recorder);

  @Test
  void thatTheMachineIsBusyTouchesNoFlight() {
    simulation.tellLost(1.5);
    simulation.step();
    assertThat(simulation.untouched()).isTrue();

    simulation.submit(1, PEER, WireText.encode("battery?"));
    simulation.step();
    assertThat(simulation.untouched()).isFalse();
  }

  @Test
  void aStepMovesTimeOnByFiveMillisecondsAndIsToldLast() {
    simulation.step();
    simulation.step();

    assertThat(steps).containsExactly(new SimTime(5_000_000), new SimTime(10_000_000));
    assertThat(simulation.snapshot().time()).isEqualTo(new SimTime(10_000_000));
  }

  @Test
  void aFloodOfQueriesWhileTimeStandsStillFillsNoMemory() {
    SimConfig config = SimConfig.DEFAULT.withFaults(List.of(Fault.of("delay replies 40ms")));
    Simulation late =
        new Simulation(config, drone -> TextPort.replies(replies::add), List.of(recorder));
    late.control(new Control.Power(1, true));
    int asked = 80 * AT_ONCE;
    for (int i = 0; i < asked; i++) {
      assertThat(late.submit(1, PEER, WireText.encode(i == 0 ? "command" : "battery?"))).isTrue();
      if (i % AT_ONCE == AT_ONCE - 1) {
        late.drain();
      }
    }
    assertThat(replies).isEmpty();
    for (int i = 0; i < 200; i++) {
      late.step();
    }

    int mostForPeer = 1024;
    assertThat(replies).hasSize(mostForPeer);
    List<SimEvent.WaitingDropped> told =
        events.stream()
            .filter(SimEvent.WaitingDropped.class::isInstance)
            .map(SimEvent.WaitingDropped.class::cast)
            .toList();
    assertThat(told).isNotEmpty();
    assertThat(told.stream().mapToLong(SimEvent.WaitingDropped::count).sum())
        .isBetween(1L, (long) asked - mostForPeer);
  }

  /** Otherwise a program that is still being served would see the effect of a later control. */
  @Test
  void aControlIsTakenAfterTheCommandsBeforeItAndBeforeThoseAfterIt() {
    simulation.control(new Control.Power(1, true));
    simulation.submit(1, PEER, WireText.encode("command"));
    simulation.submit(1, PEER, WireText.encode("battery?"));
    simulation.control(new Control.SetBattery(1, 50));
    simulation.submit(1, PEER, WireText.encode("battery?"));
    simulation.drain();

    assertThat(replies).containsExactly("ok", "100\r\n", "50\r\n");
  }

  @Test
  void aControlWaitsForAllCommandsBeforeItHoweverManyThereAre() {
    List<Integer> shown = new ArrayList<>();
    for (int i = 0; i <= AT_ONCE; i++) {
      simulation.submit(
          1, new Peer(address("192.168.10.2", 9000 + i), PEER.via()), WireText.encode("battery?"));
    }
    simulation.control(new Control.SetBattery(1, 50), () -> shown.add(percent()));

    simulation.drain();
    assertThat(percent()).isEqualTo(100);
    assertThat(simulation.pending()).isTrue();
    simulation.drain();
    assertThat(shown).containsExactly(50);
  }

  private int percent() {
    return simulation.snapshot().drones().get(0).state().energy().battery().percent();
  }

  /** The sender of a wind control may not know yet that something else was changed. */
  @Test
  void anotherWindLeavesEverythingElseAsItIs() {
    Room other = new Room(7, 7, 3);
    Wind wind = new Wind(new Vec3(1, 0, 0), 0);

    simulation.control(new Control.SetRoom(other));
    simulation.control(new Control.SetWind(wind));
    simulation.drain();

    assertThat(simulation.snapshot().arena().room()).isEqualTo(other);
    assertThat(simulation.snapshot().arena().wind()).isEqualTo(wind);
  }

  /** The plan may not know yet that the wind has changed. */
  @Test
  void otherObstaclesLeaveWindAndRoomAsTheyAre() {
    Room other = new Room(7, 7, 3);
    Wind wind = new Wind(new Vec3(1, 0, 0), 0);
    List<MissionPad> pads = List.of(MissionPad.onFloor(3, new Vec3(1, 1, 0), 0));

    simulation.control(new Control.SetRoom(other));
    simulation.control(new Control.SetWind(wind));
    simulation.control(new Control.Furnish(List.of(), pads));
    simulation.drain();

    Arena arena = simulation.snapshot().arena();
    assertThat(arena).isEqualTo(Arena.DEFAULT.withRoom(other).withWind(wind).withPads(pads));
  }

  @Test
  void otherLooksOfTheRoomAreInTheNextSnapshot() {
    assertThat(simulation.snapshot().decor()).isEqualTo(Decor.DEFAULT);
    Poster poster = new Poster(Surface.LEFT_WALL, 0.5, 1.5, 0.3, "face.png");
    Decor other = Decor.DEFAULT.withWalls(Walls.PLAIN).withGrid(1).withPosters(List.of(poster));

    simulation.control(new Control.Decorate(other));
    simulation.drain();

    assertThat(simulation.snapshot().decor()).isEqualTo(other);
    assertThat(simulation.snapshot().time()).isEqualTo(SimTime.ZERO);
  }

  @Test
  void aListenerThatThrowsNeitherStopsTheStepNorTheOtherListeners() throws InterruptedException {
    SimListener broken =
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            throw new IllegalStateException("broken on purpose");
          }

          @Override
          public void stepped(SimSnapshot snapshot) {
            throw new IllegalStateException("broken on purpose");
          }
        };
    Simulation tested = simulation(broken, recorder);

    try (CapturedLog log = CapturedLog.of(Simulation.class)) {
      tested.control(new Control.Power(1, true));
      tested.submit(1, PEER, WireText.encode("command"));
      tested.submit(1, PEER, WireText.encode("battery?"));
      tested.step();

      do {
        assertThat(log.next()).startsWith("A listener failed; please report this: ");
      } while (!log.isEmpty());
    }
    assertThat(replies).containsExactly("ok", "100\r\n");
    assertThat(events)
        .filteredOn(SimEvent.CommandReceived.class::isInstance)
        .extracting(SimEvent::words)
        .hasSize(2);
    assertThat(steps).containsExactly(new SimTime(5_000_000));
    assertThat(tested.snapshot().time()).isEqualTo(new SimTime(5_000_000));
  }

  @Test
  void aListenerMaySubmitCommandsForTheNextStep() {
    List<Simulation> self = new ArrayList<>();
    SimListener operator =
        new SimListener() {
          @Override
          public void stepped(SimSnapshot snapshot) {
            self.get(0).submit(1, PEER, WireText.encode("command"));
          }
        };
    Simulation tested = simulation(operator);
    self.add(tested);
    tested.control(new Control.Power(1, true));

    tested.step();
    assertThat(replies).isEmpty();
    tested.step();
    assertThat(replies).containsExactly("ok");
  }

  @ParameterizedTest
  @ValueSource(ints = {0, -1, 3, Integer.MAX_VALUE})
  void thereAreControlsAndCommandsOnlyForExistingDrones(int drone) {
    String message = "there is no drone " + drone + ", the drones are 1 to 2";

    assertThatIllegalArgumentException()
        .isThrownBy(() -> simulation.control(new Control.Reset(drone)))
        .withMessage(message);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> simulation.control(new Control.Power(drone, true)))
        .withMessage(message);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> simulation.submit(drone, PEER, WireText.encode("command")))
        .withMessage(message);

    simulation.step();
    assertThat(events).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.1, 100.1, Double.NaN})
  void aBatteryHasNoOtherLevels(double percent) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Control.SetBattery(1, percent))
        .withMessage("battery is " + percent + " %, but must be from 0 to 100");
  }

  /** Returns one of many programs on the same host. */
  private static Peer sender(int number) {
    return new Peer(address("127.0.0.1", 20_000 + number % 100), PEER.via());
  }

  @Test
  void aFullInboxLosesWhatComesOnTop() {
    simulation.control(new Control.Power(1, true));
    for (int i = 0; i < INBOX; i++) {
      assertThat(simulation.submit(1, sender(i), WireText.encode("command"))).isTrue();
    }

    assertThat(simulation.submit(1, PEER, WireText.encode("command"))).isFalse();
    assertThat(simulation.submit(2, PEER, WireText.encode("command"))).isFalse();

    simulation.drain();
    assertThat(simulation.submit(1, PEER, WireText.encode("command"))).isTrue();
  }

  @Test
  void aFloodIsTakenInPartsSoThatTimeGoesOn() {
    simulation.control(new Control.Power(1, true));
    for (int i = 0; i < INBOX; i++) {
      simulation.submit(1, sender(i), WireText.encode("command"));
    }

    simulation.step();
    assertThat(replies).hasSize(AT_ONCE);
    assertThat(steps).hasSize(1);

    for (int i = 1; i < INBOX / AT_ONCE; i++) {
      simulation.step();
    }
    assertThat(replies).hasSize(INBOX);
  }

  @Test
  void aDroneThatIsOffAnswersNothingAndTheEventSaysWhy() {
    simulation.submit(1, PEER, WireText.encode("command"));
    simulation.step();

    assertThat(replies).isEmpty();
    assertThat(events)
        .extracting(SimEvent::words)
        .containsExactly("`command` from " + PEER + " ignored: the drone is off");
    assertThat(state(1).phase()).isEqualTo(FlightPhase.OFF);
  }

  @Test
  void whereNobodyTakesRepliesTheSessionEndsAndTheDroneIsFree() {
    operatedFromElsewhere();

    simulation.unreachable(1, address("192.168.1.9", 40_000));
    simulation.unreachable(1, address("192.168.1.7", 40_001));
    simulation.drain();
    assertThat(simulation.snapshot().drones().get(0).link().sdkMode()).isTrue();

    simulation.unreachable(1, REMOTE.address());
    simulation.drain();
    assertThat(simulation.snapshot().drones().get(0).link().sdkMode()).isFalse();
    assertThat(events).last().extracting(SimEvent::words).asString().startsWith("is free, because");
  }

  @Test
  void stateThatNobodyTakesRestsAndTheSessionGoesOn() {
    operatedFromElsewhere();
    simulation.unreachable(1, address("192.168.1.7", 8890));
    int before = states.size();
    for (int i = 0; i < 200; i++) { // one second; the next try is after two
      simulation.step();
    }
    assertThat(states).hasSize(before);
    assertThat(simulation.snapshot().drones().get(0).link().sdkMode()).isTrue();

    simulation.submit(1, REMOTE, WireText.encode("battery?"));
    for (int i = 0; i < 200; i++) {
      simulation.step();
    }
    assertThat(states.size() - before).isBetween(9, 11);
  }

  private static final Peer REMOTE =
      new Peer(address("192.168.1.7", 40_000), address("192.168.1.2", 8879));

  private void operatedFromElsewhere() {
    simulation.control(new Control.Power(1, true));
    simulation.submit(1, REMOTE, WireText.encode("command"));
    simulation.step();
  }

  @Test
  void powerConcernsOneDrone() {
    simulation.control(new Control.Power(2, true));
    simulation.drain();

    assertThat(state(1).phase()).isEqualTo(FlightPhase.OFF);
    assertThat(state(2).phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(events).extracting(event -> ((SimEvent.ForDrone) event).drone()).containsExactly(2);
  }

  @Test
  void controlsAreSeenAtOnceWhileTimeStandsStill() {
    simulation.control(new Control.Pause(true));
    simulation.control(new Control.SetTimeFactor(TimeFactor.MAX));
    simulation.control(new Control.SetBattery(2, 42));
    simulation.drain();

    assertThat(simulation.snapshot().clock())
        .isEqualTo(new SimSnapshot.Clock(TimeFactor.MAX, true));
    assertThat(state(1).energy().battery().percent()).isEqualTo(100);
    assertThat(state(2).energy().battery().percent()).isEqualTo(42);
    assertThat(simulation.snapshot().time()).isEqualTo(SimTime.ZERO);
    assertThat(events)
        .extracting(SimEvent::line)
        .containsExactly(
            "    0.000 s  all: time stands still",
            "    0.000 s  all: the time factor is max now",
            "    0.000 s  drone 2: has 42 % of its battery now");
  }

  @Test
  void aDroneOnTheGroundTurnsWithItsStart() {
    simulation.control(new Control.SetStart(1, new Vec3(1, 0.5, 0), Math.PI / 2));
    simulation.drain();

    assertThat(state(1).motion().attitude().heading()).isCloseTo(Math.PI / 2, within(1e-12));
    simulation.control(new Control.Reset(1));
    simulation.drain();
    assertThat(state(1).motion().attitude().heading()).isCloseTo(Math.PI / 2, within(1e-12));
    assertThat(state(1).motion().position()).isEqualTo(new Vec3(1, 0.5, 0));
  }

  @Test
  void aSmallerRoomTakesDronesAndStartsIn() {
    simulation.control(new Control.SetStart(1, new Vec3(2, -2, 0)));
    simulation.drain();
    assertThat(state(1).motion().position()).isEqualTo(new Vec3(2, -2, 0));

    Room small = new Room(2, 3, 2);
    simulation.control(new Control.SetRoom(small));
    simulation.drain();

    assertThat(simulation.snapshot().room()).isEqualTo(small);
    assertThat(state(1).motion().position())
        .isEqualTo(small.nearestInside(new Vec3(2, -2, 0), DroneSpec.COLLIDER));
    simulation.control(new Control.Reset(1));
    simulation.drain();
    assertThat(small.contains(state(1).motion().position(), DroneSpec.COLLIDER)).isTrue();
  }

  @Test
  void lostTimeIsInTheNextSnapshotAndToldInSums() {
    simulation.noteLost(1.5);
    simulation.tellLost(0.5);
    simulation.control(new Control.Pause(true));
    simulation.step();

    assertThat(simulation.snapshot().clock().lostSeconds()).isEqualTo(1.5);
    assertThat(events.get(0).words())
        .isEqualTo("0.5 s of simulated time left out: this machine is busy");
    assertThat(events.get(0).severity())
        .as("no problem of the flight")
        .isEqualTo(Severity.INFORMATION);
  }

  @Test
  void asFastAsPossibleASafetyLandingIsExplainedOnce() {
    simulation.control(new Control.SetTimeFactor(TimeFactor.MAX));
    for (int drone = 1; drone <= 2; drone++) {
      simulation.control(new Control.Power(drone, true));
      simulation.submit(drone, PEER, WireText.encode("command"));
      simulation.submit(drone, PEER, WireText.encode("takeoff"));
    }
    for (int i = 0; i < 4500; i++) {
      simulation.step();
    }

    assertThat(events).filteredOn(event -> event.words().startsWith("lands by itself")).hasSize(2);
    assertThat(events)
        .filteredOn(event -> event.words().contains("--no-safety-landing"))
        .hasSize(1);
  }

  @Test
  void aDroneWithoutSafetyLandingStaysInTheAir() {
    SimConfig config = SimConfig.DEFAULT;
    Simulation patient =
        new Simulation(
            config.withDrones(List.of(config.drones().get(0).withoutSafetyLanding())),
            drone -> TextPort.replies(replies::add),
            List.of());
    patient.control(new Control.Power(1, true));
    patient.submit(1, PEER, WireText.encode("command"));
    patient.submit(1, PEER, WireText.encode("takeoff"));
    for (int i = 0; i < 12_000; i++) {
      patient.step();
    }

    assertThat(patient.snapshot().drones().get(0).state().phase()).isEqualTo(FlightPhase.FLYING);
  }

  @Test
  void timeCanBeLetPassThoughNothingMoves() {
    simulation.control(new Control.SetTimeFactor(TimeFactor.MAX));
    simulation.control(new Control.PassTime(15));
    simulation.drain();
    int steps = 0;
    while (simulation.demand() == PendingWork.REPLY && steps < 10_000) {
      simulation.step();
      steps++;
    }

    assertThat(steps).isEqualTo(3000);
  }

  @Test
  void timeNeedNotPassBeforeSomebodyFlies() {
    assertThat(simulation.demand()).isEqualTo(PendingWork.NONE);
    simulation.control(new Control.Power(1, true));
    simulation.submit(1, PEER, WireText.encode("command"));
    simulation.submit(1, PEER, WireText.encode("takeoff"));
    simulation.drain();

    assertThat(simulation.demand()).isEqualTo(PendingWork.REPLY);
  }

  private DroneState state(int drone) {
    return simulation.snapshot().drones().get(drone - 1).state();
  }

  private Simulation simulation(SimListener... listeners) {
    SimConfig config =
        SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(2, Vec3.ZERO, Room.DEFAULT));
    return new Simulation(
        config, drone -> TextPort.of(replies::add, states::add), List.of(listeners));
  }
}
