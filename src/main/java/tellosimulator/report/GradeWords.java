package tellosimulator.report;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.goal.Score;
import tellosimulator.grade.CourseGrade;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.grade.Grades;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.FlightResult.ScoreEntry;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.scenario.Assignment.Take;
import tellosimulator.words.Phrase;

/**
 * Describes grades in the language of the pages. Results contain English sentences; the phrases of
 * the recordings translate them. Not thread-safe.
 */
final class GradeWords {

  /** How a program ended, where it contains a number. */
  private static final Pattern NUMBERED = Pattern.compile("exit ([0-9]+)|killed after ([0-9]+) s");

  private final ReportTexts texts;
  private final Take take;
  private final Map<String, Phrase> phrases = new HashMap<>();
  private final Set<String> severalSeeds = new HashSet<>();
  private final Map<String, String> titles;

  GradeWords(Grades grades, ReportTexts texts) {
    this.texts = texts;
    this.take = grades.take();
    boolean unique = Set.copyOf(grades.titles().values()).size() == grades.titles().size();
    this.titles = unique ? grades.titles() : Map.of();
    Map<String, Long> seeds = new HashMap<>();
    for (GradedHandIn handIn : grades.handIns()) {
      for (GradedFlight flight : handIn.flights()) {
        Long before = seeds.putIfAbsent(flight.course(), flight.seed());
        if (before != null && before != flight.seed()) {
          severalSeeds.add(flight.course());
        }
      }
    }
  }

  /** Remembers the phrases of a recording, as translations of their English texts. */
  void learn(RecordedFlight flight) {
    flight.goals().forEach(goal -> learn(goal.phrase()));
    flight.events().forEach(event -> learn(event.phrase()));
    flight.run().score().ifPresent(each -> each.score().entries().forEach(e -> learn(e.why())));
  }

  private void learn(Phrase phrase) {
    phrases.put(phrase.english(), phrase);
    for (Object value : phrase.values()) {
      if (value instanceof Phrase part) {
        learn(part);
      }
    }
  }

  /** Returns a sentence of a result in the language of the pages, as far as it is known. */
  String said(String english) {
    Phrase phrase = phrases.get(english);
    return phrase == null ? english : texts.say(phrase);
  }

  String of(String key, Object... values) {
    return texts.of(key, values);
  }

  ReportTexts texts() {
    return texts;
  }

  /** Returns a number with at most two decimals. */
  String number(double number) {
    return texts.say(Score.number(number));
  }

  String points(double points, double of) {
    return texts.of("score.total", number(points), number(of));
  }

  /** Returns the courses of a hand-in. */
  List<CourseGrade> courses(GradedHandIn handIn) {
    return CourseGrade.all(handIn.flights(), take);
  }

  /** Returns the title of a course, given its name. */
  String title(String course) {
    return titles.getOrDefault(course, course);
  }

  /** Returns the title of a course, with its seed if it is flown with several. */
  String name(CourseGrade course) {
    String title = title(course.course());
    return severalSeeds.contains(course.course())
        ? texts.of("grade.course", title, course.seed())
        : title;
  }

  /** Returns the time of the best flights of a hand-in [simulated s]. */
  double time(GradedHandIn handIn) {
    return courses(handIn).stream().mapToDouble(each -> each.best().result().seconds()).sum();
  }

  /** Returns the points of an entry with their sign. */
  String signed(ScoreEntry entry) {
    return (entry.points() > 0 ? "+" : "−") + number(Math.abs(entry.points()));
  }

  String seconds(double seconds) {
    return texts.of("seconds", seconds);
  }

  /** Returns the verdict as a sentence. */
  String verdict(GradedFlight flight) {
    FlightResult result = flight.result();
    return switch (result.verdict()) {
      case "reached" -> texts.of("verdict.reached", seconds(result.seconds()));
      case "failed" -> texts.of("verdict.failed", said(result.reason().orElse("–")));
      case "missed" -> texts.of("verdict.missed", result.reached(), result.goals().size());
      default ->
          texts.of("verdict.not-flown")
              + flight.problem().map(why -> " " + texts.say(why)).orElse("");
    };
  }

  /** Returns how a program ended as a sentence. */
  String program(GradedFlight flight) {
    Matcher numbered = NUMBERED.matcher(flight.program());
    if (numbered.matches()) {
      boolean exit = numbered.group(1) != null;
      return texts.of(exit ? "program.exit" : "program.killed", numbered.group(exit ? 1 : 2));
    }
    String key = "program." + flight.program().replaceAll("[^a-z]+", "-");
    return texts.template(key).orElse(flight.program());
  }

  /** Returns whether a program ran as intended. */
  static boolean ran(GradedFlight flight) {
    return Set.of("ended", "stopped after the verdict").contains(flight.program());
  }

  /** Returns why the points of a course are as they are, a line for each reason. */
  String reasons(CourseGrade course) {
    List<String> lines = new ArrayList<>();
    for (GradedFlight flight : course.flights()) {
      FlightResult result = flight.result();
      if (course.flights().size() > 1) {
        String attempt = texts.of("grade.attempt", flight.attempt());
        lines.add(attempt + ": " + points(result.points(), result.of()));
      }
      lines.add(verdict(flight));
      lines.add(program(flight));
      for (ScoreEntry entry : entries(result)) {
        lines.add(signed(entry) + " · " + seconds(entry.second()) + ": " + said(entry.why()));
      }
    }
    return String.join("\n", lines);
  }

  /** Returns the points won and lost; none if the scenario gives none. */
  static List<ScoreEntry> entries(FlightResult result) {
    return result.score().map(FlightResult.ScoreResult::entries).orElse(List.of());
  }
}
