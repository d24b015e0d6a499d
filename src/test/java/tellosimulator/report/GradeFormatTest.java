package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import tellosimulator.grade.Grades;
import tellosimulator.json.Json;
import tellosimulator.words.Translation;

/** Compares files for other systems with what these have published. */
class GradeFormatTest {

  private static final String BOB = "Bob-img-src-x-onerror-alert-";

  @TempDir private Path folder;

  private ClassReport report;

  @BeforeEach
  void grade() throws IOException {
    report =
        new ClassReport(GradesFixture.in(folder), folder, new ReportTexts(Translation.ENGLISH));
    report.write(false);
  }

  // --- JUnit ---

  @Test
  void junitHasASuiteForEachHandInAndATestForEachGoal() throws Exception {
    List<Path> written = report.write(GradeFormat.JUNIT);

    assertThat(written).containsExactly(folder.resolve("junit.xml"));
    Element suites = xml(written.get(0)).getDocumentElement();
    assertThat(suites.getTagName()).isEqualTo("testsuites");
    assertThat(attributes(suites, "name", "tests", "failures", "errors", "skipped"))
        .containsExactly("Gates & <b>rings</b>", "6", "1", "2", "0");
    NodeList each = suites.getElementsByTagName("testsuite");
    assertThat(each.getLength()).isEqualTo(3);
    Element bob = (Element) each.item(1);
    assertThat(attributes(bob, "name", "tests", "failures", "errors"))
        .containsExactly(GradesFixture.HOSTILE, "2", "1", "0");
    Element missed = (Element) bob.getElementsByTagName("testcase").item(1);
    assertThat(attributes(missed, "name", "classname")).containsExactly("goal 2: land", "slalom");
    Element failure = (Element) missed.getElementsByTagName("failure").item(0);
    assertThat(failure.getAttribute("type")).isEqualTo("failed");
    assertThat(failure.getAttribute("message"))
        .contains("crashed into </p><script>x</script>\\x01");
    assertThat(failure.getTextContent()).contains("−10", "drone 1 crashed into <pole> & \"]]>");
  }

  @Test
  void aProgramThatWasNotStartedIsAnErrorInJunit() throws Exception {
    Document all = xml(report.write(GradeFormat.JUNIT).get(0));

    Element error = (Element) all.getElementsByTagName("error").item(0);
    assertThat(error.getAttribute("type")).isEqualTo("no entry file");
  }

  /** Checks the elements and attributes that junit-10.xsd of Jenkins' xUnit plugin allows. */
  @Test
  void junitUsesOnlyKnownElementsAndAttributes() throws Exception {
    Map<String, Set<String>> known =
        Map.of(
            "testsuites", Set.of("name", "tests", "failures", "errors", "skipped"),
            "testsuite", Set.of("name", "tests", "failures", "errors", "skipped"),
            "properties", Set.of(),
            "property", Set.of("name", "value"),
            "testcase", Set.of("name", "classname", "time"),
            "failure", Set.of("message", "type"),
            "error", Set.of("message", "type"));
    NodeList all = xml(report.write(GradeFormat.JUNIT).get(0)).getElementsByTagName("*");

    for (int i = 0; i < all.getLength(); i++) {
      Element element = (Element) all.item(i);
      assertThat(known).containsKey(element.getTagName());
      for (int j = 0; j < element.getAttributes().getLength(); j++) {
        assertThat(known.get(element.getTagName()))
            .contains(element.getAttributes().item(j).getNodeName());
      }
    }
  }

  private static Document xml(Path file) throws Exception {
    DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
    factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
    return factory.newDocumentBuilder().parse(file.toFile());
  }

  private static List<String> attributes(Element element, String... names) {
    List<String> values = new ArrayList<>();
    for (String name : names) {
      values.add(element.getAttribute(name));
    }
    return values;
  }

  // --- JSON ---

  private Map<?, ?> json(GradeFormat format, String file) throws IOException {
    List<Path> written = report.write(format);
    assertThat(written).hasSize(3).contains(folder.resolve(file));
    return (Map<?, ?>) Json.value(Files.readString(folder.resolve(file)));
  }

  /** Source: Gradescope, Autograder Specifications, "Output format". */
  @Test
  void gradescopeHasItsKeysAndTypes() throws IOException {
    Map<?, ?> result = json(GradeFormat.GRADESCOPE, "gradescope/" + BOB + "/results.json");

    assertThat(Set.<Object>copyOf(result.keySet()))
        .isSubsetOf(
            "score",
            "execution_time",
            "output",
            "visibility",
            "stdout_visibility",
            "extra_data",
            "tests",
            "leaderboard");
    assertThat(result.get("score")).isEqualTo(10.0);
    assertThat(result.get("execution_time")).isEqualTo(1.5);
    Map<?, ?> test = (Map<?, ?>) ((List<?>) result.get("tests")).get(0);
    assertThat(Set.<Object>copyOf(test.keySet()))
        .isSubsetOf("score", "max_score", "name", "number", "output", "tags", "visibility");
    assertThat(test.get("score")).isEqualTo(10.0);
    assertThat(test.get("max_score")).isEqualTo(30.0);
    assertThat((String) test.get("output")).contains("exit code 1", "crashed into <pole>");
    assertThat(result.get("leaderboard"))
        .isEqualTo(
            List.of(
                Map.of("name", "Points", "value", 10.0),
                Map.of("name", "Seconds", "value", 12.5, "order", "asc")));
  }

  /** Source: classroom50, schemas/result-v1.schema.json, which allows no other members. */
  @Test
  void classroom50HasItsKeysAndWholeNumbers() throws IOException {
    Map<?, ?> result = json(GradeFormat.CLASSROOM50, "classroom50/Anna/result.json");

    assertThat(Set.<Object>copyOf(result.keySet()))
        .containsExactlyInAnyOrder(
            "schema",
            "classroom",
            "assignment",
            "assignment_type",
            "owner",
            "submission",
            "commit",
            "release",
            "review",
            "datetime",
            "score",
            "max-score",
            "tests");
    assertThat(result.get("schema")).isEqualTo("classroom50/result/v1");
    assertThat((String) result.get("submission")).startsWith("submit/");
    assertThat((String) result.get("datetime"))
        .matches("\\d{4}-\\d{2}-\\d{2}T([01]\\d|2[0-3]):[0-5]\\d:[0-5]\\dZ");
    assertThat(result.get("assignment_type")).isIn("individual", "group");
    assertThat(result.get("score")).isEqualTo(30L);
    assertThat(result.get("max-score")).isEqualTo(30L);
    Map<?, ?> test = (Map<?, ?>) ((List<?>) result.get("tests")).get(0);
    assertThat(test.get("test-name")).isEqualTo("slalom");
    assertThat(test.get("passed")).isEqualTo(true);
    assertThat(test.get("score")).isEqualTo(30L);
    assertThat(test.get("max-score")).isEqualTo(30L);
  }

  /** Source: Autolab, Guide for Lab Authors: the last line of the output. */
  @Test
  void autolabIsOneLineWithScores() throws IOException {
    Map<?, ?> result = json(GradeFormat.AUTOLAB, "autolab/" + BOB + "/scores.json");

    assertThat(result.get("scores")).isEqualTo(Map.of("slalom", 10.0));
    assertThat(result.get("scoreboard")).isEqualTo(List.of(10.0, 12.5));
    assertThat(Files.readAllLines(folder.resolve("autolab/" + BOB + "/scores.json"))).hasSize(1);
  }

  /** Source: CodeRunner, combinator_grader_outcome.php: allowed fields, the table's first row. */
  @Test
  void codeRunnerHasAFractionAndATable() throws IOException {
    Map<?, ?> result = json(GradeFormat.CODERUNNER, "coderunner/" + BOB + "/result.json");

    assertThat(Set.<Object>copyOf(result.keySet()))
        .containsExactlyInAnyOrder("fraction", "prologuehtml", "testresults", "epiloguehtml");
    assertThat(((Number) result.get("fraction")).doubleValue()).isBetween(0.333, 0.334);
    List<?> rows = (List<?>) result.get("testresults");
    List<?> head = (List<?>) rows.get(0);
    List<?> row = (List<?>) rows.get(1);
    assertThat((Object) head.get(0)).isEqualTo("iscorrect");
    assertThat((Object) row.get(0)).isEqualTo(0L);
    assertThat(row).hasSameSizeAs(head);
    assertThat(result.get("prologuehtml")).isEqualTo("<p>10 of 30 points</p>");
  }

  // --- Moodle ---

  @Test
  void moodleHasAWorksheetOfParticipants() throws IOException {
    List<Path> written = report.write(GradeFormat.MOODLE);

    assertThat(Files.readAllLines(written.get(0)))
        .hasSize(3)
        .satisfies(
            lines -> {
              assertThat(lines.get(0))
                  .isEqualTo("Identifier,Full name,Grade,Last modified (grade),Feedback comments");
              assertThat(lines.get(1)).startsWith("Participant 17,Anna,6.0,,");
              assertThat(lines.get(2))
                  .startsWith("Participant 18," + GradesFixture.HOSTILE)
                  .contains("crashed into &lt;pole&gt;")
                  .doesNotContain("<script>");
            });
  }

  @Test
  void moodleFeedbackIsInTheFoldersOfTheHandIns() throws IOException {
    Path zip = report.write(GradeFormat.MOODLE).get(1);

    List<String> names = new ArrayList<>();
    try (InputStream file = Files.newInputStream(zip);
        ZipInputStream in = new ZipInputStream(file, StandardCharsets.UTF_8)) {
      for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
        names.add(entry.getName());
      }
    }
    assertThat(names)
        .containsExactly(
            "Anna_17_assignsubmission_file_/feedback.html",
            "Bob_18_assignsubmission_file/feedback.html",
            "Bob_18_assignsubmission_file/slalom-7-1.html");
  }

  @Test
  void handInsThatAreNotFromMoodleHaveNoWorksheet() throws IOException {
    Grades grades = report.grades();
    Grades others =
        new Grades(
            grades.assignment(), grades.take(), grades.scale(), grades.handIns().subList(2, 3));
    ClassReport other = new ClassReport(others, folder, new ReportTexts(Translation.ENGLISH));

    assertThatThrownBy(() -> other.write(GradeFormat.MOODLE))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("no hand-in is from Moodle");
  }
}
