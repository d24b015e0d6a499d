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
 * The contents of {@code run.json}. Immutable. All times are simulated seconds since the simulation
 * began.
 *
 * @param program the version that recorded the flight
 * @param seed the random seed; empty if unknown, as for a real drone
 * @param timeFactor ratio of simulated to real time, such as {@code 1} or {@code 5}, or {@code max}
 * @param begun the start of the recording by the wall clock, in ISO 8601
 * @param started the time of the takeoff
 * @param ended the end of the flight; empty if the recording was cut off
 * @param realDrone address of the real drone that flew; empty for a simulation
 * @param result {@code reached}, {@code missed}, {@code open} or {@code none}
 * @param score the points; empty if the goals have none
 * @param setting the scenario, the room, the drones and the options of the flight
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
    Optional<RecordedScore> score,
    Setting setting) {

  /** Maximum number of drones. Decided: as many as the command line accepts. */
  private static final int MOST_DRONES = 250;

  /**
   * The format version that this program writes. It is also the newest version that it can read.
   */
  static final int FORMAT = 1;

  /**
   * The scenario, room and drones of a flight, and the options of the program.
   *
   * @param scenario title or file of the scenario; may be empty
   * @param options the command-line arguments, as far as they are known
   */
  public record Setting(String scenario, Room room, List<DroneEntry> drones, List<String> options) {

    public Setting {
      drones = List.copyOf(drones);
      options = List.copyOf(options);
    }
  }

  /**
   * A drone that took part in a flight.
   *
   * @param number the drone's number, from 1
   * @param profile the drone's profile in the spelling of the command-line option, such as {@code
   *     edu}
   * @param behavior the reference model in the spelling of the command-line option, such as {@code
   *     report}
   * @param color the colour as {@code #rrggbb}; empty if unknown
   */
  public record DroneEntry(int number, String profile, String behavior, Pose start, String color) {}

  /** The version of this program. */
  public static String version() {
    return Optional.ofNullable(RecordedRun.class.getPackage().getImplementationVersion())
        .orElse("development");
  }

  /** Returns whether a number is a valid drone number. */
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
        fields.object("score").map(RecordedScore::of),
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
