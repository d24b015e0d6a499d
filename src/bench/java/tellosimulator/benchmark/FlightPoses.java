package tellosimulator.benchmark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

/**
 * Where a drone was, thirty times a second, in a flight that {@link FlightPosesWriter} let it fly.
 * Kept as a table, so that pictures stay the same when the flight model changes: part, seconds,
 * place in centimetres, yaw, pitch and roll in degrees (counter-clockwise, nose up, right side
 * down).
 */
record FlightPoses(List<Moment> moments) {

  /** The flight whose pictures are encoded. */
  static final Path FILE = Path.of("src/test/resources/video/flight.csv");

  private static final String HEADER = "part,seconds,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg";
  private static final int COLUMNS = 8;

  /** Where the drone was at a moment; seconds count from the beginning of the part. */
  record Moment(FlightPart part, double seconds, Pose pose) {

    String line() {
      Vec3 place = pose.position();
      Attitude attitude = pose.attitude();
      return String.format(
          Locale.ROOT,
          "%s,%.3f,%.2f,%.2f,%.2f,%.3f,%.3f,%.3f",
          part.word(),
          seconds,
          100 * place.x(),
          100 * place.y(),
          100 * place.z(),
          Math.toDegrees(attitude.heading()),
          Math.toDegrees(attitude.elevation()),
          Math.toDegrees(attitude.bank()));
    }
  }

  FlightPoses {
    moments = List.copyOf(moments);
  }

  static FlightPoses read(Path file) {
    try {
      return parse(file.getFileName().toString(), Files.readAllLines(file));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * @param name of the file, for complaints
   */
  static FlightPoses parse(String name, List<String> lines) {
    List<Moment> moments = new ArrayList<>();
    for (int i = 1; i < lines.size(); i++) {
      try {
        moments.add(moment(lines.get(i).split(",", -1)));
      } catch (IllegalArgumentException e) {
        throw new IllegalArgumentException(
            name + ":" + (i + 1) + ": expected " + HEADER + ", found \"" + lines.get(i) + "\"", e);
      }
    }
    return new FlightPoses(moments);
  }

  private static Moment moment(String[] cells) {
    if (cells.length != COLUMNS) {
      throw new IllegalArgumentException(cells.length + " columns");
    }
    double[] numbers = new double[COLUMNS];
    for (int i = 1; i < COLUMNS; i++) {
      numbers[i] = Double.parseDouble(cells[i]);
    }
    Vec3 place = new Vec3(numbers[2], numbers[3], numbers[4]).times(0.01);
    Attitude attitude =
        Attitude.ofHeading(Math.toRadians(numbers[5]))
            .after(pitched(Math.toRadians(numbers[6])))
            .after(rolled(Math.toRadians(numbers[7])));
    FlightPart part = FlightPart.valueOf(cells[0].toUpperCase(Locale.ROOT));
    return new Moment(part, numbers[1], new Pose(place, attitude));
  }

  private static Attitude pitched(double up) {
    return new Attitude(Math.cos(up / 2), 0, -Math.sin(up / 2), 0);
  }

  private static Attitude rolled(double right) {
    return new Attitude(Math.cos(right / 2), Math.sin(right / 2), 0, 0);
  }

  List<Moment> part(FlightPart part) {
    return moments.stream().filter(moment -> moment.part() == part).toList();
  }

  /** As in the file. */
  List<String> lines() {
    List<String> lines = new ArrayList<>(List.of(HEADER));
    moments.forEach(moment -> lines.add(moment.line()));
    return lines;
  }
}
