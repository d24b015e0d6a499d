package tellosimulator.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.StringJoiner;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.recording.FlightSnapshots;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedRun.DroneEntry;
import tellosimulator.recording.Sample;
import tellosimulator.recording.Track;
import tellosimulator.world.Arena;
import tellosimulator.world.Room;

/** Collects the data of the page as maps and lists for JSON. Not thread-safe. */
final class ReportData {

  /** Maximum total number of samples for all drones. Decided: no chart has more pixels. */
  private static final int MOST_SAMPLES = 12_000;

  /** Colours of drones whose colour is unknown. Decided: the palette of Okabe and Ito. */
  private static final List<String> COLORS =
      List.of("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442");

  /** Kinds of entries that are marked on the plan. */
  private static final Set<String> MARKED = Set.of("refused", "failed", "crashed", "touched");

  private final RecordedFlight flight;
  private final ReportTexts texts;
  private final FlightSnapshots snapshots;
  private final double begin;
  private final double end;

  ReportData(RecordedFlight flight, ReportTexts texts) {
    this.flight = flight;
    this.texts = texts;
    snapshots = new FlightSnapshots(flight);
    begin = flight.shownBegin();
    end = Math.max(begin, flight.end());
  }

  Map<String, Object> members() {
    List<ReportEntry> entries = new ReportEntries(texts).of(flight);
    List<String> remarks =
        new ArrayList<>(
            flight.remarks().stream().map(texts::say).map(ReportData::sentence).toList());
    if (entries.size() > ReportEntries.MOST) {
      remarks.add(texts.of("too-many-entries", entries.size(), ReportEntries.MOST));
      entries = entries.subList(0, ReportEntries.MOST);
    }
    ReportSummary summary = new ReportSummary(flight, texts);
    Map<String, Object> data =
        Json.object(
            "language", texts.language(),
            "texts", texts.all(),
            "begin", begin,
            "end", end,
            "started", flight.run().started(),
            "remarks", remarks,
            "badges", summary.badges(),
            "facts", summary.facts(),
            "goals", summary.goals(),
            "score", summary.score(),
            "room", room(),
            "things", measured() ? FloorItems.of(snapshots.arena(), texts) : List.of(),
            "drones", drones(),
            "entries", entries.stream().map(ReportEntry::members).toList(),
            "marks", marks(entries),
            "film", measured() ? new FilmStrip(snapshots).of(begin, end) : FilmStrip.NONE);
    data.putAll(new GoalItems(flight, snapshots.arena(), texts).members());
    return data;
  }

  private static String sentence(String clause) {
    return clause.substring(0, 1).toUpperCase(Locale.ROOT) + clause.substring(1) + ".";
  }

  /** Whether the dimensions of the room are known; for a real drone, they are not. */
  private boolean measured() {
    return flight.run().realDrone().isEmpty();
  }

  private Map<String, Object> room() {
    Arena arena = snapshots.arena();
    Room room = measured() ? arena.room() : flown();
    return Json.object(
        "width", Frames.centimeters(room.width()),
        "depth", Frames.centimeters(room.depth()),
        "measured", measured(),
        "grid", Frames.centimeters(arena.decor().grid()));
  }

  /** Returns a room that contains all paths with a margin of one metre. */
  private Room flown() {
    List<Vec3> places =
        flight.tracks().stream()
            .flatMap(track -> track.samples().stream())
            .map(Sample::position)
            .toList();
    double x = places.stream().mapToDouble(place -> Math.abs(place.x())).max().orElse(0);
    double y = places.stream().mapToDouble(place -> Math.abs(place.y())).max().orElse(0);
    return new Room(2 * y + 2, 2 * x + 2, Room.DEFAULT.height());
  }

  private List<Object> drones() {
    Set<Integer> numbers = new TreeSet<>();
    flight.run().setting().drones().forEach(drone -> numbers.add(drone.number()));
    flight.tracks().forEach(track -> numbers.add(track.drone()));
    if (numbers.isEmpty()) {
      numbers.add(1);
    }
    int stride = stride();
    List<Object> drones = new ArrayList<>();
    numbers.forEach(number -> drones.add(drone(number, stride)));
    return drones;
  }

  /** Returns the interval between the samples that are shown; 1 if all are shown. */
  private int stride() {
    int all = flight.tracks().stream().mapToInt(track -> track.samples().size()).sum();
    return Math.max(1, (all + MOST_SAMPLES - 1) / MOST_SAMPLES);
  }

  private Map<String, Object> drone(int number, int stride) {
    Optional<DroneEntry> entry =
        flight.run().setting().drones().stream().filter(each -> each.number() == number).findAny();
    List<Sample> samples = track(number).map(Track::samples).orElse(List.of());
    List<Sample> shown = new ArrayList<>();
    for (int i = 0; i < samples.size(); i += stride) {
      shown.add(samples.get(i));
    }
    Optional<String> color =
        entry.map(DroneEntry::color).filter(rgb -> rgb.matches("#[0-9a-fA-F]{6}"));
    return Json.object(
        "number", number,
        "color", color.orElse(COLORS.get((number - 1) % COLORS.size())),
        "start", start(entry.map(DroneEntry::start), shown),
        "columns", columns(shown),
        "phases", changes(samples, shown, sample -> texts.phase(sample.phase())),
        "busy", changes(samples, shown, Sample::command));
  }

  private Optional<Track> track(int drone) {
    return flight.tracks().stream().filter(track -> track.drone() == drone).findAny();
  }

  private static Map<String, Object> start(Optional<Pose> said, List<Sample> samples) {
    Vec3 place =
        said.map(Pose::position).orElse(samples.isEmpty() ? Vec3.ZERO : samples.get(0).position());
    double heading = said.map(pose -> pose.attitude().heading()).orElse(0.0);
    return Json.object(
        "x", Frames.centimeters(place.x()),
        "y", Frames.centimeters(place.y()),
        "heading", Frames.yawOfHeading(heading));
  }

  private static Map<String, Object> columns(List<Sample> samples) {
    return Json.object(
        "t", column(samples, 2, Sample::time),
        "x", column(samples, 1, each -> Frames.centimeters(each.position().x())),
        "y", column(samples, 1, each -> Frames.centimeters(each.position().y())),
        "z", column(samples, 1, each -> Frames.centimeters(each.position().z())),
        "speed", column(samples, 0, each -> Frames.centimeters(each.velocity().norm())),
        "battery", column(samples, 1, Sample::batteryPercent),
        "roll", column(samples, 1, each -> each.angles().roll()),
        "pitch", column(samples, 1, each -> each.angles().pitch()),
        "heading", column(samples, 0, each -> each.angles().heading()));
  }

  /**
   * Formats a column in a form that is compact and fast to parse, such as {@code 0 1.5 3}.
   *
   * @param decimals maximum number of decimals, without trailing zeros
   */
  private static String column(List<Sample> samples, int decimals, ToDoubleFunction<Sample> value) {
    double power = Math.pow(10, decimals);
    StringJoiner column = new StringJoiner(" ");
    for (Sample sample : samples) {
      double rounded = Math.round(value.applyAsDouble(sample) * power) / power;
      boolean whole = rounded == Math.rint(rounded);
      column.add(whole ? Long.toString((long) rounded) : Double.toString(rounded));
    }
    return column.toString();
  }

  /**
   * Returns the changes of a value in all samples. If there are too many, only the samples shown
   * are used.
   */
  private static List<Object> changes(
      List<Sample> samples, List<Sample> shown, Function<Sample, String> value) {
    List<Object> all = changes(samples, value);
    return all.size() <= MOST_SAMPLES ? all : changes(shown, value);
  }

  /** Returns the times at which a value changes, each with the new value. */
  private static List<Object> changes(List<Sample> samples, Function<Sample, String> value) {
    List<Object> changes = new ArrayList<>();
    String before = null;
    for (Sample sample : samples) {
      String now = value.apply(sample);
      if (!now.equals(before)) {
        changes.add(List.of(Json.rounded(sample.time()), now));
        before = now;
      }
    }
    return changes;
  }

  private List<Object> marks(List<ReportEntry> entries) {
    List<Object> marks = new ArrayList<>();
    for (ReportEntry entry : entries) {
      if (MARKED.contains(entry.kind()) && entry.drone().isPresent()) {
        track(entry.drone().getAsInt()).ifPresent(track -> marks.add(mark(entry, track)));
      }
    }
    return marks;
  }

  /** Returns a mark at the drone's position at the time of the entry. */
  private static Map<String, Object> mark(ReportEntry entry, Track track) {
    Vec3 place = track.at(entry.time()).position();
    String why = entry.words().why();
    return Json.object(
        "t", entry.time(),
        "drone", track.drone(),
        "kind", entry.kind(),
        "text", entry.words().text() + (why.isEmpty() ? "" : ": " + why),
        "x", Frames.centimeters(place.x()),
        "y", Frames.centimeters(place.y()));
  }
}
