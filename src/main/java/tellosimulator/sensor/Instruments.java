package tellosimulator.sensor;

import java.util.function.UnaryOperator;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.DroneState;
import tellosimulator.model.Motion;
import tellosimulator.profile.Behavior;
import tellosimulator.sensor.SeededNoise.Channel;
import tellosimulator.sensor.SensorReadings.AttitudeDeg;
import tellosimulator.sensor.SensorReadings.Health;
import tellosimulator.sensor.SensorReadings.Range;
import tellosimulator.time.SimTime;

/**
 * The instruments of a drone, such as IMU, barometer and distance sensor. They turn the true state
 * into the reported one. The same state over the same ground always gives the same readings,
 * including noise. Immutable, but confined to the thread on which the {@link Echoes} may be called.
 */
public final class Instruments {

  /** Standard deviation of the accelerometer [0.001 g]. Measured: readings vary by ±50 in hover. */
  private static final double ACCELERATION_NOISE = 20;

  /** Standard deviation of the barometer [m]. Measured: readings vary by ±0.3 m in flight. */
  private static final double BAROMETER_NOISE = 0.12;

  /**
   * Maximum offset of the barometer, up or down [m]. Measured: offsets from -150 to 1700 m, mostly
   * low.
   */
  private static final double BAROMETER_OFFSET = 150;

  /** Standard deviation of the distance sensors [m]. Assumed: readings vary by about 1 cm. */
  private static final double TOF_NOISE = 0.008;

  /** Standard deviation of pitch and roll [degrees]. Measured: readings vary by ±1 degree. */
  private static final double ANGLE_NOISE = 0.4;

  /**
   * Standard deviation of the velocity before truncation [dm/s]. Measured: readings occasionally
   * vary by ±1 dm/s.
   */
  private static final double VELOCITY_NOISE = 0.4;

  /**
   * Standard deviation of the yaw drift, which changes at each power-on [degrees/s]. Measured: yaw
   * drifts "slowly".
   */
  private static final double YAW_DRIFT = 0.02;

  /** Minimum offset of the reported height during a flight [m]. Measured: 10 to 40 cm. */
  private static final double LEAST_HEIGHT_OFFSET = 0.10;

  /**
   * Maximum offset of the reported height during a flight [m]. Measured: 10 to 40 cm, at most 58
   * cm.
   */
  private static final double GREATEST_HEIGHT_OFFSET = 0.40;

  /**
   * Reading of the extension board's distance sensor without an echo [mm]. Documented: SDK 3.0 User
   * Guide.
   */
  static final int BOARD_NONE_MM = 8192;

  /**
   * Position of the extension board's distance sensor, in the body frame [m]. Assumed: on top of
   * the drone, as far forward as the camera.
   */
  private static final Vec3 BOARD_SENSOR = new Vec3(0.035, 0, DroneSpec.COLLIDER.height());

  private static final double STANDARD_MILLI_G = 1000 / DroneSpec.GRAVITY;

  private final boolean noisy;
  private final SeededNoise noise;
  private final double boardRange;
  private final Echoes echoes;
  private final UnaryOperator<SensorReadings> wrong;

  /**
   * Creates the instruments of a drone.
   *
   * @param echoes the surroundings that reflect the beams of the distance sensors
   * @param wrong changes the readings as the active faults require
   */
  public Instruments(
      Behavior behavior, SeededNoise noise, Echoes echoes, UnaryOperator<SensorReadings> wrong) {
    this.echoes = echoes;
    this.wrong = wrong;
    this.boardRange = behavior.boardRange();
    this.noisy = behavior.noisySensors();
    this.noise = noise;
  }

  /** Returns the readings of all instruments for a state. */
  public SensorReadings read(DroneState state) {
    Sample sample = new Sample(state.time());
    Motion motion = state.motion();
    return wrong.apply(
        new SensorReadings(
            attitude(state, sample),
            velocity(state, sample),
            new Range(tofMm(motion.pose(), sample), heightDm(state)),
            barometer(state, sample),
            acceleration(motion, sample),
            health(state)));
  }

  private int tofMm(Pose drone, Sample sample) {
    double error = sample.error(Channel.TOF, TOF_NOISE);
    return TimeOfFlight.read(drone.attitude(), echoes.below(drone), error);
  }

  /**
   * Returns the reading of the extension board's distance sensor [mm]: the distance to the object
   * ahead, or {@link #BOARD_NONE_MM} without an echo.
   */
  public int boardTofMm(DroneState state) {
    Pose drone = state.motion().pose();
    Vec3 sensor = drone.position().plus(drone.attitude().toRoom(BOARD_SENSOR));
    Vec3 ahead = drone.attitude().toRoom(new Vec3(1, 0, 0));
    double distance = echoes.along(sensor, ahead);
    double read = distance + new Sample(state.time()).error(Channel.BOARD_TOF, TOF_NOISE);
    return distance > boardRange ? BOARD_NONE_MM : (int) Math.max(0, Math.round(read * 1000));
  }

  private AttitudeDeg attitude(DroneState state, Sample sample) {
    Attitude attitude = state.motion().attitude();
    double drift =
        noisy
            ? YAW_DRIFT
                * noise.gaussian(Channel.YAW_DRIFT, state.reference().poweredAt().nanos())
                * state.time().since(state.reference().poweredAt())
            : 0;
    double yaw = Frames.yawOfHeading(state.reference().turned(attitude)) + drift;
    double pitch =
        StrictMath.toDegrees(attitude.elevation()) + sample.error(Channel.PITCH, ANGLE_NOISE);
    double roll = StrictMath.toDegrees(attitude.bank()) + sample.error(Channel.ROLL, ANGLE_NOISE);
    return new AttitudeDeg(
        (int) Math.round(pitch), (int) Math.round(roll), wrappedDegrees(Math.round(yaw)));
  }

  private Vec3 velocity(DroneState state, Sample sample) {
    Vec3 velocity = state.motion().velocity().turned(-state.reference().heading());
    Vec3 decimeters = Frames.flipped(velocity).times(10);
    return noisy
        ? truncated(
            decimeters.plusScaled(
                new Vec3(1, 1, 1), sample.error(Channel.VELOCITY, VELOCITY_NOISE)))
        : decimeters;
  }

  /**
   * Truncates the components towards zero, as a real drone does. Measured: xg590/Tello-Python. In a
   * flight at a yaw of -26 degrees, {@code vgx:2;vgy:0} is as frequent as {@code vgx:2;vgy:-1}, and
   * the reported speeds add up to a sixth less than the distance flown.
   */
  private static Vec3 truncated(Vec3 velocity) {
    return new Vec3((int) velocity.x(), (int) velocity.y(), (int) velocity.z());
  }

  private int heightDm(DroneState state) {
    int takeoffs = state.reference().takeoffs();
    double height = state.motion().position().z() - state.reference().height();
    if (!noisy || takeoffs == 0) {
      return (int) Math.round(height * 10);
    }
    double offset =
        noise.between(LEAST_HEIGHT_OFFSET, GREATEST_HEIGHT_OFFSET, Channel.HEIGHT_OFFSET, takeoffs);
    return (int) Math.floor((height - offset) * 10);
  }

  private double barometer(DroneState state, Sample sample) {
    double offset =
        noise.between(
            -BAROMETER_OFFSET,
            BAROMETER_OFFSET,
            Channel.BAROMETER_OFFSET,
            state.reference().poweredAt().nanos());
    return offset
        + state.motion().position().z()
        + sample.error(Channel.BAROMETER, BAROMETER_NOISE);
  }

  private static Vec3 acceleration(Motion motion, Sample sample) {
    Vec3 felt = motion.attitude().toBody(motion.acceleration()).times(STANDARD_MILLI_G);
    Vec3 error =
        new Vec3(
            sample.error(Channel.ACCELERATION_X, ACCELERATION_NOISE),
            sample.error(Channel.ACCELERATION_Y, ACCELERATION_NOISE),
            sample.error(Channel.ACCELERATION_Z, ACCELERATION_NOISE));
    return Frames.flipped(felt).plus(error);
  }

  private static Health health(DroneState state) {
    DroneState.Energy energy = state.energy();
    return new Health(
        energy.battery().percent(), (int) energy.temperature(), (int) energy.motorTime());
  }

  private static int wrappedDegrees(long degrees) {
    return Math.floorMod(degrees + 179, 360) - 179;
  }

  /** The noise of all readings at one moment. */
  private final class Sample {
    private final SimTime time;

    Sample(SimTime time) {
      this.time = time;
    }

    double error(Channel channel, double sigma) {
      return noisy ? sigma * noise.gaussian(channel, time.nanos()) : 0;
    }
  }
}
