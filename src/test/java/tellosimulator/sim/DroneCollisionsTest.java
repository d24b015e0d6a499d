package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.testing.TextPort;
import tellosimulator.time.PendingWork;
import tellosimulator.time.SimTime;
import tellosimulator.world.Room;

/** Collisions between drones. */
class DroneCollisionsTest {

  private static final double SIZE = 2 * DroneSpec.COLLIDER.radius();

  private final List<SimEvent> events = new ArrayList<>();
  private final List<String> replies = new ArrayList<>();

  @Test
  void twoThatMeetSoftlyStopEachOther() {
    Simulation simulation = facing(Behavior.REPORT, 3);
    all(simulation, "command", "takeoff");

    all(simulation, "forward 200");

    double apart = position(simulation, 2).x() - position(simulation, 1).x();
    assertThat(apart).as("side by side").isGreaterThanOrEqualTo(SIZE - 1e-6);
    assertThat(state(simulation, 1).phase()).isEqualTo(FlightPhase.FLYING);
    assertThat(words()).anyMatch(line -> line.startsWith("touched drone 2 at"));
    assertThat(words()).anyMatch(line -> line.startsWith("touched drone 1 at"));
    assertThat(replies).contains("error");
  }

  @Test
  void twoThatMeetHardCrashBoth() {
    Simulation simulation = facing(Behavior.MEASURED, 8);
    all(simulation, "command", "takeoff", "rc 0 100 0 0");
    advance(simulation, 6);

    assertThat(state(simulation, 1).phase()).isEqualTo(FlightPhase.CRASHED);
    assertThat(state(simulation, 2).phase()).isEqualTo(FlightPhase.CRASHED);
    assertThat(words()).anyMatch(line -> line.startsWith("crashed into drone 2 at"));
    assertThat(position(simulation, 1).x()).isLessThan(position(simulation, 2).x());
  }

  /** At 3 m/s each, they approach by 3 cm per step, and are 4 cm high. */
  @Test
  void oneThatStandsIsNotMoved() {
    Simulation simulation = facing(Behavior.REPORT, 1);
    simulation.control(new Control.Power(2, false));
    one(simulation, 1, "command", "takeoff", "down 20");
    Vec3 before = position(simulation, 2);

    one(simulation, 1, "forward 300");

    assertThat(position(simulation, 2)).isEqualTo(before);
  }

  @Test
  void oneThatFallsOnAnotherDoesNotPassIt() {
    Pose start = new Pose(Vec3.ZERO, Attitude.LEVEL);
    Pose beside = new Pose(new Vec3(0, 1, 0), Attitude.LEVEL);
    Simulation simulation = simulation(Behavior.REPORT, start, beside);
    all(simulation, "command", "takeoff");
    one(simulation, 2, "up 200", "right 100");
    one(simulation, 2, "emergency");

    for (int i = 0; i < 300; i++) {
      advance(simulation, SimTime.STEP);
      Vec3 offset = position(simulation, 2).minus(position(simulation, 1));
      boolean beneath = offset.horizontal().norm() < SIZE - 0.001;
      if (beneath) {
        assertThat(Math.abs(offset.z())).isGreaterThan(DroneSpec.COLLIDER.height() - 1e-6);
      }
    }
    assertThat(words())
        .anyMatch(line -> line.contains("into drone") || line.contains("touched drone"));
    advance(simulation, 3);
    assertThat(position(simulation, 2).z()).as("slipped off and fallen").isZero();
    assertThat(simulation.demand()).isEqualTo(PendingWork.NONE);
  }

  @Test
  void theDistanceSensorSeesADroneBelow() {
    Pose start = new Pose(Vec3.ZERO, Attitude.LEVEL);
    Pose beside = new Pose(new Vec3(0, 1, 0), Attitude.LEVEL);
    Simulation simulation = simulation(Behavior.REPORT, start, beside);
    all(simulation, "command");
    one(simulation, 2, "takeoff", "up 70", "right 100", "tof?");
    String reply = replies.get(replies.size() - 1);

    // 1 m above the floor, and the other drone is 41 mm high
    assertThat(Integer.parseInt(reply.replace("mm", "").strip())).isCloseTo(959, within(10));
  }

  private Simulation facing(Behavior behavior, double apart) {
    return simulation(
        behavior,
        new Pose(new Vec3(-apart / 2, 0, 0), Attitude.LEVEL),
        new Pose(new Vec3(apart / 2, 0, 0), Attitude.ofHeading(Math.PI)));
  }

  private Simulation simulation(Behavior behavior, Pose... starts) {
    SimListener listener =
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            events.add(event);
          }
        };
    Simulation simulation =
        new Simulation(
            SimConfig.DEFAULT
                .withProduct(Profile.EDU, behavior)
                .withLink(LinkPreset.IDEAL)
                .withRoom(new Room(12, 12, 5), List.of(starts)),
            drone -> TextPort.replies(replies::add),
            List.of(listener));
    for (int drone = 1; drone <= starts.length; drone++) {
      simulation.control(new Control.Power(drone, true));
    }
    simulation.drain();
    return simulation;
  }

  /** Sends commands to one drone, each with time to be carried out. */
  private static void one(Simulation simulation, int drone, String... commands) {
    for (String command : commands) {
      submit(simulation, drone, command);
      advance(simulation, command.equals("emergency") ? SimTime.STEP : 7);
    }
  }

  /** Sends commands to both drones at the same time. */
  private static void all(Simulation simulation, String... commands) {
    for (String command : commands) {
      submit(simulation, 1, command);
      submit(simulation, 2, command);
      advance(simulation, command.startsWith("rc") ? SimTime.STEP : 7);
    }
  }

  private static void submit(Simulation simulation, int drone, String text) {
    InetSocketAddress client = SteppedDrone.CLIENT;
    simulation.submit(drone, new Peer(client, SteppedDrone.DRONE), WireText.encode(text));
  }

  private static void advance(Simulation simulation, double seconds) {
    for (long i = Math.round(seconds / SimTime.STEP); i > 0; i--) {
      simulation.step();
    }
  }

  private static DroneState state(Simulation simulation, int drone) {
    return simulation.snapshot().drones().get(drone - 1).state();
  }

  private static Vec3 position(Simulation simulation, int drone) {
    return state(simulation, drone).motion().position();
  }

  private List<String> words() {
    return events.stream().map(SimEvent::words).toList();
  }
}
