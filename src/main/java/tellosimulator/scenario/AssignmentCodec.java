package tellosimulator.scenario;

import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.Assignment.AssignedCourse;
import tellosimulator.scenario.Assignment.Limits;
import tellosimulator.scenario.Assignment.Pace;
import tellosimulator.scenario.Assignment.Scale;
import tellosimulator.scenario.Assignment.Setup;
import tellosimulator.scenario.Assignment.Take;
import tellosimulator.scenario.Codec.Context;
import tellosimulator.scenario.ListCodec.Item;
import tellosimulator.scenario.Quantity.Unit;
import tellosimulator.words.Phrase;
import tellosimulator.words.Printable;

/** Codec of an assignment file. */
final class AssignmentCodec extends RecordCodec<Assignment> {

  /** Files that are started if an assignment names none. Decided: the usual languages. */
  private static final List<String> USUAL_ENTRIES =
      List.of("fly.py", "Fly.java", "*.py", "*.java", "*.jar", "*.js");

  /** Commands that start an interpreter without any file. */
  private static final Pattern FILELESS = Pattern.compile("(python3?|java|node)(\\s+-\\S*)*");

  private static final int MOST_COURSES = 100;

  static final AssignmentCodec CODEC = new AssignmentCodec();

  private final Field<Assignment, String> name =
      key("name", "Name of the assignment.").need(Scalars.LINE, Assignment::name);
  private final Field<Assignment, List<AssignedCourse>> courses =
      key("courses", "Scenarios to fly.").need(list(course(), MOST_COURSES), Assignment::courses);
  private final Field<Assignment, Integer> attempts =
      key("attempts", "Number of flights of each course.")
          .usual(
              Scalars.count(Phrase.of("a number from 1 to %d", 20), 1, 20).or(1),
              Assignment::attempts);
  private final Field<Assignment, Take> take =
      key("take", "The attempt that counts.")
          .usual(WordCodec.of(Take.values()).or(Take.BEST), Assignment::take);
  private final Field<Assignment, List<String>> entry =
      key("entry", "Name or pattern of the file to start; of several, the first that exists.")
          .usual(entries().or(USUAL_ENTRIES), Assignment::entry);
  private final Field<Assignment, String> command =
      key("command", "Command that starts the file. Default: chosen by the file's ending.")
          .optional(Scalars.LINE, Assignment::command);
  private final Field<Assignment, String> build =
      key("build", "Command that is run once before the first flight.")
          .optional(Scalars.LINE, Assignment::build);
  private final Field<Assignment, Setup> setup =
      key("options", "").usual(setup().or(Setup.DEFAULT), Assignment::setup);
  private final Field<Assignment, Limits> limits =
      key("limits", "").usual(limits().or(Limits.DEFAULT), Assignment::limits);
  private final Field<Assignment, Scale> scale =
      key("scale", "").usual(scale().or(Scale.DEFAULT), Assignment::scale);

  private AssignmentCodec() {
    super("assignment", Phrase.of("an assignment"), "An assignment of the Tello Simulator.");
    checked(this::check);
    made(
        in ->
            new Assignment(
                in.get(name),
                in.get(courses),
                in.get(attempts),
                in.get(take),
                in.get(entry),
                in.find(command),
                in.find(build),
                in.get(setup),
                in.get(limits),
                in.get(scale)));
  }

  private void check(Entries in) {
    List<String> scenarios = in.get(courses).stream().map(AssignedCourse::scenario).toList();
    scenarios.stream()
        .filter(each -> Collections.frequency(scenarios, each) > 1)
        .findFirst()
        .ifPresent(
            each ->
                in.diagnostic(
                    courses,
                    Phrase.of("the course %s is there twice: list its seeds in one place", each)));
    if (in.find(command).filter(each -> FILELESS.matcher(each).matches()).isPresent()) {
      in.diagnostic(
          command, Phrase.of("the command starts no file: write {file} where its name belongs"));
    }
    int flights =
        in.get(courses).stream().mapToInt(each -> Math.max(1, each.seeds().size())).sum()
            * in.get(attempts);
    if (flights == 0) {
      in.diagnostic(courses, Phrase.of("an assignment needs at least one course"));
    } else if (flights > Assignment.MOST_FLIGHTS) {
      in.diagnostic(
          courses,
          Phrase.of(
              "expected at most %d flights of each hand-in, found %d",
              Assignment.MOST_FLIGHTS, flights));
    }
  }

  private static <T> Codec<List<T>> list(Codec<T> codec, int most) {
    return new ListCodec<>(codec, most).map(Item::values, Item::of);
  }

  /** Returns the codec of a list of patterns, whose brackets may be left out if it is only one. */
  private static Codec<List<String>> entries() {
    Codec<String> pattern = Scalars.LINE.readBy(AssignmentCodec::pattern);
    return list(pattern, MOST_COURSES).orShort(pattern.map(List::of, all -> all.get(0)));
  }

  private static RecordCodec<Setup> setup() {
    RecordCodec<Setup> codec =
        new RecordCodec<>(
            "options", Phrase.of("options"), "Settings that override those of the scenarios.");
    Field<Setup, Profile> profile =
        codec
            .key("profile", "Tello EDU, white Tello or RoboMaster TT.")
            .optional(WordCodec.of(Profile.values()), Setup::profile);
    Field<Setup, Behavior> behavior =
        codec
            .key("behaviour", "Exact, or with the noise and delays of real drones.")
            .optional(WordCodec.of(Behavior.values()), Setup::behavior);
    Field<Setup, LinkPreset> link =
        codec
            .key("link", "Quality of the radio link.")
            .optional(WordCodec.of(LinkPreset.values()), Setup::link);
    Field<Setup, List<Fault>> faults =
        codec
            .key("faults", "Faults.")
            .usual(list(new FaultCodec(), MOST_COURSES).or(List.of()), Setup::faults);
    Field<Setup, Pace> pace =
        codec
            .key(
                "time-factor",
                "Speed of simulated time: max, real, or auto (max if the program waits for replies).")
            .usual(WordCodec.of(Pace.values()).or(Pace.AUTO), Setup::pace);
    return codec.made(
        in ->
            new Setup(
                in.find(profile), in.find(behavior), in.find(link), in.get(faults), in.get(pace)));
  }

  private static RecordCodec<Limits> limits() {
    RecordCodec<Limits> codec =
        new RecordCodec<>("limits", Phrase.of("limits"), "Limits of each flight.");
    NumberCodec seconds = NumberCodec.seconds(new Quantity(Unit.SECOND, 1, 36_000));
    Field<Limits, Double> wall =
        limit(
            codec.key("wall", "Maximum real time for the program, in seconds."),
            seconds,
            Limits::wallSeconds);
    Field<Limits, Double> time =
        limit(
            codec.key("time", "Simulated seconds for the flight."),
            seconds,
            Limits::simulatedSeconds);
    Field<Limits, Integer> output =
        limit(
            codec.key("output", "Bytes that are kept of what it prints."),
            count(1000, 100_000_000),
            Limits::outputBytes);
    Field<Limits, Integer> memory =
        limit(
            codec.key("memory", "Megabytes for all its processes."),
            count(16, 1_000_000),
            Limits::memoryMb);
    Field<Limits, Integer> processes =
        limit(
            codec.key("processes", "Maximum number of processes at a time."),
            count(1, 10_000),
            Limits::processes);
    Field<Limits, Integer> disk =
        limit(codec.key("disk", "Megabytes for its files."), count(1, 2000), Limits::diskMb);
    return codec.made(
        in ->
            new Limits(
                in.get(wall),
                in.get(time),
                in.get(output),
                in.get(memory),
                in.get(processes),
                in.get(disk)));
  }

  private static <V> Field<Limits, V> limit(
      Field.Key<Limits> key, Codec<V> codec, Function<Limits, V> getter) {
    return key.usual(codec.or(getter.apply(Limits.DEFAULT)), getter);
  }

  private static Codec<Integer> count(int least, int most) {
    return Scalars.count(Phrase.of("a whole number from %d to %d", least, most), least, most);
  }

  private static RecordCodec<Scale> scale() {
    RecordCodec<Scale> codec =
        new RecordCodec<>("scale", Phrase.of("a scale"), "Conversion of points to a grade.");
    NumberCodec number =
        new NumberCodec(
            new Quantity(Unit.ONE, -1000, 1000), Phrase.of("a number from -1000 to 1000"));
    NumberCodec percent =
        new NumberCodec(new Quantity(Unit.ONE, 0, 100), Phrase.of("a percentage from 0 to 100"));
    Field<Scale, Boolean> range =
        codec
            .key("kind", "Whether the grade is a percentage or a number in a range.")
            .usual(
                new WordCodec<>(Map.of("percent", false, "range", true)).or(false), Scale::range);
    Field<Scale, Double> from =
        codec.key("from", "Grade for no points.").usual(number.or(0.0), Scale::from);
    Field<Scale, Double> to =
        codec.key("to", "Grade for all points.").usual(number.or(100.0), Scale::to);
    Field<Scale, Double> passedFrom =
        codec
            .key("passed-from", "Minimum percentage to pass.")
            .usual(percent.or(Scale.DEFAULT.passedFrom()), Scale::passedFrom);
    codec.checked(
        in -> {
          if (in.nodes().containsKey("to") && in.get(from).equals(in.get(to))) {
            in.diagnostic(to, Phrase.of("a scale needs two different grades"));
          }
        });
    codec.add(Case.of("kind", "range").needs("from", "to"));
    codec.add(Case.without("kind").excludes("from", "to"));
    codec.add(Case.of("kind", "percent").excludes("from", "to"));
    return codec.made(in -> new Scale(in.get(range), in.get(from), in.get(to), in.get(passedFrom)));
  }

  /** Returns the codec of a course: a scenario, or a mapping with the scenario and its seeds. */
  private static Codec<AssignedCourse> course() {
    Codec<String> name = Scalars.LINE.readBy(AssignmentCodec::scenario);
    RecordCodec<AssignedCourse> codec =
        new RecordCodec<>("course", Phrase.of("a course"), "A scenario with seeds.");
    Field<AssignedCourse, String> scenario =
        codec
            .key("scenario", "File of the scenario, or its name.")
            .need(name, AssignedCourse::scenario);
    Field<AssignedCourse, List<Long>> seeds =
        codec
            .key("seeds", "Seeds with which it is flown.")
            .usual(
                list(Scalars.SEED, Assignment.MOST_FLIGHTS).or(List.of()), AssignedCourse::seeds);
    codec.checked(
        in -> {
          List<Long> given = in.get(seeds);
          if (in.nodes().containsKey("seeds") && given.isEmpty()) {
            in.diagnostic(seeds, Phrase.of("expected at least one seed, found none"));
          } else if (new HashSet<>(given).size() < given.size()) {
            in.diagnostic(seeds, Phrase.of("a seed is there twice"));
          }
        });
    return codec
        .made(in -> new AssignedCourse(in.get(scenario), in.get(seeds)))
        .orShort(name.map(only -> new AssignedCourse(only, List.of()), AssignedCourse::scenario));
  }

  /** Reads a scenario's file, relative to the folder of the assignment, or its name. */
  private static Optional<String> scenario(Node node, Context context) {
    return Scalars.LINE.read(node, context).flatMap(word -> found(word, node, context));
  }

  private static Optional<String> found(String word, Node node, Context context) {
    try {
      Path file = context.folder().resolve(word).normalize();
      if (Files.isRegularFile(file)) {
        return Optional.of(file.toString());
      }
    } catch (InvalidPathException e) {
      // reported below, unless it is a name
    }
    return Gallery.NAMES.contains(word)
        ? Optional.of(word)
        : context
            .diagnostics()
            .add(
                node,
                Phrase.of("there is neither a file nor a scenario %s", Printable.quoted(word)));
  }

  /** Reads the name of a file, or a pattern for it. */
  private static Optional<String> pattern(Node node, Context context) {
    Optional<String> line = Scalars.LINE.read(node, context);
    try {
      line.ifPresent(each -> FileSystems.getDefault().getPathMatcher("glob:" + each));
      return line;
    } catch (PatternSyntaxException e) {
      return context
          .diagnostics()
          .expected(Phrase.of("the name of a file, or a pattern such as \"*.py\""), node);
    }
  }

  /** Returns the JSON schema of assignment files. */
  Map<String, Object> jsonSchema() {
    return document("Assignment of the Tello Simulator");
  }
}
