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
 * IMU, barometer, distance sensor and the rest: from the true state to what the drone reports. The
 * same state over the same ground always gives the same readings, noise included. Immutable; for
 * the thread of the echoes.
 */
public final class Instruments {

  /** Noise of the accelerometer [0.001 g]. Measured: ±50 in hover. */
  private static final double ACCELERATION_NOISE = 20;

  /** Noise of the barometer [m]. Measured: ±0.3 in flight. */
  private static final double BAROMETER_NOISE = 0.12;

  /** The barometer's offset lies within this [m]. Measured: -150 to 1700, mostly low. */
  private static final double BAROMETER_OFFSET = 150;

  /** Noise of the distance sensor [m]. Assumed: a centimetre. */
  private static final double TOF_NOISE = 0.008;

  /** Noise of pitch and roll [degrees]. Measured: ±1. */
  private static final double ANGLE_NOISE = 0.4;

  /** Noise of the velocity [dm/s]. Measured: now and then ±1, of what is cut off. */
  private static final double VELOCITY_NOISE = 0.4;

  /** Drift of yaw [degrees/s]. Measured: "slowly". */
  private static final double YAW_DRIFT = 0.02;

  /** Least and greatest offset of height in a flight [m]. Measured: 10 to 40 cm, at most 58. */
  private static final double LEAST_HEIGHT_OFFSET = 0.10;

  private static final double GREATEST_HEIGHT_OFFSET = 0.40;

  /** Reported by the board's sensor where there is no echo [mm]. Documented: SDK 3.0 User Guide. */
  static final int BOARD_NONE_MM = 8192;

  /** Where that sensor is, body frame [m]. Assumed: on top, as far ahead as the camera. */
  private static final Vec3 BOARD_SENSOR = new Vec3(0.035, 0, DroneSpec.COLLIDER.height());

  private static final double STANDARD_MILLI_G = 1000 / DroneSpec.GRAVITY;

  private final boolean noisy;
  private final SeededNoise noise;
  private final double boardRange;
  private final Echoes echoes;
  private final UnaryOperator<SensorReadings> wrong;

  /**
   * @param echoes where the beams of the distance sensors come back from
   * @param wrong what becomes of right readings
   */
  public Instruments(
      Behavior behavior, SeededNoise noise, Echoes echoes, UnaryOperator<SensorReadings> wrong) {
    this.echoes = echoes;
    this.wrong = wrong;
    this.boardRange = behavior.boardRange();
    this.noisy = behavior.noisySensors();
    this.noise = noise;
  }

  /** What all instruments say in this state. */
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
   * What the distance sensor of the extension board reports [mm]: how far it is to what is ahead of
   * it, or {@link #BOARD_NONE_MM}.
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
   * Speeds as a real drone cuts them off. Measured: xg590/Tello-Python, where a flight at yaw -26
   * has {@code vgx:2;vgy:0} as often as {@code vgx:2;vgy:-1}, and the sums of all speeds miss a
   * sixth of the way.
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

  /** The errors of one moment. */
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
