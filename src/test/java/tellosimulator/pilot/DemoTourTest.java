package tellosimulator.pilot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.controller.FlightEvent;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.time.SimTime;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Collider;
import tellosimulator.world.Room;

class DemoTourTest {

  /** Clearance from walls and ceiling after the drone has left its start [m]. */
  private static final double AIR = 0.03;

  private static final Collider WITH_AIR =
      new Collider(DroneSpec.COLLIDER.radius() + AIR, DroneSpec.COLLIDER.height() + AIR);

  /** Maximum simulated duration of a command [s]. */
  private static final double PATIENCE = 30;

  private Room room = Room.DEFAULT;
  private SimConfig config = SimConfig.DEFAULT;
  private SteppedDrone drone = SteppedDrone.of(config);

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # width, depth, height, x and y of the start in shares of the way to the walls, heading
          1,    1,    1,    0,  0,   0
          1,    1,    1,    1,  1,   0.7
          1,    1,    1,   -1,  0.5, 3
          1,    200,  1,    1, -1,   0
          1.5,  1.5,  1.5,  1,  1,   0
          1.5,  1.5,  1.2, -1,  1,   2
          1.9,  2.1,  3,    0,  0,   1
          2.1,  2.1,  1,    1,  1,   0
          2.1,  2.1,  1.3,  1, -1,   -2.4
          5,    5,    3,    0,  0,   0
          5,    5,    3,    1,  1,   0.78
          5,    5,    1.4, -1, -1,   0
          20,   20,   20,   0,  0,   0
          20,   20,   20,   1, -1,   1.5
          200,  200,  200, -1,  1,   -0.3
          """)
  void fitsIntoTheRoom(
      double width, double depth, double height, double xShare, double yShare, double heading) {
    room = new Room(width, depth, height);
    Vec3 start =
        new Vec3(
            xShare * (depth / 2 - DroneSpec.COLLIDER.radius()),
            yShare * (width / 2 - DroneSpec.COLLIDER.radius()),
            0);
    for (Behavior behavior : Behavior.values()) {
      for (int seed = 1; seed <= 5; seed++) {
        start(
            SimConfig.DEFAULT
                .withProduct(Profile.EDU, behavior)
                .withRoom(room, List.of(new Pose(start, Attitude.ofHeading(heading))))
                .withSeed(seed));
        flyAndWatch(tour());
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"EDU", "TELLO", "TT"})
  void fliesEachProduct(Profile profile) {
    start(SimConfig.DEFAULT.withProduct(profile, Behavior.REPORT));

    flyAndWatch(tour());
  }

  @Test
  void showsWhatADroneCanDoWhereThereIsSpace() {
    assertThat(tour())
        .containsExactly(
            "command",
            "takeoff",
            "up 90",
            "forward 120",
            "ccw 90",
            "curve 120 120 0 0 240 0 60",
            "cw 90",
            "flip f",
            "go 90 0 40 60",
            "right 80",
            "cw 180",
            "right 80",
            "cw 180",
            "down 40",
            "land");
  }

  @Test
  void isShorterInATinyRoom() {
    room = new Room(1, 1, 1);

    assertThat(tour())
        .containsExactly(
            "command", "takeoff", "forward 21", "cw 180", "forward 21", "cw 180", "land");
  }

  @Test
  void endsWhereItBegan() {
    flyAndWatch(tour());

    assertThat(drone.state().motion().position().distanceTo(Vec3.ZERO)).isLessThan(0.02);
    assertThat(drone.state().motion().attitude().heading()).isBetween(-0.02, 0.02);
  }

  @Test
  void hasNoFlipWithALowBattery() {
    drone.control(new Control.SetBattery(1, 49));

    assertThat(tour()).doesNotContain("flip f").contains("go 120 0 40 60");
  }

  @Test
  void aFlipIsStillPossibleWhenItsTurnComes() {
    drone.control(new Control.SetBattery(1, 58));

    assertThat(tour()).contains("flip f");
    flyAndWatch(tour());
  }

  /** Starts without packet loss, as the tour is about positions. */
  private void start(SimConfig newConfig) {
    config = newConfig.withLink(LinkPreset.IDEAL);
    drone = SteppedDrone.of(config);
  }

  private List<String> tour() {
    return new DemoTour(snapshot(), 1).commands();
  }

  private SimSnapshot snapshot() {
    return new SimSnapshot(
        SimTime.ZERO,
        new SimSnapshot.Clock(TimeFactor.REAL_TIME, false),
        1,
        Arena.DEFAULT.withRoom(room),
        List.of(drone.snapshot()));
  }

  private void flyAndWatch(List<String> tour) {
    for (int i = 0; i < tour.size(); i++) {
      fly(tour.get(i), i >= 3 && i < tour.size() - 1 ? WITH_AIR : DroneSpec.COLLIDER);
    }
    assertThat(drone.state().phase()).as("%s", tour).isEqualTo(FlightPhase.GROUNDED);
    assertThat(drone.events())
        .noneMatch(
            event ->
                event instanceof SimEvent.DroneFlight flight
                    && flight.event() instanceof FlightEvent.Crashed);
  }

  private void fly(String command, Collider collider) {
    int before = drone.replies().size();
    drone.send(command);
    boolean answered =
        drone.advanceUntil(
            () -> {
              Vec3 position = drone.state().motion().position();
              assertThat(room.contains(position, collider))
                  .as("%s at %s in %s of %s", command, position, room, config)
                  .isTrue();
              return drone.replies().size() > before;
            },
            PATIENCE);
    assertThat(answered).as(command).isTrue();
    assertThat(drone.replies().get(before).text()).as(command).isEqualTo("ok");
  }
}
