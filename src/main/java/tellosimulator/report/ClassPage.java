package tellosimulator.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.grade.CourseGrade;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.grade.Grades;
import tellosimulator.recording.FlightResult.GoalResult;

/** The page of a class: a table that can be sorted, the distribution of points, and the goals. */
final class ClassPage {

  /** Number of bars of the distribution. Decided: ten per cent each. */
  private static final int BARS = 10;

  /** Height of the tallest bar, in units of the drawing. */
  private static final int TALLEST = 84;

  private final ClassReport report;
  private final Grades grades;
  private final GradeWords words;

  ClassPage(ClassReport report) {
    this.report = report;
    this.grades = report.grades();
    this.words = report.words();
  }

  /** A column of the table. */
  private record Column(String name, boolean number, Function<GradedHandIn, Markup> cell) {

    Markup heading() {
      return Markup.of(
          "<th scope=\"col\" class=\"%s\"><button type=\"button\">%s</button></th>",
          number ? "number" : "", name);
    }
  }

  /**
   * Returns the whole page.
   *
   * @param leaderboard whether it links to the leaderboard
   */
  String html(boolean leaderboard) {
    List<GradedHandIn> all = grades.handIns();
    List<Column> columns = columns();
    long passed = all.stream().filter(GradedHandIn::passed).count();
    double mean = all.stream().mapToDouble(GradedHandIn::percent).average().orElse(0);
    Stream<Markup> summary =
        Stream.of(
            grades.complete()
                ? FeedbackPage.badge("", words.of("class.hand-ins", all.size()))
                : FeedbackPage.badge("bad", words.of("class.partial", all.size(), grades.all())),
            FeedbackPage.badge("good", words.of("class.passed", passed, all.size())),
            FeedbackPage.badge("", words.of("class.mean", mean)));
    Markup link =
        Markup.of(
            "<p><a href=\"%s\">%s</a></p>", ClassReport.LEADERBOARD, words.of("class.leaderboard"));
    String title = words.of("class.title", grades.assignment());
    return report
        .page("class.html", title, HtmlTemplate.resource("class.js"))
        .code("summary", Markup.all(summary).text())
        .code("head", Markup.all(columns.stream().map(Column::heading)).text())
        .code("rows", Markup.all(all.stream().map(each -> row(columns, each))).text())
        .code("distribution", distribution().text())
        .code("goals", Markup.all(goalCounts().stream().map(this::goal)).text())
        .code("leaderboard", leaderboard ? link.text() : "")
        .filled();
  }

  // --- the table ---

  private static Markup row(List<Column> columns, GradedHandIn handIn) {
    return Markup.of(
        "<tr>%s</tr>", Markup.all(columns.stream().map(each -> each.cell.apply(handIn))));
  }

  private List<Column> columns() {
    List<Column> columns = new ArrayList<>();
    columns.add(new Column(words.of("class.hand-in"), false, ClassPage::name));
    addText(columns, "class.id", GradedHandIn::id);
    addText(columns, "class.group", GradedHandIn::group);
    grades.handIns().stream()
        .flatMap(each -> words.courses(each).stream())
        .map(words::name)
        .distinct()
        .forEach(course -> columns.add(new Column(course, true, each -> points(course, each))));
    columns.add(new Column(words.of("class.points"), true, this::points));
    columns.add(new Column("%", true, each -> graded(each, each.percent())));
    if (grades.scale().range()) {
      columns.add(new Column(words.of("class.grade"), true, each -> graded(each, each.grade())));
    }
    columns.add(new Column(words.of("class.seconds"), true, this::time));
    columns.add(new Column(words.of("class.program"), false, this::program));
    return columns;
  }

  /** Adds a column with a text, unless it is empty for all. */
  private void addText(List<Column> columns, String key, Function<GradedHandIn, String> text) {
    if (grades.handIns().stream().anyMatch(each -> !text.apply(each).isEmpty())) {
      columns.add(
          new Column(words.of(key), false, each -> Markup.of("<td>%s</td>", text.apply(each))));
    }
  }

  private static Markup name(GradedHandIn handIn) {
    return Markup.of(
        "<th scope=\"row\"><a href=\"feedback/%s/%s\">%s</a></th>",
        handIn.folder(), ClassReport.FEEDBACK, handIn.name());
  }

  private static Markup number(double value, String mood, Object shown) {
    return Markup.of("<td class=\"number %s\" data-value=\"%s\">%s</td>", mood, value, shown);
  }

  private Markup points(GradedHandIn handIn) {
    String points = words.number(handIn.points());
    Markup of = Markup.of("%s <small>/ %s</small>", points, words.number(handIn.of()));
    return number(handIn.points(), "", of);
  }

  private Markup graded(GradedHandIn handIn, double value) {
    return number(value, handIn.passed() ? "good" : "bad", words.number(value));
  }

  private Markup time(GradedHandIn handIn) {
    return number(words.time(handIn), "", words.of("class.number", words.time(handIn)));
  }

  private Markup points(String name, GradedHandIn handIn) {
    return words.courses(handIn).stream()
        .filter(each -> words.name(each).equals(name))
        .findFirst()
        .map(this::points)
        .orElse(number(-1, "", "–"));
  }

  private Markup points(CourseGrade course) {
    String template =
        switch (course.best().result().verdict()) {
          case "reached" -> "%s <span class=\"good\" title=\"%s\">✓</span>";
          case "failed" -> "%s <span class=\"bad\" title=\"%s\">✕</span>";
          case "missed" -> "%s <span class=\"muted\" title=\"%s\">○</span>";
          default -> "%s <span class=\"bad\" title=\"%s\">–</span>";
        };
    String verdict = words.verdict(course.best());
    return number(course.points(), "", Markup.of(template, words.number(course.points()), verdict));
  }

  /** Returns what kept programs from running, or from ending by themselves. */
  private Markup program(GradedHandIn handIn) {
    Stream<Markup> remarks =
        handIn.flights().stream()
            .filter(each -> !GradeWords.ran(each))
            .map(words::program)
            .distinct()
            .map(each -> Markup.of("<p class=\"bad\">%s</p>", each));
    return Markup.of("<td class=\"program\">%s</td>", Markup.all(remarks));
  }

  // --- the distribution ---

  private Markup distribution() {
    int[] counts = new int[BARS];
    for (GradedHandIn handIn : grades.handIns()) {
      counts[(int) Math.min(BARS - 1, Math.max(0, handIn.percent() * BARS / 100))]++;
    }
    int most = Math.max(1, IntStream.of(counts).max().orElse(1));
    return Markup.of(
        "<svg viewBox=\"0 0 324 124\" role=\"img\" aria-label=\"%s: %s\">"
            + "<path d=\"M8,106.5H308\"/>%s<text x=\"308\" y=\"120\">100</text></svg>",
        words.of("class.distribution"),
        Markup.all(IntStream.range(0, BARS).mapToObj(i -> said(i, counts[i]))),
        Markup.all(IntStream.range(0, BARS).mapToObj(i -> bar(i, counts[i], most))));
  }

  private Markup said(int bar, int count) {
    String range = words.of("class.bar", 100 * bar / BARS, 100 * (bar + 1) / BARS, count);
    return count == 0 ? Markup.NONE : Markup.of("%s;", range);
  }

  private Markup bar(int bar, int count, int most) {
    int height = TALLEST * count / most;
    int x = 8 + 300 * bar / BARS;
    boolean passed = (bar + 1) * 100.0 / BARS > grades.scale().passedFrom();
    return Markup.of(
        "<rect class=\"%s\" x=\"%s\" y=\"%s\" width=\"24\" height=\"%s\"/>"
            + "<text class=\"count\" x=\"%s\" y=\"%s\">%s</text><text x=\"%s\" y=\"120\">%s</text>",
        passed ? "passed" : "below",
        x + 3,
        106 - height,
        height,
        x + 15,
        102 - height,
        count == 0 ? "" : count,
        x,
        100 * bar / BARS);
  }

  // --- the goals ---

  /** The results of a goal in all flights. */
  private record GoalCount(String course, int number, List<GoalResult> results) {

    long reached() {
      return results.stream().filter(each -> each.reached().isPresent()).count();
    }

    double share() {
      return (double) reached() / results.size();
    }
  }

  /** Returns the goals of all courses, beginning with the one that was reached least often. */
  private List<GoalCount> goalCounts() {
    Map<String, GoalCount> counts = new LinkedHashMap<>();
    for (GradedHandIn handIn : grades.handIns()) {
      for (GradedFlight flight : handIn.flights()) {
        List<GoalResult> goals =
            flight.result().commands() > 0 ? flight.result().goals() : List.of();
        for (int i = 0; i < goals.size(); i++) {
          GoalCount none = new GoalCount(flight.course(), i + 1, new ArrayList<>());
          counts.computeIfAbsent(none.course + " " + i, key -> none).results.add(goals.get(i));
        }
      }
    }
    return counts.values().stream().sorted(Comparator.comparingDouble(GoalCount::share)).toList();
  }

  private Markup goal(GoalCount goal) {
    List<String> tasks = goal.results.stream().map(GoalResult::task).distinct().toList();
    return Markup.of(
        "<li><span class=\"muted\">%s %s</span><span>%s</span>"
            + "<svg viewBox=\"0 0 100 8\" preserveAspectRatio=\"none\" aria-hidden=\"true\">"
            + "<rect class=\"ground\" width=\"100\" height=\"8\"/>"
            + "<rect class=\"passed\" width=\"%s\" height=\"8\"/></svg>"
            + "<span class=\"of\">%s</span></li>",
        words.title(goal.course),
        goal.number,
        tasks.size() == 1 ? words.said(tasks.get(0)) : words.of("class.goal-varies"),
        Math.round(100 * goal.share()),
        words.of("class.goal-reached", goal.reached(), goal.results.size()));
  }

  // --- the leaderboard ---

  /** Returns a page with the points of all hand-ins, without names; ties are broken by time. */
  String leaderboard() {
    List<GradedHandIn> ranked =
        grades.handIns().stream()
            .sorted(
                Comparator.comparingDouble((GradedHandIn each) -> -each.points())
                    .thenComparingDouble(words::time))
            .toList();
    Stream<Markup> rows =
        IntStream.range(0, ranked.size())
            .mapToObj(
                i ->
                    Markup.of(
                        "<tr><th scope=\"row\">%s</th>%s%s</tr>",
                        i + 1, points(ranked.get(i)), time(ranked.get(i))));
    return report
        .page("leaderboard.html", words.of("class.leaderboard-title", grades.assignment()), "")
        .code("rows", Markup.all(rows).text())
        .code("distribution", distribution().text())
        .filled();
  }
}
