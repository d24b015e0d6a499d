package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.world.Arena;
import tellosimulator.world.Room;
import tellosimulator.world.Wind;

/** The flight of a drone in moving air. */
class WindTest {

  private static final Arena HALL = Arena.DEFAULT.withRoom(new Room(20, 20, 5));

  @Test
  void aDroneLeansIntoASteadyWindAndStays() {
    SteppedDrone drone = flying();
    drone.control(blowing(new Vec3(3, 0, 0), 0));
    drone.advance(6);

    // drag of 3 m/s of air: 0.205 · 3 + 0.0458 · 9 = 1.03 m/s², which is g tan 6.0°
    double push = DroneSpec.LINEAR_DRAG * 3 + DroneSpec.QUADRATIC_DRAG * 9;
    double lean = Math.atan(push / DroneSpec.GRAVITY);
    assertThat(drone.state().motion().attitude().elevation())
        .as("nose down against a wind from behind would drift, so nose up")
        .isCloseTo(lean, within(0.01));
    assertThat(drone.state().motion().position().horizontal().norm()).isLessThan(0.01);
    assertThat(drone.ask("forward 100")).isEqualTo("ok");
    assertThat(drone.state().motion().position().x()).isCloseTo(1, within(0.01));
  }

  @Test
  void aWindThatBeginsMovesItForAWhile() {
    SteppedDrone drone = flying();
    drone.control(blowing(new Vec3(0, 3, 0), 0));
    drone.advance(0.6);

    assertThat(drone.state().motion().position().y()).isBetween(0.02, 0.3);
  }

  @Test
  void inAGaleItIsCarriedAway() {
    SteppedDrone drone = flying();
    drone.control(blowing(new Vec3(12, 0, 0), 0));
    drone.advance(3);

    // at most 25 degrees of tilt hold against 8 m/s (Tello User Manual)
    assertThat(drone.state().motion().position().x()).isGreaterThan(2);
  }

  @Test
  void gustsShakeItAndCommandsAreStillAnswered() {
    SteppedDrone drone = flying();
    drone.control(blowing(Vec3.ZERO, 1));
    double farthest = 0;
    for (int i = 0; i < 100; i++) {
      drone.advance(0.1);
      farthest = Math.max(farthest, drone.state().motion().position().horizontal().norm());
    }

    assertThat(farthest).isBetween(0.01, 0.3);
    assertThat(drone.ask("forward 100")).isEqualTo("ok");
    assertThat(drone.ask("cw 90")).isEqualTo("ok");
  }

  @Test
  void aDroneOnTheFloorIsNotMoved() {
    SteppedDrone drone = SteppedDrone.of(SimConfig.DEFAULT.withArena(HALL));
    drone.control(blowing(new Vec3(15, 0, 0), 1));
    drone.advance(2);

    assertThat(drone.state().motion().position()).isEqualTo(Vec3.ZERO);
  }

  @Test
  void onTheFloorADroneForgetsTheWind() {
    SteppedDrone drone = flying();
    drone.control(blowing(new Vec3(5, 0, 0), 0));
    drone.advance(5);
    drone.ask("land");
    Vec3 landed = drone.state().motion().position();
    drone.control(blowing(Vec3.ZERO, 0));
    drone.advance(60);
    drone.send("takeoff");
    double farthest = 0;
    for (int i = 0; i < 30; i++) {
      drone.advance(0.1);
      Vec3 drift = drone.state().motion().position().minus(landed).horizontal();
      farthest = Math.max(farthest, drift.norm());
    }

    assertThat(farthest).isLessThan(1e-3);
  }

  @Test
  void whenTheWindEndsTheFlightIsThatOfStillAirAgain() {
    SteppedDrone drone = flying();
    drone.control(blowing(new Vec3(3, 0, 0), 0));
    drone.advance(5);
    drone.control(blowing(Vec3.ZERO, 0));
    drone.advance(8);

    assertThat(drone.state().motion().attitude().elevation()).isCloseTo(0, within(1e-4));
    assertThat(drone.state().motion().position().horizontal().norm()).isLessThan(0.002);
  }

  private static Control blowing(Vec3 mean, double gusts) {
    return new Control.SetWind(new Wind(mean, gusts));
  }

  private static SteppedDrone flying() {
    SteppedDrone drone = SteppedDrone.of(SimConfig.DEFAULT.withArena(HALL));
    assertThat(drone.ask("command")).isEqualTo("ok");
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
    return drone;
  }
}
