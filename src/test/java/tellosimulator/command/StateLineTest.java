package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Vec3;
import tellosimulator.model.PadReading;
import tellosimulator.profile.Profile;
import tellosimulator.sensor.SensorReadings;
import tellosimulator.sensor.SensorReadings.AttitudeDeg;
import tellosimulator.sensor.SensorReadings.Health;
import tellosimulator.sensor.SensorReadings.Range;

/** Compares with lines that were recorded from real drones, byte for byte. */
class StateLineTest {

  private static final SensorReadings LEVEL =
      readings(new Range(100, 0), 138.82, new Vec3(9, 0, -1000), new Health(88, 44, 0), Vec3.ZERO);

  @Test
  void inFlightWithoutPadDetection() {
    // Report: sample of an EDU, 172 bytes with the line end.
    SensorReadings sensors =
        readings(
            new Range(800, 6), 281.96, new Vec3(24, 1, -1001), new Health(65, 72, 27), Vec3.ZERO);

    String line = StateLine.format(Profile.EDU, PadReading.OFF, sensors);

    assertThat(line)
        .isEqualTo(
            "mid:-2;x:-200;y:-200;z:-200;mpry:-1,-1,-1;pitch:0;roll:0;yaw:0;vgx:0;vgy:0;vgz:0;"
                + "templ:72;temph:75;tof:80;h:60;bat:65;baro:281.96;time:27;"
                + "agx:24.00;agy:1.00;agz:-1001.00;\r\n");
    assertThat(WireText.encode(line)).hasSize(172);
  }

  @Test
  void onTheGround() {
    // Test data of a public Node client, 166 bytes; zeros in mpry as with SDK 3.0.
    String line = StateLine.format(Profile.TT, PadReading.OFF, LEVEL);

    assertThat(line)
        .isEqualTo(
            "mid:-2;x:-200;y:-200;z:-200;mpry:0,0,0;pitch:0;roll:0;yaw:0;vgx:0;vgy:0;vgz:0;"
                + "templ:44;temph:47;tof:10;h:0;bat:88;baro:138.82;time:0;"
                + "agx:9.00;agy:0.00;agz:-1000.00;\r\n");
    assertThat(WireText.encode(line)).hasSize(166);
  }

  @Test
  void withPadDetectionButWithoutPad() {
    // tello-edu-rs and others.
    SensorReadings sensors =
        readings(
            new Range(713, 5), -57.14, new Vec3(0, 0, -956), new Health(70, 60, 14), Vec3.ZERO);

    String line = StateLine.format(Profile.EDU, PadReading.NONE, sensors);

    assertThat(line)
        .startsWith("mid:-1;x:-100;y:-100;z:-100;mpry:-1,-1,-1;pitch:0;")
        .contains(";tof:71;h:50;bat:70;baro:-57.14;time:14;")
        .endsWith(";agz:-956.00;\r\n");
  }

  @Test
  void theWhiteTellosLineBeginsWithPitch() {
    String line = StateLine.format(Profile.TELLO, PadReading.OFF, LEVEL);

    assertThat(line)
        .isEqualTo(
            "pitch:0;roll:0;yaw:0;vgx:0;vgy:0;vgz:0;"
                + "templ:44;temph:47;tof:10;h:0;bat:88;baro:138.82;time:0;"
                + "agx:9.00;agy:0.00;agz:-1000.00;\r\n");
  }

  @Test
  void theTtHasThePadsToo() {
    assertThat(StateLine.format(Profile.TT, PadReading.NONE, LEVEL))
        .startsWith("mid:-1;x:-100;y:-100;z:-100;mpry:0,0,0;");
  }

  @Test
  void signsUnitsAndOrderOfMotion() {
    SensorReadings sensors =
        new SensorReadings(
            new AttitudeDeg(-8, 3, -179),
            new Vec3(2.6, -0.6, -8.4),
            new Range(65_530, -7),
            -0.004,
            new Vec3(-12.4, 0.6, -1270.5),
            new Health(100, 43, 780));

    assertThat(StateLine.format(Profile.TELLO, PadReading.OFF, sensors))
        .isEqualTo(
            "pitch:-8;roll:3;yaw:-179;vgx:3;vgy:-1;vgz:-8;"
                + "templ:43;temph:46;tof:6553;h:-70;bat:100;baro:0.00;time:780;"
                + "agx:-12.00;agy:1.00;agz:-1270.00;\r\n");
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          0.05,    0.05
          -0.05,   -0.05
          -0.994,  -0.99
          1699.999, 1700.00
          -150.1,  -150.10
          7,       7.00
          """)
  void theBarometerHasTwoDecimals(double meters, String text) {
    SensorReadings sensors =
        readings(new Range(100, 0), meters, Vec3.ZERO, new Health(1, 1, 1), Vec3.ZERO);

    assertThat(StateLine.format(Profile.EDU, PadReading.OFF, sensors))
        .contains(";baro:" + text + ";");
  }

  private static SensorReadings readings(
      Range range, double barometer, Vec3 acceleration, Health health, Vec3 velocityDm) {
    return new SensorReadings(
        new AttitudeDeg(0, 0, 0), velocityDm, range, barometer, acceleration, health);
  }
}
