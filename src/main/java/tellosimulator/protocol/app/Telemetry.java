package tellosimulator.protocol.app;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import tellosimulator.command.ProtocolContext;
import tellosimulator.controller.RefusalKind;
import tellosimulator.fault.FaultKind;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.sensor.SensorReadings;
import tellosimulator.time.Periodic;

/** What the drone tells the app regularly: its flight data, the Wi-Fi and the light. */
final class Telemetry {

  /** Period of flight data [s]. Measured: a radio capture, 96 to 103 ms. */
  private static final double FLIGHT_PERIOD = 0.1;

  /** Period of Wi-Fi strength and light [s]. Measured: tellopilots.com 4805. */
  private static final double SLOW_PERIOD = 0.5;

  /** Length of flight data [bytes]. Measured: a radio capture. */
  static final int FLIGHT_LENGTH = 24;

  /** Wi-Fi strength and disturbance. Measured: TelloPy 25, 90 and none. */
  private static final byte[] WIFI = {90, 0};

  /** Light strength where there is light. Its meaning is not known; clients only wait for it. */
  private static final byte[] LIGHT = {1};

  private static final byte[] NO_LIGHT = {0};

  /** Voltage of an empty battery [mV]. Assumed: a straight line through 3935 mV at 66 %. */
  private static final int EMPTY = 3500;

  /** Voltage for each per cent of charge [mV]. Measured: a radio capture, 3935 mV at 66 %. */
  private static final double MILLIVOLTS = 6.6;

  /** Endurance of a full battery [s]. Documented: 13 minutes, Tello User Manual. */
  private static final double ENDURANCE = 780;

  private static final int FLYING = 1;
  private static final int ON_GROUND = 1 << 1;
  private static final int MOTORS_ON = 1 << 2;
  private static final int HOVERING = 1 << 3;
  private static final int BATTERY_LOW = 1 << 5;
  private static final int BATTERY_CRITICAL = 1 << 6;

  /**
   * Values of the fly mode. Measured: 1 in a radio capture, 6 in TelloPy 25; others from clients.
   */
  private static final int STANDING = 1;

  private static final int HOVER_MODE = 6;
  private static final int TAKEOFF_MODE = 11;
  private static final int LANDING_MODE = 12;

  /** Speed below which the drone hovers [dm/s]. Decided. */
  private static final double STILL = 1;

  private final ProtocolContext drone;
  private final Periodic flight;
  private final Periodic slow;

  /** Begins now. */
  Telemetry(ProtocolContext drone) {
    this.drone = drone;
    flight = new Periodic(drone.controller().now(), () -> FLIGHT_PERIOD);
    slow = new Periodic(drone.controller().now(), () -> SLOW_PERIOD);
  }

  static byte[] wifi() {
    return WIFI.clone();
  }

  private boolean dark() {
    return drone.faults().get().find(FaultKind.DARK).isPresent();
  }

  static byte[] light() {
    return LIGHT.clone();
  }

  /** A notification that is due. */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  record Notification(MessageId id, byte[] payload) {}

  /** Returns what is due at the end of this step. */
  List<Notification> due(int lowBattery) {
    boolean flightDue = flight.due(drone.controller().now());
    boolean slowDue = slow.due(drone.controller().now());
    if (!flightDue && !slowDue) {
      return List.of();
    }
    Notification data = new Notification(MessageId.FLIGHT_DATA, flightData(lowBattery));
    return slowDue
        ? List.of(
            data,
            new Notification(MessageId.WIFI, wifi()),
            new Notification(MessageId.LIGHT, dark() ? NO_LIGHT : LIGHT))
        : List.of(data);
  }

  /**
   * Returns the payload of flight data. Measured: the layout of gobot, SMerrony/tello and a radio
   * capture; units of the speeds from the app.
   *
   * @param lowBattery charge at which the battery counts as low [%]
   */
  byte[] flightData(int lowBattery) {
    DroneState state = drone.state().get();
    SensorReadings readings = drone.instruments().read(state);
    FlightPhase phase = state.phase();
    int percent = readings.health().batteryPercent();
    Optional<RefusalKind> objection = drone.controller().objectionToTakeoff();
    boolean hot = objection.filter(RefusalKind.OVERHEATED::equals).isPresent();
    boolean lost = objection.filter(RefusalKind.POSITION_UNKNOWN::equals).isPresent();
    ByteBuffer out = ByteBuffer.allocate(FLIGHT_LENGTH).order(ByteOrder.LITTLE_ENDIAN);
    out.putShort((short) readings.range().heightDm());
    out.putShort((short) readings.velocityDm().x());
    out.putShort((short) readings.velocityDm().y());
    out.putShort((short) readings.velocityDm().z());
    out.putShort((short) (10 * state.energy().motorTime()));
    out.put((byte) (lost ? 1 : 0)).put((byte) 0);
    out.put((byte) percent);
    double left = phase.motorsOn() ? ENDURANCE * percent / 100 : 0;
    out.putShort((short) left);
    out.putShort((short) millivolts(percent));
    out.put((byte) flags(state, readings, lowBattery));
    out.put((byte) mode(phase));
    out.putShort((short) 0); // no countdown; the camera works
    out.put((byte) (phase.motorsOn() ? 1 : 0));
    out.put((byte) (hot ? 0x80 : 0))
        .put((byte) (hot ? 1 : 0)); // one for each reading of the layout
    return out.array();
  }

  /** Returns the voltage of the battery [mV]. */
  static float millivolts(int percent) {
    return (float) (EMPTY + MILLIVOLTS * percent);
  }

  private static int flags(DroneState state, SensorReadings readings, int lowBattery) {
    FlightPhase phase = state.phase();
    int percent = readings.health().batteryPercent();
    boolean hovers = phase == FlightPhase.FLYING && readings.velocityDm().norm() < STILL;
    return (phase.flying() ? FLYING : ON_GROUND)
        | (phase.motorsOn() ? MOTORS_ON : 0)
        | (hovers ? HOVERING : 0)
        | (percent <= lowBattery ? BATTERY_LOW : 0)
        | (percent <= Battery.TOO_LOW_FOR_TAKEOFF ? BATTERY_CRITICAL : 0);
  }

  private static int mode(FlightPhase phase) {
    return switch (phase) {
      case OFF, GROUNDED, IDLING, FALLING, CRASHED -> STANDING;
      case TAKING_OFF -> TAKEOFF_MODE;
      case FLYING -> HOVER_MODE;
      case LANDING -> LANDING_MODE;
    };
  }
}
