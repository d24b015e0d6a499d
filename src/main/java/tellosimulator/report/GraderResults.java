package tellosimulator.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import tellosimulator.grade.CourseGrade;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.json.Json;

/** The JSON files that graders of single hand-ins write, each in a folder of the hand-in. */
record GraderResults(ClassReport report, GradeWords words, GradedHandIn handIn) {

  /**
   * The time of a result for Classroom 50, which replaces it by that of the commit. Documented:
   * classroom50, result-v1.schema.json.
   */
  private static final String REPLACED_TIME = "1970-01-01T00:00:00Z";

  /**
   * Writes a file for each hand-in.
   *
   * @param folder the folder of the format, in that of the results
   */
  static List<Path> write(
      ClassReport report, String folder, String file, Function<GraderResults, String> form)
      throws IOException {
    List<Path> written = new ArrayList<>();
    for (GradedHandIn handIn : report.grades().handIns()) {
      Path to = report.folder().resolve(folder).resolve(handIn.folder()).resolve(file);
      ClassReport.write(to, form.apply(new GraderResults(report, report.words(), handIn)) + "\n");
      written.add(to);
    }
    return written;
  }

  private static boolean reached(CourseGrade course) {
    return course.best().result().verdict().equals("reached");
  }

  /** Source: Gradescope, Autograder Specifications. */
  String gradescope() {
    List<Object> tests = new ArrayList<>();
    for (CourseGrade course : words.courses(handIn)) {
      tests.add(
          Json.object(
              "score", course.points(),
              "max_score", course.of(),
              "name", words.name(course),
              "output", words.reasons(course)));
    }
    double wall = handIn.flights().stream().mapToDouble(GradedFlight::wallSeconds).sum();
    Object time =
        Json.object("name", words.of("class.seconds"), "value", words.time(handIn), "order", "asc");
    return Json.lines(
        Json.object(
            "score", handIn.points(),
            "execution_time", wall,
            "output", words.points(handIn.points(), handIn.of()),
            "tests", tests,
            "leaderboard",
                List.of(
                    Json.object("name", words.of("class.points"), "value", handIn.points()),
                    time)));
  }

  /** Source: Classroom 50, result-v1.schema.json and the page Advanced Autograding. */
  String classroom50() {
    List<Map<String, Object>> tests = new ArrayList<>();
    for (CourseGrade course : words.courses(handIn)) {
      int most = (int) Math.max(0, Math.round(course.of()));
      tests.add(
          Json.object(
              "test-name", words.name(course),
              "passed", reached(course),
              "score", (int) Math.min(most, Math.max(0, Math.round(course.points()))),
              "max-score", most,
              "output", words.reasons(course)));
    }
    String commit = given("unknown", "COMMIT_URL");
    return Json.lines(
        Json.object(
            "schema", "classroom50/result/v1",
            "classroom", given("unknown", "CLASSROOM"),
            "assignment", given(report.grades().assignment(), "ASSIGNMENT"),
            "assignment_type", given("individual", "ASSIGNMENT_TYPE"),
            "owner", given(handIn.name(), "OWNER", "USERNAME"),
            "submission", given("submit/" + handIn.folder(), "SUBMISSION_TAG"),
            "commit", commit,
            "release", given("unknown", "RELEASE_URL"),
            "review", given(commit, "REVIEW_URL"),
            "datetime", REPLACED_TIME,
            "score", sum(tests, "score"),
            "max-score", sum(tests, "max-score"),
            "tests", tests));
  }

  private static int sum(List<Map<String, Object>> tests, String member) {
    return tests.stream().mapToInt(each -> (Integer) each.get(member)).sum();
  }

  /** Returns the first of several variables of the environment that is set. */
  private static String given(String otherwise, String... names) {
    return Stream.of(names)
        .flatMap(name -> Optional.ofNullable(System.getenv(name)).stream())
        .filter(value -> !value.isEmpty())
        .findFirst()
        .orElse(otherwise);
  }

  /** The only line is what the grader must print last. Source: Autolab, Guide for Lab Authors. */
  String autolab() {
    Map<String, Object> scores = new LinkedHashMap<>();
    words
        .courses(handIn)
        .forEach(each -> scores.put(words.name(each), Json.rounded(each.points())));
    List<Object> scoreboard =
        List.of(Json.rounded(handIn.points()), Json.rounded(words.time(handIn)));
    return Json.text(Json.object("scores", scores, "scoreboard", scoreboard));
  }

  /** Source: CodeRunner, "Combinator-template grading", and combinator_grader_outcome.php. */
  String codeRunner() {
    List<Object> rows = new ArrayList<>();
    String points = words.of("class.points");
    rows.add(List.of("iscorrect", words.of("grade.column"), points, words.of("feedback.points")));
    for (CourseGrade course : words.courses(handIn)) {
      String all = words.points(course.points(), course.of());
      rows.add(List.of(reached(course) ? 1 : 0, words.name(course), all, words.reasons(course)));
    }
    String grade = words.of("grade.grade", words.number(handIn.grade()));
    return Json.lines(
        Json.object(
            "fraction", Math.max(0, Math.min(1, handIn.percent() / 100)),
            "prologuehtml",
                Markup.of("<p>%s</p>", words.points(handIn.points(), handIn.of())).text(),
            "testresults", rows,
            "epiloguehtml", Markup.of("<p>%s</p>", grade).text()));
  }
}
