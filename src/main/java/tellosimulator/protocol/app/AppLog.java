package tellosimulator.protocol.app;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import tellosimulator.command.ProtocolContext;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.DroneState;
import tellosimulator.protocol.app.Telemetry.Notification;
import tellosimulator.sensor.SensorReadings;
import tellosimulator.time.Periodic;
import tellosimulator.time.SimTime;

/**
 * The drone's own log, which it sends to the app as it writes it: a header until it is answered,
 * then records. Each packet holds whole records. Positions are relative to where the log began, x
 * along the heading at power-on, y to the right, z down. Measured: a radio capture, TelloPy, and
 * the record specifications of DatCon.
 */
final class AppLog {

  /** Number of the log. Measured: TelloPy 75. */
  private static final int LOG_ID = 0x432c;

  /**
   * Time from the connection to the first header [s]. Measured: TelloPy 48 and 75, 1.0 to 1.7 s.
   */
  private static final double FIRST_HEADER = 1.2;

  /** Period of the header until it is answered [s]. Measured: tellopilots.com 511. */
  private static final double HEADER_PERIOD = 2;

  /** Length of the head of a log file [bytes]. Measured: TelloPy 10. */
  private static final int HEAD = 0x100;

  private static final byte[] BUILD =
      "BUILD May  7 2019 12:02:11\0".getBytes(StandardCharsets.US_ASCII);
  private static final byte[] VERSION = "DJI LOG V3".getBytes(StandardCharsets.US_ASCII);

  /** Where the build stands in the payload of a header. Measured: TelloPy 10 and 48. */
  private static final int BUILD_AT = 19;

  /** Period of packets, and of the fastest records [s]. Measured: a radio capture, 20 Hz. */
  private static final double PERIOD = 0.05;

  /** Frequency of a record's clock [Hz]. Measured: TelloPy 0.7, docs/sensor_time.md. */
  private static final double TICKS = 2_344_062;

  private static final byte RECORD = 0x55;

  /** Length of a record without its payload [bytes]. */
  private static final int FRAME = 12;

  private static final int MVO = 29;
  private static final int IMU = 2048;
  private static final int DISTANCE = 16;
  private static final int BATTERY = 1710;
  private static final int GYRO = 1305;

  /** Flags of a visual position whose velocities and positions are all valid. */
  private static final byte ALL_VALID = 0x77;

  /**
   * Time constant of the rates in IMU records [s]. Measured: TelloPy 0.7.0, docs/sensor_time.md;
   * they show a turn some 30 ms later than the gyroscope's own records.
   */
  private static final double SMOOTHING = 0.05;

  private final ProtocolContext drone;
  private final Vec3 origin;
  private final Periodic header;
  private Optional<Periodic> packets = Optional.empty();
  private Vec3 smoothed = Vec3.ZERO;
  private int count;

  /** Begins now. */
  AppLog(ProtocolContext drone) {
    this.drone = drone;
    origin = drone.state().get().motion().position();
    SimTime now = drone.controller().now();
    header = new Periodic(now.plus(FIRST_HEADER), () -> HEADER_PERIOD);
  }

  /**
   * Handles the answer to the header.
   *
   * @param payload the number of the log, which most programs put behind a zero
   */
  void answered(byte[] payload) {
    boolean known =
        payload.length >= 2
            && payload[payload.length - 2] == (byte) LOG_ID
            && payload[payload.length - 1] == (byte) (LOG_ID >> Byte.SIZE);
    if (known && packets.isEmpty()) {
      packets = Optional.of(new Periodic(drone.controller().now().plus(PERIOD), () -> PERIOD));
    }
  }

  /** Returns what is due at the end of this step. */
  List<Notification> due() {
    SimTime now = drone.controller().now();
    Vec3 rate = drone.state().get().motion().rate();
    smoothed = smoothed.plusScaled(rate.minus(smoothed), SimTime.STEP / SMOOTHING);
    if (packets.isPresent()) {
      return packets.get().due(now)
          ? List.of(new Notification(MessageId.LOG_DATA, records()))
          : List.of();
    }
    return header.due(now) ? List.of(new Notification(MessageId.LOG_HEADER, head())) : List.of();
  }

  private static byte[] head() {
    ByteBuffer out = ByteBuffer.allocate(3 + HEAD).order(ByteOrder.LITTLE_ENDIAN);
    out.putShort((short) LOG_ID);
    out.position(BUILD_AT).put(BUILD);
    out.position(out.capacity() - VERSION.length).put(VERSION);
    return out.array();
  }

  /** Returns records, with a zero in front of them. */
  private byte[] records() {
    DroneState state = drone.state().get();
    SensorReadings readings = drone.instruments().read(state);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(0);
    out.writeBytes(record(GYRO, gyro(state)));
    if (count % 2 == 0) {
      out.writeBytes(record(IMU, imu(state, readings)));
    }
    if (count % 4 == 0) {
      out.writeBytes(record(MVO, visualOdometry(state)));
      out.writeBytes(record(DISTANCE, distance(readings)));
      out.writeBytes(record(BATTERY, battery(readings)));
    }
    count++;
    return out.toByteArray();
  }

  /** Puts a payload into a record, with each byte combined with the lowest byte of the time. */
  private byte[] record(int id, byte[] values) {
    byte[] record = new byte[FRAME + values.length];
    int tick = (int) (long) (TICKS * drone.controller().now().seconds());
    ByteBuffer out = ByteBuffer.wrap(record).order(ByteOrder.LITTLE_ENDIAN);
    out.put(RECORD).putShort((short) record.length);
    out.put((byte) Checksum.ofHeader(record)).putShort((short) id).putInt(tick);
    for (byte value : values) {
      out.put((byte) (value ^ tick));
    }
    out.putShort((short) Checksum.of(record, record.length - 2));
    return record;
  }

  private static ByteBuffer writer(byte[] values) {
    return ByteBuffer.wrap(values).order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * Returns the position relative to where the log began, and the velocity, along the heading at
   * power-on.
   */
  private byte[] visualOdometry(DroneState state) {
    Vec3 moved = state.motion().position().minus(origin);
    Vec3 position = Frames.flipped(moved.turned(-state.reference().heading()));
    Vec3 velocity = Frames.flipped(state.motion().velocity().turned(-state.reference().heading()));
    byte[] values = new byte[80];
    ByteBuffer out = writer(values);
    out.putShort((short) count);
    for (double speed : new double[] {velocity.x(), velocity.y(), velocity.z()}) {
      out.putShort((short) Math.round(Frames.centimeters(speed)));
    }
    out.putFloat((float) position.x()).putFloat((float) position.y());
    out.putFloat((float) position.z());
    out.putFloat(68, (float) -position.z());
    out.put(76, ALL_VALID);
    return values;
  }

  private byte[] imu(DroneState state, SensorReadings readings) {
    Vec3 rate = Frames.flipped(smoothed);
    Vec3 force = readings.acceleration().times(0.001);
    Attitude attitude = state.motion().attitude();
    Vec3 velocity = Frames.flipped(state.motion().velocity().turned(-state.reference().heading()));
    Vec3 pull = state.motion().acceleration().minus(Vec3.UP.times(DroneSpec.GRAVITY));
    Vec3 linear = Frames.flipped(pull.turned(-state.reference().heading()));
    byte[] values = new byte[120];
    ByteBuffer out = writer(values);
    float height = (float) state.motion().position().z();
    put(out.putFloat(16, height).position(20), force);
    put(out, rate);
    out.putFloat(height);
    Attitude level = Attitude.ofHeading(-state.reference().heading()).after(attitude);
    out.putFloat((float) level.w()).putFloat((float) level.x());
    out.putFloat((float) -level.y()).putFloat((float) -level.z()); // y to the right, z down
    put(out, linear);
    put(out, velocity);
    out.putShort(106, (short) (100 * readings.health().temperature()));
    out.putShort(118, (short) count);
    return values;
  }

  private static void put(ByteBuffer out, Vec3 vector) {
    out.putFloat((float) vector.x()).putFloat((float) vector.y()).putFloat((float) vector.z());
  }

  /** Returns three stages of the gyroscope [rad/s], which are the same here. */
  private static byte[] gyro(DroneState state) {
    Vec3 rate = Frames.flipped(state.motion().rate());
    byte[] values = new byte[37];
    ByteBuffer out = writer(values).position(1);
    put(out, rate);
    put(out, rate);
    put(out, rate);
    return values;
  }

  private byte[] distance(SensorReadings readings) {
    byte[] values = new byte[4];
    ByteBuffer out = writer(values);
    out.putShort((short) readings.range().tofMm()).put((byte) 1).put((byte) (4 * count));
    return values;
  }

  private static byte[] battery(SensorReadings readings) {
    byte[] values = new byte[6];
    writer(values).putFloat(Telemetry.millivolts(readings.health().batteryPercent()));
    return values;
  }
}
