package tellosimulator.protocol.app;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import tellosimulator.command.ProtocolContext;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.DroneState;
import tellosimulator.sensor.SensorReadings;
import tellosimulator.time.Periodic;
import tellosimulator.time.SimTime;

/**
 * The drone's own log, which it sends to the app as it writes it: a header until it is answered,
 * then records. Each packet holds whole records. Positions are relative to where the log began, x
 * along the heading at power-on, y to the right, z down. Measured: a radio capture, TelloPy, and
 * the record specifications of DatCon.
 */
final class FlightLog {

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

  private final ProtocolContext drone;
  private final Vec3 origin;
  private final Periodic header;
  private Optional<Periodic> packets = Optional.empty();
  private int count;

  /** Begins now. */
  FlightLog(ProtocolContext drone) {
    this.drone = drone;
    origin = drone.state().get().motion().position();
    SimTime now = drone.controller().now();
    header = new Periodic(now.plus(FIRST_HEADER), () -> HEADER_PERIOD);
  }

  /** Records that the app has answered the header. */
  void answered() {
    if (packets.isEmpty()) {
      packets = Optional.of(new Periodic(drone.controller().now().plus(PERIOD), () -> PERIOD));
    }
  }

  /** Returns the header if it is due at the end of this step. */
  Optional<byte[]> header() {
    return packets.isEmpty() && header.due(drone.controller().now())
        ? Optional.of(head())
        : Optional.empty();
  }

  private static byte[] head() {
    ByteBuffer out = ByteBuffer.allocate(3 + HEAD).order(ByteOrder.LITTLE_ENDIAN);
    out.putShort((short) LOG_ID);
    out.position(BUILD_AT).put(BUILD);
    out.position(out.capacity() - VERSION.length).put(VERSION);
    return out.array();
  }

  /** Returns the records that are due at the end of this step, with a zero in front of them. */
  Optional<byte[]> records() {
    if (packets.isEmpty() || !packets.get().due(drone.controller().now())) {
      return Optional.empty();
    }
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
    return Optional.of(out.toByteArray());
  }

  /** Puts a payload into a record, with each byte combined with the lowest byte of the time. */
  private byte[] record(int id, ByteBuffer payload) {
    byte[] values = payload.array();
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

  private static ByteBuffer allocate(int length) {
    return ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * Returns the position relative to where the log began, and the velocity, along the heading at
   * power-on.
   */
  private ByteBuffer visualOdometry(DroneState state) {
    Vec3 moved = state.motion().position().minus(origin);
    Vec3 position = Frames.flipped(moved.turned(-state.reference().heading()));
    Vec3 velocity = Frames.flipped(state.motion().velocity().turned(-state.reference().heading()));
    ByteBuffer out = allocate(80);
    out.putShort((short) count);
    for (double speed : new double[] {velocity.x(), velocity.y(), velocity.z()}) {
      out.putShort((short) Math.round(Frames.centimeters(speed)));
    }
    out.putFloat((float) position.x()).putFloat((float) position.y());
    out.putFloat((float) position.z());
    out.putFloat(68, (float) -position.z());
    return out.put(76, ALL_VALID);
  }

  private ByteBuffer imu(DroneState state, SensorReadings readings) {
    Vec3 rate = Frames.flipped(state.motion().rate());
    Vec3 force = readings.acceleration().times(0.001);
    Attitude attitude = state.motion().attitude();
    Vec3 velocity = Frames.flipped(state.motion().velocity().turned(-state.reference().heading()));
    Vec3 pull = state.motion().acceleration().minus(Vec3.UP.times(DroneSpec.GRAVITY));
    Vec3 linear = Frames.flipped(pull.turned(-state.reference().heading()));
    ByteBuffer out = allocate(120);
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
    return out.putShort(118, (short) count);
  }

  private static void put(ByteBuffer out, Vec3 vector) {
    out.putFloat((float) vector.x()).putFloat((float) vector.y()).putFloat((float) vector.z());
  }

  /** Returns three stages of the gyroscope [rad/s], which are the same here. */
  private static ByteBuffer gyro(DroneState state) {
    Vec3 rate = Frames.flipped(state.motion().rate());
    ByteBuffer out = allocate(37).position(1);
    put(out, rate);
    put(out, rate);
    put(out, rate);
    return out;
  }

  private ByteBuffer distance(SensorReadings readings) {
    ByteBuffer out = allocate(4);
    return out.putShort((short) readings.range().tofMm()).put((byte) 1).put((byte) (4 * count));
  }

  private static ByteBuffer battery(SensorReadings readings) {
    return allocate(6).putFloat(0, Telemetry.millivolts(readings.health().batteryPercent()));
  }
}
