package tellosimulator.recording;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.world.Room;

/**
 * What {@code run.json} says of a flight. Immutable; for any thread. All times in simulated seconds
 * since the simulation began.
 *
 * @param program version that recorded it
 * @param seed empty if it is not known, as of a real drone
 * @param timeFactor how fast simulated time passed: {@code 1}, {@code 5} or {@code max}
 * @param begun when the recording began, on the wall clock, by ISO 8601
 * @param started the takeoff
 * @param ended empty if the recording was cut off
 * @param realDrone address of the real drone that flew, of which only the wire is known; empty of a
 *     simulation
 * @param result {@code reached}, {@code missed}, {@code open} or {@code none}
 * @param setting where it was flown, and by which drones
 */
public record RecordedRun(
    String program,
    Optional<Long> seed,
    String timeFactor,
    String begun,
    double started,
    OptionalDouble ended,
    Optional<String> realDrone,
    String result,
    Setting setting) {

  /** Most drones. Decided: as many as the command line takes. */
  private static final int MOST_DRONES = 250;

  /** The format that this version writes, and the newest that it knows. */
  static final int FORMAT = 1;

  /**
   * Where a flight was flown, and by which drones.
   *
   * @param scenario title or file of the scenario; may be empty
   * @param options words of the command line, as far as they are known
   */
  public record Setting(String scenario, Room room, List<DroneEntry> drones, List<String> options) {

    public Setting {
      drones = List.copyOf(drones);
      options = List.copyOf(options);
    }
  }

  /**
   * A drone of a flight.
   *
   * @param number from 1
   * @param profile the option's word for what it is: {@code edu}
   * @param behavior the option's word for the account of it: {@code report}
   * @param color as {@code #rrggbb}; empty if it is not known
   */
  public record DroneEntry(int number, String profile, String behavior, Pose start, String color) {}

  /** The version of this program. */
  public static String version() {
    return Optional.ofNullable(RecordedRun.class.getPackage().getImplementationVersion())
        .orElse("development");
  }

  /** Whether a drone can have this number. */
  static boolean isNumber(int drone) {
    return drone >= 1 && drone <= MOST_DRONES;
  }

  static RecordedRun of(Fields fields) {
    return new RecordedRun(
        fields.text("program"),
        fields.large("seed"),
        fields.text("timeFactor"),
        fields.text("begun"),
        fields.moment("started").orElse(0),
        fields.number("ended"),
        Optional.of(fields.text("realDrone")).filter(address -> !address.isEmpty()),
        fields.text("result"),
        new Setting(
            fields.text("scenario"),
            fields.object("room").flatMap(RecordedRun::room).orElse(Room.DEFAULT),
            fields.objects("drones").stream()
                .map(RecordedRun::drone)
                .filter(drone -> isNumber(drone.number()))
                .toList(),
            fields.texts("options")));
  }

  private static Optional<Room> room(Fields fields) {
    try {
      return Optional.of(
          new Room(
              Frames.meters(fields.numberOr("width", 0)),
              Frames.meters(fields.numberOr("depth", 0)),
              Frames.meters(fields.numberOr("height", 0))));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static DroneEntry drone(Fields fields) {
    Optional<Fields> start = fields.object("start");
    Vec3 place = start.flatMap(Fields::place).orElse(Vec3.ZERO);
    double headingDeg = start.map(each -> each.numberOr("heading", 0)).orElse(0.0);
    return new DroneEntry(
        fields.whole("number").orElse(1),
        fields.text("profile"),
        fields.text("behaviour"),
        new Pose(place, Attitude.ofHeading(Frames.headingOfYaw(headingDeg))),
        fields.text("color"));
  }
}
