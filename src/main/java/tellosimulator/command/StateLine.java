package tellosimulator.command;

import tellosimulator.math.Vec3;
import tellosimulator.model.PadReading;
import tellosimulator.profile.Profile;
import tellosimulator.sensor.SensorReadings;

/** Formats the state of a drone as one line of {@code key:value;} pairs. */
final class StateLine {

  private static final int TYPICAL_LENGTH = 192;

  private final StringBuilder out = new StringBuilder(TYPICAL_LENGTH);

  private StateLine() {}

  /** Returns the line, including its line end. The line of a white Tello has no pad fields. */
  static String format(Profile profile, PadReading pad, SensorReadings sensors) {
    StateLine line = new StateLine();
    if (profile.hasPads()) {
      line.pad(pad, profile);
    }
    line.sensors(sensors);
    return line.out.append("\r\n").toString();
  }

  private void pad(PadReading pad, Profile profile) {
    Vec3 position = pad.positionCm();
    Vec3 attitude = pad.seen() ? pad.attitudeDeg() : profile.attitudeWithoutPad();
    field("mid", pad.id());
    field("x", Math.round(position.x()));
    field("y", Math.round(position.y()));
    field("z", Math.round(position.z()));
    out.append("mpry:").append(Math.round(attitude.x()));
    out.append(',').append(Math.round(attitude.y()));
    out.append(',').append(Math.round(attitude.z())).append(';');
  }

  private void sensors(SensorReadings sensors) {
    field("pitch", sensors.attitude().pitch());
    field("roll", sensors.attitude().roll());
    field("yaw", sensors.attitude().yaw());
    field("vgx", Math.round(sensors.velocityDm().x()));
    field("vgy", Math.round(sensors.velocityDm().y()));
    field("vgz", Math.round(sensors.velocityDm().z()));
    field("templ", sensors.health().temperature());
    field("temph", sensors.health().highTemperature());
    field("tof", sensors.range().tofMm() / 10);
    field("h", sensors.range().heightDm() * 10L);
    field("bat", sensors.health().batteryPercent());
    hundredths("baro", Math.round(sensors.barometer() * 100));
    field("time", sensors.health().motorSeconds());
    hundredths("agx", Math.round(sensors.acceleration().x()) * 100);
    hundredths("agy", Math.round(sensors.acceleration().y()) * 100);
    hundredths("agz", Math.round(sensors.acceleration().z()) * 100);
  }

  private void field(String key, long value) {
    out.append(key).append(':').append(value).append(';');
  }

  private void hundredths(String key, long value) {
    long size = Math.abs(value);
    out.append(key).append(':').append(value < 0 ? "-" : "").append(size / 100).append('.');
    out.append((char) ('0' + size / 10 % 10)).append((char) ('0' + size % 10)).append(';');
  }
}
