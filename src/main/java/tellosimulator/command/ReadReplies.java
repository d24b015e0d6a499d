package tellosimulator.command;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.sensor.SensorReadings;
import tellosimulator.sensor.SensorReadings.AttitudeDeg;

/** A table of the replies to read commands. Confined to the simulation thread. */
final class ReadReplies {

  /** Signal-to-noise ratio in every reply to {@code wifi?}. Report: {@code 90}. */
  private static final String WIFI = "90";

  /**
   * The data from which a reply is formatted.
   *
   * @param speed the speed of moves that specify none [m/s]
   */
  private record Facts(SensorReadings sensors, DroneState state, double speed) {}

  private final ProtocolContext drone;
  private final Map<Reading, Function<Facts, Reply>> table = new EnumMap<>(Reading.class);

  ReadReplies(ProtocolContext drone) {
    this.drone = drone;
    Profile profile = drone.profile();
    line(Reading.SPEED, f -> format("%.1f", Frames.centimeters(f.speed())));
    line(Reading.BATTERY, f -> Integer.toString(f.sensors().health().batteryPercent()));
    line(Reading.TIME, f -> f.sensors().health().motorSeconds() + "s");
    line(Reading.WIFI, f -> WIFI);
    line(Reading.SDK, f -> profile.knows(Sdk.SDK_3_0) ? "30" : "20");
    table.put(Reading.SERIAL_NUMBER, f -> new Reply(format("0TQSIMUL%06d", f.state().drone())));
    line(Reading.HEIGHT, f -> f.sensors().range().heightDm() + "dm");
    line(Reading.TEMPERATURE, f -> temperature(f.sensors().health()));
    line(Reading.ATTITUDE, f -> attitude(f.sensors().attitude()));
    line(Reading.BAROMETER, f -> format("%.6f", f.sensors().barometer()));
    line(Reading.ACCELERATION, f -> acceleration(f.sensors().acceleration()));
    line(Reading.TOF, f -> f.sensors().range().tofMm() + "mm");
    line(Reading.PAD, f -> Integer.toString(f.state().perception().reading().id()));
    table.put(Reading.ACTIVATION, f -> Reply.OK);
    line(Reading.HARDWARE, f -> profile.hardware());
    line(Reading.WIFI_VERSION, f -> "wifiv1.0.0.0");
    line(Reading.JOINED_NETWORK, f -> "");
    line(Reading.OWN_NETWORK, f -> format("RMTT-SIM%03d", f.state().drone()));
    table.put(
        Reading.BOARD_TOF, f -> new Reply("tof " + drone.instruments().boardTofMm(f.state())));
    table.put(Reading.BOARD_VERSION, f -> new Reply("esp32v1.0.0.0"));
  }

  Reply reply(Reading reading) {
    DroneState now = drone.state().get();
    return table
        .get(reading)
        .apply(new Facts(drone.instruments().read(now), now, drone.controller().speed()));
  }

  private void line(Reading reading, Function<Facts, String> value) {
    table.put(reading, facts -> Reply.line(value.apply(facts)));
  }

  private static String temperature(SensorReadings.Health health) {
    return health.temperature() + "~" + health.highTemperature() + "C";
  }

  private static String attitude(AttitudeDeg attitude) {
    return format("pitch:%d;roll:%d;yaw:%d;", attitude.pitch(), attitude.roll(), attitude.yaw());
  }

  private static String acceleration(Vec3 felt) {
    return format(
        "agx:%d.00;agy:%d.00;agz:%d.00;",
        Math.round(felt.x()), Math.round(felt.y()), Math.round(felt.z()));
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
