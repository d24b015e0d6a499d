package tellosimulator.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
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

/** What the page needs of a flight, as maps and lists for JSON. For one thread. */
final class ReportData {

  /** Most samples of all drones together. Decided: a chart has no more pixels. */
  private static final int MOST_SAMPLES = 12_000;

  /** Colours of drones that are not known. Decided: those of Okabe and Ito. */
  private static final List<String> COLORS =
      List.of("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442");

  /** Of which things there is a mark on the plan. */
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
    Map<String, Object> data = new LinkedHashMap<>();
    data.put("language", texts.language());
    data.put("texts", texts.all());
    data.put("begin", Json.rounded(begin));
    data.put("end", Json.rounded(end));
    data.put("started", Json.rounded(flight.run().started()));
    data.put("remarks", remarks);
    data.put("badges", summary.badges());
    data.put("facts", summary.facts());
    data.put("goals", summary.goals());
    data.put("room", room());
    data.put("things", FloorItems.of(snapshots.arena(), texts));
    data.putAll(new GoalItems(flight, snapshots.arena(), texts).members());
    data.put("drones", drones());
    data.put("entries", entries.stream().map(ReportEntry::members).toList());
    data.put("marks", marks(entries));
    data.put("film", new FilmStrip(snapshots).of(begin, end));
    return data;
  }

  private static String sentence(String clause) {
    return clause.substring(0, 1).toUpperCase(Locale.ROOT) + clause.substring(1) + ".";
  }

  private Map<String, Object> room() {
    Arena arena = snapshots.arena();
    Room room = arena.room();
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("width", Json.rounded(Frames.centimeters(room.width())));
    members.put("depth", Json.rounded(Frames.centimeters(room.depth())));
    members.put("grid", Json.rounded(Frames.centimeters(arena.decor().grid())));
    return members;
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

  /** Of how many samples one is shown. */
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
    Map<String, Object> drone = new LinkedHashMap<>();
    drone.put("number", number);
    drone.put(
        "color",
        entry
            .map(DroneEntry::color)
            .filter(color -> color.matches("#[0-9a-fA-F]{6}"))
            .orElse(COLORS.get((number - 1) % COLORS.size())));
    drone.put("start", start(entry.map(DroneEntry::start), shown));
    drone.put("columns", columns(shown));
    drone.put("phases", changes(samples, sample -> texts.phase(sample.phase())));
    drone.put("busy", changes(samples, Sample::command));
    return drone;
  }

  private Optional<Track> track(int drone) {
    return flight.tracks().stream().filter(track -> track.drone() == drone).findAny();
  }

  private static Map<String, Object> start(Optional<Pose> said, List<Sample> samples) {
    Vec3 place =
        said.map(Pose::position).orElse(samples.isEmpty() ? Vec3.ZERO : samples.get(0).position());
    double heading = said.map(pose -> pose.attitude().heading()).orElse(0.0);
    Map<String, Object> start = new LinkedHashMap<>();
    start.put("x", Json.rounded(Frames.centimeters(place.x())));
    start.put("y", Json.rounded(Frames.centimeters(place.y())));
    start.put("heading", Json.rounded(Frames.yawOfHeading(heading)));
    return start;
  }

  private static Map<String, Object> columns(List<Sample> samples) {
    Map<String, Object> columns = new LinkedHashMap<>();
    columns.put("t", Column.of(samples, 2, Sample::time));
    columns.put("x", Column.of(samples, 1, each -> Frames.centimeters(each.position().x())));
    columns.put("y", Column.of(samples, 1, each -> Frames.centimeters(each.position().y())));
    columns.put("z", Column.of(samples, 1, each -> Frames.centimeters(each.position().z())));
    columns.put("speed", Column.of(samples, 0, each -> Frames.centimeters(each.velocity().norm())));
    columns.put("battery", Column.of(samples, 1, Sample::batteryPercent));
    columns.put("roll", Column.of(samples, 1, each -> each.angles().roll()));
    columns.put("pitch", Column.of(samples, 1, each -> each.angles().pitch()));
    columns.put("heading", Column.of(samples, 0, each -> each.angles().heading()));
    return columns;
  }

  /** Each moment at which something becomes another one, with what it becomes. */
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

  /** Where the drone was then. */
  private static Map<String, Object> mark(ReportEntry entry, Track track) {
    Vec3 place = track.at(entry.time()).position();
    String why = entry.words().why();
    Map<String, Object> mark = new LinkedHashMap<>();
    mark.put("t", Json.rounded(entry.time()));
    mark.put("drone", track.drone());
    mark.put("kind", entry.kind());
    mark.put("text", entry.words().text() + (why.isEmpty() ? "" : ": " + why));
    mark.put("x", Json.rounded(Frames.centimeters(place.x())));
    mark.put("y", Json.rounded(Frames.centimeters(place.y())));
    return mark;
  }
}
