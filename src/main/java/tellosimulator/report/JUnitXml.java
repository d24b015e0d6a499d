package tellosimulator.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import tellosimulator.grade.CourseGrade;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.FlightResult.GoalResult;

/**
 * Grades as JUnit XML: a suite for each hand-in, with a test for each goal of its best flight on
 * each course. Its names are the same for all hand-ins, as Artemis sets the weights of tests by
 * their names. Source: the schema of Jenkins' xUnit plugin, junit-10.xsd.
 */
final class JUnitXml {

  private static final String FAILURE = "failure";
  private static final String ERROR = "error";

  private JUnitXml() {}

  /**
   * A test.
   *
   * @param outcome empty, {@link #FAILURE}, or {@link #ERROR} if the program was not started
   */
  private record Case(String outcome, Markup markup) {}

  private record Suite(GradedHandIn handIn, List<Case> cases) {}

  static List<Path> write(ClassReport report) throws IOException {
    List<Suite> suites =
        report.grades().handIns().stream()
            .map(each -> new Suite(each, cases(each, report.words())))
            .toList();
    Markup all =
        Markup.of(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"%s\"%s>\n%s\n</testsuites>\n",
            report.grades().assignment(),
            counts(suites.stream().flatMap(each -> each.cases.stream()).toList()),
            Markup.all(suites.stream().map(JUnitXml::suite)));
    Path file = report.folder().resolve("junit.xml");
    // not allowed. Source: XML 1.0, section 2.2; control characters are escaped by the markup
    ClassReport.write(file, all.text().replaceAll("[\uFFFE\uFFFF]", "\uFFFD"));
    return List.of(file);
  }

  private static Markup suite(Suite suite) {
    return Markup.of(
        """
          <testsuite name="%s"%s>
            <properties>
              <property name="points" value="%s"/>
              <property name="of" value="%s"/>
              <property name="grade" value="%s"/>
            </properties>
        %s
          </testsuite>""",
        suite.handIn.name(),
        counts(suite.cases),
        suite.handIn.points(),
        suite.handIn.of(),
        suite.handIn.grade(),
        Markup.all(suite.cases.stream().map(Case::markup)));
  }

  private static Markup counts(List<Case> cases) {
    return Markup.of(
        " tests=\"%s\" failures=\"%s\" errors=\"%s\" skipped=\"0\"",
        cases.size(),
        cases.stream().filter(each -> each.outcome.equals(FAILURE)).count(),
        cases.stream().filter(each -> each.outcome.equals(ERROR)).count());
  }

  private static List<Case> cases(GradedHandIn handIn, GradeWords words) {
    return words.courses(handIn).stream()
        .flatMap(
            course ->
                IntStream.range(0, course.best().result().goals().size())
                    .mapToObj(i -> test(course, i, words)))
        .toList();
  }

  private static Case test(CourseGrade course, int index, GradeWords words) {
    FlightResult result = course.best().result();
    GoalResult goal = result.goals().get(index);
    Markup test =
        Markup.of(
            "    <testcase name=\"goal %s: %s\" classname=\"%s\" time=\"%s\"",
            index + 1, goal.task(), words.name(course), goal.reached().orElse(result.seconds()));
    if (goal.reached().isPresent()) {
      return new Case("", Markup.of("%s/>", test));
    }
    boolean flown = !result.verdict().equals(FlightResult.NOT_FLOWN);
    String outcome = flown ? FAILURE : ERROR;
    Markup markup =
        Markup.of(
            "%s>\n      <%s message=\"%s\" type=\"%s\">%s</%s>\n    </testcase>",
            test,
            outcome,
            words.verdict(course.best()),
            flown ? result.verdict() : course.best().program(),
            words.reasons(course),
            outcome);
    return new Case(outcome, markup);
  }
}
