package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.time.SimTime;
import tellosimulator.world.Room;

class RestartTest {

  private static final Peer OPERATOR = new Peer(SteppedDrone.CLIENT, SteppedDrone.DRONE);
  private static final SimConfig CONFIG =
      SimConfig.DEFAULT.withProduct(Profile.EDU, Behavior.MEASURED).withSeed(5);

  private final List<String> sent = new ArrayList<>();
  private final List<SimEvent> events = new ArrayList<>();
  private final Simulation simulation =
      new Simulation(
          CONFIG,
          drone -> datagram -> sent.add(datagram.text()),
          List.of(
              new SimListener() {
                @Override
                public void event(SimEvent event) {
                  events.add(event);
                }
              }));

  @Test
  void theSameCommandsHaveTheSameEffectsAsAtFirst() {
    fly();
    List<String> first = List.copyOf(sent);
    SimSnapshot end = simulation.snapshot();
    assertThat(first).contains("ok").hasSizeGreaterThan(50);
    sent.clear();

    simulation.control(new Control.NewRun(CONFIG));
    simulation.drain();

    SimSnapshot anew = simulation.snapshot();
    assertThat(anew.time()).isEqualTo(SimTime.ZERO);
    assertThat(anew.drones().get(0).state().phase()).isEqualTo(FlightPhase.OFF);
    assertThat(anew.drones().get(0).link().operator()).isEmpty();
    assertThat(events).last().isInstanceOf(SimEvent.RunStarted.class);
    assertThat(sent).isEmpty();
    fly();
    assertThat(sent).isEqualTo(first);
    assertThat(simulation.snapshot()).isEqualTo(end);
  }

  @Test
  void asManyDronesAsBeforeMustBeThere() {
    SimConfig two = CONFIG.withRoom(Room.DEFAULT, Formation.row(2, Vec3.ZERO, Room.DEFAULT));

    assertThatIllegalArgumentException()
        .isThrownBy(() -> simulation.control(new Control.NewRun(two)))
        .withMessage("config has 2 drones, but must have 1");
  }

  @Test
  void whoWaitsForRestIsToldOnceEverythingIsDone() {
    List<Double> told = new ArrayList<>();
    simulation.control(new Control.Power(1, true));
    simulation.submit(1, OPERATOR, WireText.encode("command"));
    simulation.submit(1, OPERATOR, WireText.encode("takeoff"));
    simulation.onceStill(() -> told.add(simulation.snapshot().time().seconds()));

    for (int i = 0; i < 4000; i++) {
      simulation.step();
    }

    assertThat(told).singleElement().satisfies(at -> assertThat(at).isBetween(5.5, 8.0));
  }

  private void fly() {
    simulation.control(new Control.Power(1, true));
    for (String command : List.of("command", "takeoff", "tof?")) {
      simulation.submit(1, OPERATOR, WireText.encode(command));
      for (int i = 0; i < 1600; i++) {
        simulation.step();
      }
    }
  }
}
