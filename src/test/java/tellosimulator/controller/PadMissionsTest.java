package tellosimulator.controller;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

/** Mission pads from {@code mon} to {@code jump}, as a client sees them. */
class PadMissionsTest {

  private static final Room ROOM = new Room(8, 8, 4);

  /** A pad below the start, with its rocket pointing to the left. */
  private static final MissionPad ONE = MissionPad.onFloor(1, Vec3.ZERO, Math.PI / 2);

  private static final MissionPad TWO = MissionPad.onFloor(2, new Vec3(1, 0.5, 0), 0);

  private static final String NOTHING = "mid:-1;x:-100;y:-100;z:-100;mpry:-1,-1,-1;";

  @Test
  void theStateLineSaysWhetherADroneLooksForPadsAndWhatItSees() {
    SteppedDrone drone = flying(ONE);
    assertThat(line(drone)).startsWith("mid:-2;x:-200;y:-200;z:-200;mpry:-1,-1,-1;");

    drone.ask("mon");
    assertThat(line(drone)).startsWith("mid:1;x:0;y:0;z:30;mpry:0,-90,0;");
    drone.ask("up 100");
    assertThat(line(drone)).as("130 cm are too high").startsWith(NOTHING);
    drone.ask("down 50");
    assertThat(line(drone)).startsWith("mid:1;x:0;y:0;z:80;");
    drone.ask("moff");
    assertThat(line(drone)).startsWith("mid:-2;");
  }

  /** At 80 cm the picture reaches 80 cm · tan 27.5° = 42 cm ahead and 31 cm to each side. */
  @ParameterizedTest
  @CsvSource({"0.40, 0, true", "0.44, 0, false", "0, 0.29, true", "0, 0.34, false"})
  void aPadIsSeenAsFarAsThePictureReaches(double x, double y, boolean seen) {
    SteppedDrone drone = flying(MissionPad.onFloor(5, new Vec3(x, y, 0), 0));
    drone.ask("up 50");
    drone.ask("mon");

    assertThat(line(drone).startsWith("mid:5;")).isEqualTo(seen);
  }

  @Test
  void positionsAreThoseOfTheDroneInThePadsFrame() {
    SteppedDrone drone = flying(MissionPad.onFloor(4, new Vec3(0.2, 0.1, 0), Math.PI / 2));
    drone.ask("up 50");
    drone.ask("mon");

    // from the pad the drone is at (-20, -10) cm, and the rocket points to the left
    assertThat(line(drone)).startsWith("mid:4;x:-10;y:20;z:80;mpry:0,-90,0;");
  }

  @Test
  void aPadOnAWallIsSeenAhead() {
    MissionPad wall = new MissionPad(7, Surface.FRONT_WALL, 0, 0.3, 0);
    SteppedDrone drone = flying(wall);
    drone.ask("mon");
    drone.ask("forward 300");
    assertThat(line(drone)).as("the wall is 4 m from the start").startsWith("mid:7;x:0;y:0;z:100;");
    drone.ask("mdirection 0");
    assertThat(line(drone)).startsWith(NOTHING);
    drone.ask("mdirection 1");
    assertThat(line(drone)).startsWith("mid:7;");
    assertThat(drone.ask("go 50 0 50 50 m7")).as("not below").isEqualTo("error No valid marker");
  }

  @Test
  void aPadUnderATableIsNotSeen() {
    Obstacle table =
        new Obstacle(
            "table",
            new Shape.Box(0.5, 0.5, 0.02),
            new Vec3(0.42, 0, 0.2),
            0,
            ObstacleAppearance.DEFAULT);
    SteppedDrone drone =
        flying(
            arena(MissionPad.onFloor(3, new Vec3(0.42, 0, 0), 0)).withObstacles(List.of(table)),
            Profile.EDU);
    drone.ask("up 60");
    drone.ask("mon");

    assertThat(line(drone)).startsWith(NOTHING);
  }

  @Test
  void goFliesInThePadsFrameAndKeepsTheHeading() {
    SteppedDrone drone = flying(ONE);
    drone.ask("mon");

    assertThat(drone.ask("go 60 20 80 50 m1")).isEqualTo("ok");

    // x along the rocket is the room's y, and y to the rocket's left is the room's -x
    assertNear(drone, new Vec3(-0.2, 0.6, 0.8));
    assertThat(drone.state().motion().attitude().heading()).isCloseTo(0, within(0.01));
  }

  @Test
  void goWithoutThePadHoversAndSaysSo() {
    SteppedDrone drone = flying(ONE);
    assertThat(drone.ask("go 50 0 50 50 m1"))
        .as("mon is missing")
        .isEqualTo("error No valid marker");
    assertThat(words(drone)).anyMatch(line -> line.contains("pad detection is off"));
    drone.ask("mon");
    assertThat(drone.ask("go 50 0 50 50 m2")).isEqualTo("error No valid marker");
    assertThat(words(drone)).anyMatch(line -> line.contains("does not see the pad m2"));
    assertNear(drone, new Vec3(0, 0, 0.3));
    assertThat(drone.ask("go 600 0 50 50 m1")).isEqualTo("out of range");
    assertThat(drone.ask("go 10 10 10 50 m1")).isEqualTo("out of range");
  }

  @Test
  void onTheGroundMotorsMustRunFirst() {
    SteppedDrone drone = SteppedDrone.of(SimConfig.DEFAULT.withArena(arena(ONE)));
    drone.ask("command");
    drone.ask("mon");

    assertThat(drone.ask("go 50 0 50 50 m1")).isEqualTo("error Motor stop");
    assertThat(drone.ask("jump 50 0 50 50 0 m1 m2")).isEqualTo("error Motor stop");
  }

  @Test
  void aPadThatStaysOutOfSightEndsTheFlight() {
    SteppedDrone drone = flying(ONE);
    drone.ask("mon");
    double begin = drone.seconds();

    // 350 cm at 10 cm/s take 35 s, and the pad is out of sight after about 20 cm
    assertThat(drone.ask("go 350 0 30 10 m1")).isEqualTo("error Run timeout");

    assertThat(drone.seconds() - begin).isBetween(16.0, 20.0);
    assertThat(words(drone)).anyMatch(line -> line.contains("has not seen the pad m1 for 15.2 s"));
    drone.advance(2);
    assertThat(drone.state().motion().velocity().norm()).isLessThan(0.01);
  }

  /**
   * From 1 m up, the forward camera sees the pad again from 1.4 to 1.7 m away, which does not count
   * as seeing it below the drone.
   */
  @Test
  void aPadThatOnlyTheNoseSeesIsOutOfSight() {
    SteppedDrone drone = flying(MissionPad.onFloor(1, Vec3.ZERO, 0));
    drone.ask("mon");
    drone.ask("up 70");
    double begin = drone.seconds();

    assertThat(drone.ask("go -350 0 100 10 m1")).isEqualTo("error Run timeout");

    assertThat(drone.seconds() - begin).isBetween(18.0, 23.0);
  }

  @Test
  void minusOneIsThePadSeenFirstAndMinusTwoTheNearest() {
    MissionPad near = MissionPad.onFloor(6, new Vec3(0.35, 0, 0), 0);
    SteppedDrone drone = flying(MissionPad.onFloor(3, Vec3.ZERO, 0), near);
    drone.ask("mon");
    drone.ask("up 70");
    drone.ask("forward 30");
    assertThat(line(drone)).as("the nearest is reported").startsWith("mid:6;");

    assertThat(drone.ask("go 0 0 80 50 m-2")).isEqualTo("ok");
    assertNear(drone, new Vec3(0.35, 0, 0.8));
    drone.control(new Control.Decorate(Decor.DEFAULT)); // does not reset the perception
    drone.ask("up 20");
    assertThat(drone.ask("go 0 0 60 50 m-1")).isEqualTo("ok");
    assertNear(drone, new Vec3(0, 0, 0.6));
  }

  @Test
  void whatWasSeenBeforeDetectionWasOffDoesNotCount() {
    MissionPad ahead = MissionPad.onFloor(6, new Vec3(0.35, 0, 0), 0);
    SteppedDrone drone = flying(MissionPad.onFloor(3, Vec3.ZERO, 0), ahead);
    drone.ask("mon"); // at 30 cm only pad 3 is in sight
    drone.advance(1);
    drone.ask("moff");
    drone.ask("up 50");
    drone.ask("forward 25");
    drone.ask("mon"); // both come into sight at once, and pad 6 is nearer
    drone.advance(1);

    assertThat(drone.ask("go 0 0 80 50 m-1")).isEqualTo("ok");
    assertNear(drone, new Vec3(0.35, 0, 0.8));
  }

  @Test
  void curveFliesThroughPointsOfThePadsFrame() {
    SteppedDrone drone = flying(MissionPad.onFloor(1, Vec3.ZERO, 0));
    drone.ask("mon");
    drone.ask("up 50");

    assertThat(drone.ask("curve 60 60 80 0 120 80 40 m1")).isEqualTo("ok");
    assertNear(drone, new Vec3(0, 1.2, 0.8));
  }

  @Test
  void curveAnswersForItsRadiusWhereThePadIsSeen() {
    SteppedDrone drone = flying(MissionPad.onFloor(1, Vec3.ZERO, 0));
    drone.ask("mon");
    drone.ask("up 50");

    assertThat(drone.ask("curve 25 25 80 0 50 80 40 m1")).isEqualTo("error Radius is too large!");
    assertThat(drone.ask("curve 100 0 80 200 0 80 40 m1")).isEqualTo("error Radius is too large!");
    assertThat(drone.ask("curve 60 60 80 0 120 80 40 m2")).isEqualTo("error No valid marker");
    assertNear(drone, new Vec3(0, 0, 0.8));
  }

  @Test
  void jumpFliesFromPadToPadAndTurns() {
    SteppedDrone drone = flying(MissionPad.onFloor(1, Vec3.ZERO, 0), TWO);
    drone.ask("mon");

    assertThat(drone.ask("jump 90 40 80 60 90 m1 m2")).isEqualTo("ok");

    assertNear(drone, new Vec3(1, 0.5, 0.8));
    assertThat(drone.state().motion().attitude().heading())
        .as("90 degrees against the second pad's rocket, counter-clockwise")
        .isCloseTo(Math.PI / 2, within(0.01));
  }

  @Test
  void jumpWithoutTheSecondPadHoversWhereItLooked() {
    SteppedDrone drone = flying(MissionPad.onFloor(1, Vec3.ZERO, 0), TWO);
    drone.ask("mon");

    assertThat(drone.ask("jump 200 -100 80 60 0 m1 m2")).isEqualTo("error No valid marker");
    assertNear(drone, new Vec3(2, -1, 0.8));
    assertThat(drone.ask("jump 100 0 80 60 0 m3 m2")).isEqualTo("error No valid marker");
    assertNear(drone, new Vec3(2, -1, 0.8));
  }

  @Test
  void whileItJumpsADroneIsBusy() {
    SteppedDrone drone = flying(MissionPad.onFloor(1, Vec3.ZERO, 0), TWO);
    drone.ask("mon");
    drone.send("jump 90 40 80 60 90 m1 m2");
    drone.advance(1);

    assertThat(drone.ask("forward 50")).isEqualTo("error Not joystick");
  }

  @Test
  void sdk3LooksDownOnlyAndRefusesPlacesBelowThePad() {
    SteppedDrone drone = flying(arena(ONE), Profile.TT);
    drone.ask("mon");

    assertThat(drone.ask("go 50 0 -30 50 m1")).isEqualTo("out of range");
    assertThat(drone.ask("jump 50 50 0 50 0 m1 m2")).isEqualTo("out of range");
    assertThat(drone.ask("go 50 0 50 50 m1")).isEqualTo("ok");
  }

  @Test
  void padsThatArePutInLaterAreSeenAndThoseTakenAwayNot() {
    SteppedDrone drone = flying(ONE);
    drone.ask("mon");
    drone.control(new Control.Furnish(List.of(), List.of(MissionPad.onFloor(8, Vec3.ZERO, 0))));

    assertThat(line(drone)).startsWith("mid:8;");
    drone.control(new Control.Furnish(List.of(), List.of()));
    assertThat(line(drone)).startsWith(NOTHING);
  }

  private static Arena arena(MissionPad... pads) {
    return Arena.DEFAULT.withRoom(ROOM).withPads(List.of(pads));
  }

  private static SteppedDrone flying(MissionPad... pads) {
    return flying(arena(pads), Profile.EDU);
  }

  private static SteppedDrone flying(Arena arena, Profile profile) {
    SteppedDrone drone =
        SteppedDrone.of(SimConfig.DEFAULT.withProduct(profile, Behavior.REPORT).withArena(arena));
    assertThat(drone.ask("command")).isEqualTo("ok");
    assertThat(drone.ask("takeoff")).isEqualTo("ok");
    return drone;
  }

  /** Returns a state line that was created after all previous events. */
  private static String line(SteppedDrone drone) {
    drone.advance(0.3);
    return drone.stateLines().get(drone.stateLines().size() - 1).text();
  }

  private static List<String> words(SteppedDrone drone) {
    return drone.events().stream().map(SimEvent::words).toList();
  }

  private static void assertNear(SteppedDrone drone, Vec3 place) {
    Vec3 position = drone.state().motion().position();
    assertThat(position.distanceTo(place))
        .as("%s is not within 1.5 cm of %s", position, place)
        .isLessThan(0.015);
  }
}
