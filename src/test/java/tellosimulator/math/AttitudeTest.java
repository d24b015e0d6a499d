package tellosimulator.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AttitudeTest {

  private static final double TINY = 1e-12;
  private static final Vec3 NOSE = new Vec3(1, 0, 0);
  private static final Vec3 LEFT = new Vec3(0, 1, 0);

  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-9, 30, 90, 179.999, -179.999, -90, -0.5})
  void headingComesBack(double degrees) {
    Attitude attitude = Attitude.ofHeading(Math.toRadians(degrees));

    assertThat(Math.toDegrees(attitude.heading())).isCloseTo(degrees, within(1e-9));
    assertThat(attitude.elevation()).isCloseTo(0, within(TINY));
    assertThat(attitude.bank()).isCloseTo(0, within(TINY));
  }

  @Test
  void headingTurnsCounterClockwiseSeenFromAbove() {
    Attitude quarter = Attitude.ofHeading(Math.PI / 2);

    assertThat(quarter.toRoom(NOSE).distanceTo(LEFT)).isLessThan(TINY);
    assertThat(quarter.toBody(LEFT).distanceTo(NOSE)).isLessThan(TINY);
  }

  @Test
  void noseUpAndRightSideDownArePositive() {
    double angle = 0.3;
    Attitude noseUp = turn(new Vec3(0, -1, 0), angle);
    Attitude rightDown = turn(new Vec3(1, 0, 0), angle);

    assertThat(noseUp.elevation()).isCloseTo(angle, within(TINY));
    assertThat(noseUp.toRoom(NOSE).z()).isCloseTo(StrictMath.sin(angle), within(TINY));
    assertThat(rightDown.bank()).isCloseTo(angle, within(TINY));
    assertThat(rightDown.toRoom(LEFT).z()).isCloseTo(StrictMath.sin(angle), within(TINY));
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # heading, elevation, bank
          0,         0,         0
          40,        10,        -20
          -170,      80,        5
          90,        -25,       25
          179,       1,         -179
          """)
  void headingElevationAndBankComeBackFromTheTurnsThatMakeThem(
      double heading, double elevation, double bank) {
    Attitude attitude =
        Attitude.ofHeading(Math.toRadians(heading))
            .after(turn(new Vec3(0, -1, 0), Math.toRadians(elevation)))
            .after(turn(new Vec3(1, 0, 0), Math.toRadians(bank)));

    assertThat(Math.toDegrees(attitude.heading())).isCloseTo(heading, within(1e-9));
    assertThat(Math.toDegrees(attitude.elevation())).isCloseTo(elevation, within(1e-9));
    assertThat(Math.toDegrees(attitude.bank())).isCloseTo(bank, within(1e-9));
  }

  @Test
  void aVectorToTheRoomAndBackIsTheSame() {
    Attitude attitude = Attitude.ofHeading(2).after(turn(new Vec3(0.6, 0, 0.8), 1.2)).normalized();
    Vec3 vector = new Vec3(0.3, -4, 1.7);

    assertThat(attitude.toBody(attitude.toRoom(vector)).distanceTo(vector)).isLessThan(TINY);
    assertThat(attitude.toRoom(vector).norm()).isCloseTo(vector.norm(), within(TINY));
    assertThat(attitude.toRoom(Vec3.UP).distanceTo(attitude.up())).isLessThan(TINY);
    Attitude none = attitude.after(attitude.inverse());
    assertThat(none.toRoom(vector).distanceTo(vector)).isLessThan(TINY);
  }

  @ParameterizedTest
  @CsvSource({"0,0,1", "0.6,0,0.8", "0,-0.6,0.8", "1,0,0", "0.48,0.6,-0.64", "0,0,-1"})
  void tiltingBringsTheVerticalAxisToItsTarget(double x, double y, double z) {
    Vec3 up = new Vec3(x, y, z);

    assertThat(Attitude.tiltedTo(up).up().distanceTo(up)).isLessThan(TINY);
  }

  @Test
  void theErrorIsTheMissingTurnForSmallAngles() {
    Attitude from = Attitude.ofHeading(1).after(turn(new Vec3(1, 0, 0), 0.4));
    Attitude to = from.after(turn(new Vec3(0, 0.6, 0.8), 0.01));

    assertThat(from.errorTo(to).distanceTo(new Vec3(0, 0.006, 0.008))).isLessThan(1e-6);
    // Two quaternions represent the same orientation; the error is the shorter rotation for both.
    Attitude negative = new Attitude(-to.w(), -to.x(), -to.y(), -to.z());
    assertThat(from.errorTo(negative).distanceTo(from.errorTo(to))).isLessThan(TINY);
  }

  @Test
  void turningInManySmallStepsIsOneTurn() {
    // A flip: 19 rad/s about y for 360 degrees, in steps of 5 ms.
    double rate = 19;
    int steps = 400;
    double seconds = 2 * Math.PI / rate / steps;
    Attitude attitude = Attitude.ofHeading(0.7);

    for (int i = 0; i < steps; i++) {
      attitude = attitude.advancedBy(new Vec3(0, rate, 0), seconds);
    }

    assertThat(attitude.toRoom(NOSE).distanceTo(Attitude.ofHeading(0.7).toRoom(NOSE)))
        .isLessThan(1e-6);
    double norm =
        attitude.w() * attitude.w()
            + attitude.x() * attitude.x()
            + attitude.y() * attitude.y()
            + attitude.z() * attitude.z();
    assertThat(norm).isCloseTo(1, within(TINY));
  }

  /** Returns a right-handed rotation about a unit vector. */
  private static Attitude turn(Vec3 axis, double angle) {
    double sine = StrictMath.sin(angle / 2);
    return new Attitude(
        StrictMath.cos(angle / 2), axis.x() * sine, axis.y() * sine, axis.z() * sine);
  }
}
