package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.world.Room;

/** Tests two drones whose flights begin and end together. */
class FlightDetectorTest {

  private final FlightDetector detector = new FlightDetector();
  private final List<String> detected = new ArrayList<>();
  private SimulatedDrones drones;

  /** Calls the detector as the recorder does. */
  private final class Watching implements SimListener {
    @Override
    public void event(SimEvent event) {
      if (detector.begins(event)) {
        detected.add("begins");
      }
      if (drones != null && detector.ends(event, drones.snapshot())) {
        end();
      }
    }

    @Override
    public void stepped(SimSnapshot snapshot) {
      if (detector.ends(snapshot)) {
        end();
      }
    }

    private void end() {
      detector.end();
      detected.add("ends");
    }
  }

  @BeforeEach
  void takeOff() {
    SimConfig two =
        SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(2, Vec3.ZERO, Room.DEFAULT));
    drones = new SimulatedDrones(two, List.of(new Watching()));
    drones.flyAll("command");
    drones.advance(5);
    assertThat(detected).as("on the ground").isEmpty();
    drones.fly(1, "takeoff");
    drones.fly(2, "takeoff");
    assertThat(detected).as("two takeoffs, one flight").containsExactly("begins");
    assertThat(detector.flying()).isTrue();
  }

  @Test
  void aFlightEndsThreeSecondsAfterTheLastDroneIsDown() {
    drones.fly(1, "land");
    drones.advance(5);
    drones.fly(2, "land");
    drones.advance(2);
    assertThat(detected).containsExactly("begins");

    drones.advance(2);

    assertThat(detected).containsExactly("begins", "ends");
    assertThat(detector.flying()).isFalse();
    drones.advance(5);
    drones.fly(1, "takeoff");
    assertThat(detected).containsExactly("begins", "ends", "begins");
  }

  @Test
  void whoTakesOffAgainAtOnceGoesOnWithTheFlight() {
    drones.fly(1, "land");
    drones.fly(2, "land");
    drones.advance(2);
    drones.fly(1, "takeoff");
    drones.advance(2);

    assertThat(detected).containsExactly("begins");
  }

  @Test
  void aFlightEndsAtOnceAsTheLastDroneIsPutBack() {
    drones.control(new Control.Reset(1));
    assertThat(detected).as("the other still flies").containsExactly("begins");

    drones.control(new Control.Reset(2));

    assertThat(detected).containsExactly("begins", "ends");
  }
}
