package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.Grades;
import tellosimulator.translation.PhraseCatalog;
import tellosimulator.words.Translation;

class ClassReportTest {

  @TempDir private Path folder;

  private Grades grades;

  @BeforeEach
  void writePages() throws IOException {
    grades = GradesFixture.in(folder);
    write(Translation.ENGLISH);
  }

  private void write(Translation translation) throws IOException {
    new ClassReport(grades, folder, new ReportTexts(translation)).write(true);
  }

  private String page(String name) {
    try {
      return Files.readString(folder.resolve(name));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private List<Path> pages() throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(each -> each.toString().endsWith(".html")).toList();
    }
  }

  @Test
  void theClassPageHasARowForEachHandIn() {
    assertThat(page("index.html"))
        .contains("<title>Gates &amp; &lt;b&gt;rings&lt;/b&gt; – class page</title>")
        .contains("Hand-ins: 3", "1 of 3 passed", "mean 44 %") // (100 + 33.33 + 0) / 3
        .contains("30 <small>/ 30</small>", "10 <small>/ 30</small>", "0 <small>/ 30</small>")
        .contains("No file to start was found");
  }

  @Test
  void aPartOfAClassIsShownAsSuchWithTheTitlesOfItsCourses() throws IOException {
    grades =
        new Grades(
            grades.assignment(),
            grades.take(),
            grades.scale(),
            5,
            Map.of("slalom", "The <i>slalom</i>"),
            grades.handIns());
    write(Translation.ENGLISH);

    assertThat(page("index.html"))
        .contains("not complete: 3 of 5 hand-ins", "The &lt;i&gt;slalom&lt;/i&gt;")
        .doesNotContain("slalom 1");
  }

  @Test
  void itSaysWhichGoalWasMissedMostOften() {
    String html = page("index.html");

    // both flights reached the first goal, one the second; Eve's program never flew
    assertThat(html).contains("1 of 2", "2 of 2");
    assertThat(html.indexOf("slalom 2")).isPositive().isLessThan(html.indexOf("slalom 1"));
  }

  @Test
  void allLinksLeadToFiles() throws IOException {
    for (Path page : pages()) {
      List<String> links =
          Pattern.compile("href=\"([^\"]+)\"")
              .matcher(Files.readString(page))
              .results()
              .map(each -> each.group(1))
              .filter(each -> !each.startsWith("data:") && !each.startsWith("#"))
              .toList();

      assertThat(links).allSatisfy(link -> assertThat(page.resolveSibling(link)).exists());
    }
    assertThat(folder.resolve("feedback/Anna/feedback.html")).exists();
  }

  @Test
  void theFeedbackGivesReasonsAndTheEndOfTheOutput() {
    assertThat(page("feedback/Bob-img-src-x-onerror-alert-/feedback.html"))
        .contains("10 of 30 points", "not passed", "exit code 1")
        .contains("−10</th><td>drone 1 crashed into &lt;pole&gt; &amp;")
        .contains("href=\"slalom-7-1.html\"")
        .contains("<pre tabindex=\"0\">…\nTraceback\n\\x1b[31m&lt;/script&gt;");
  }

  @Test
  void nothingFromOutsideIsMarkupAndThePoliciesForbidOtherCode() throws IOException {
    for (Path page : pages()) {
      assertThat(Files.readString(page))
          .doesNotContain("<img src=x", "<script>x", "<b>rings", "unsafe", "\u0001", "\u001b")
          .contains("default-src &#39;none&#39;");
    }
    assertThat(page("feedback/Anna/feedback.html")).contains("script-src &#39;none&#39;");
  }

  @Test
  void theLeaderboardHasNoNames() {
    assertThat(page("leaderboard.html"))
        .contains("30 <small>/ 30</small>", "10 <small>/ 30</small>")
        .doesNotContain("Anna", "Bob", "Eve");
  }

  @Test
  void withoutALeaderboardTheOldOneIsDeleted() throws IOException {
    new ClassReport(grades, folder, new ReportTexts(Translation.ENGLISH)).write(false);

    assertThat(folder.resolve("leaderboard.html")).doesNotExist();
    assertThat(page("index.html")).doesNotContain("leaderboard.html");
  }

  @Test
  void theSameGradesGiveTheSameBytes() throws IOException {
    String before = page("index.html");
    write(Translation.ENGLISH);

    assertThat(page("index.html")).isEqualTo(before);
  }

  @Test
  void pagesAreInGerman() throws IOException {
    write(PhraseCatalog.of(Locale.GERMAN));

    assertThat(page("index.html")).contains("lang=\"de\"", "1 von 3 bestanden", "Sekunden");
    assertThat(page("feedback/Anna/feedback.html")).contains("Alle Ziele wurden erreicht");
  }

  @Test
  void aFlightThatCannotBeReadHasNoReport() throws IOException {
    GradedFlight flight = grades.handIns().get(1).flights().get(0);
    Files.delete(folder.resolve(flight.recording()).resolve("run.json"));
    write(Translation.ENGLISH);

    assertThat(page("feedback/Bob-img-src-x-onerror-alert-/feedback.html"))
        .contains("There is no report")
        .doesNotContain("slalom-7-1.html");
  }
}
