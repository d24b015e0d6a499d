package tellosimulator.report;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import tellosimulator.grade.CourseGrade;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.FlightResult.GoalResult;
import tellosimulator.recording.FlightResult.ScoreEntry;
import tellosimulator.words.Printable;

/** The page for the author of a hand-in. It runs no script. */
final class FeedbackPage {

  /** Maximum length of the shown output [bytes]. Decided: a traceback, and what led to it. */
  private static final int MOST_OUTPUT = 4_000;

  private final ClassReport report;
  private final GradedHandIn handIn;
  private final GradeWords words;

  FeedbackPage(ClassReport report, GradedHandIn handIn) {
    this.report = report;
    this.handIn = handIn;
    this.words = report.words();
  }

  /** Returns the whole page. */
  String html() throws IOException {
    List<Markup> flights = new ArrayList<>();
    for (CourseGrade course : words.courses(handIn)) {
      for (GradedFlight flight : course.flights()) {
        flights.add(flight(course, flight));
      }
    }
    String assignment = report.grades().assignment();
    String title = words.of("feedback.title", handIn.name(), assignment);
    return report
        .page("feedback.html", title, "")
        .text("name", Printable.of(handIn.name()))
        .code("summary", summary().text())
        .code("flights", Markup.all(flights.stream()).text())
        .filled();
  }

  private Markup summary() {
    String passed = words.of(handIn.passed() ? "grade.passed" : "grade.not-passed");
    Stream<Markup> badges =
        Stream.of(
            badge("", words.points(handIn.points(), handIn.of())),
            badge("", words.number(handIn.percent()) + " %"),
            report.grades().scale().range()
                ? badge("", words.of("grade.grade", words.number(handIn.grade())))
                : Markup.NONE,
            badge(handIn.passed() ? "good" : "bad", passed));
    return Markup.all(badges);
  }

  static Markup badge(String mood, String text) {
    return Markup.of("<span class=\"badge %s\">%s</span>", mood, text);
  }

  private Markup flight(CourseGrade course, GradedFlight flight) throws IOException {
    FlightResult result = flight.result();
    boolean several = course.flights().size() > 1;
    String attempt = several ? " · " + words.of("grade.attempt", flight.attempt()) : "";
    boolean good = result.verdict().equals("reached");
    return Markup.of(
        """
        <section class="panel"><div class="bar"><h2>%s%s</h2><p><strong>%s</strong></p></div>
        <div class="body"><p class="%s">%s %s</p><p class="%s">%s</p>%s%s%s<p class="muted">%s</p>
        %s</div></section>""",
        words.name(course),
        attempt,
        words.points(result.points(), result.of()),
        good ? "good" : "bad",
        good ? "✓" : "✕",
        Markup.quoted(words.verdict(flight)),
        GradeWords.ran(flight) ? "" : "bad",
        words.program(flight),
        link(flight),
        table("feedback.points", GradeWords.entries(result).stream().map(this::entry)),
        table("goals", result.goals().stream().map(this::goal)),
        counts(result),
        flight.program().isEmpty() ? Markup.NONE : output(flight));
  }

  private String counts(FlightResult result) {
    return words.of(
        "feedback.counts", result.commands(), result.refused(), result.touches(), result.crashes());
  }

  private Markup link(GradedFlight flight) {
    return Files.exists(report.report(handIn, flight))
        ? Markup.of(
            "<p><a class=\"open\" href=\"%s.html\">%s</a></p>",
            flight.name(), words.of("feedback.report"))
        : Markup.of("<p class=\"muted\">%s</p>", words.of("feedback.no-report"));
  }

  private Markup table(String caption, Stream<Markup> rows) {
    Markup all = Markup.all(rows);
    return all.equals(Markup.NONE)
        ? all
        : Markup.of(
            "<table class=\"reasons\"><caption>%s</caption><tbody>%s</tbody></table>",
            words.of(caption), all);
  }

  private Markup entry(ScoreEntry entry) {
    String mood = entry.points() > 0 ? "good" : "bad";
    return row(mood, words.signed(entry), entry.why(), words.seconds(entry.second()));
  }

  private Markup goal(GoalResult goal) {
    return goal.reached().isPresent()
        ? row("good", "✓", goal.task(), words.seconds(goal.reached().getAsDouble()))
        : row("", "○", goal.task(), words.of("not-reached"));
  }

  private Markup row(String mood, String sign, String sentence, String when) {
    return Markup.of(
        "<tr><th scope=\"row\" class=\"%s\">%s</th><td>%s</td><td>%s</td></tr>",
        mood, sign, Markup.quoted(words.said(sentence)), when);
  }

  private Markup output(GradedFlight flight) throws IOException {
    Path folder = handIn.filesOf(flight, report.folder());
    Optional<Path> file =
        Stream.of(
                folder.resolve(GradedFlight.OUTPUT),
                folder.resolveSibling(GradedFlight.BUILD_OUTPUT))
            .filter(Files::isRegularFile)
            .findFirst();
    String end = file.isPresent() ? end(file.get()) : "";
    Markup shown =
        end.isBlank()
            ? Markup.of("<p class=\"muted\">%s</p>", words.of("feedback.no-output"))
            : Markup.of("<pre tabindex=\"0\">%s</pre>", end);
    return Markup.of("<h3>%s</h3>%s", words.of("feedback.output"), shown);
  }

  /** Returns the end of a file, from the beginning of a line. */
  private static String end(Path file) throws IOException {
    try (SeekableByteChannel channel = Files.newByteChannel(file)) {
      long skipped = Math.max(0, channel.size() - MOST_OUTPUT);
      ByteBuffer bytes = ByteBuffer.allocate(MOST_OUTPUT);
      channel.position(skipped);
      while (bytes.hasRemaining() && channel.read(bytes) >= 0) {
        // reads on
      }
      String lines = new String(bytes.array(), 0, bytes.position(), StandardCharsets.UTF_8);
      String text = lines.replace("\r\n", "\n");
      return skipped == 0 ? text : "…\n" + text.substring(text.indexOf('\n') + 1);
    }
  }
}
