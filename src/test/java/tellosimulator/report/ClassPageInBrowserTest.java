package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.testing.Chromium;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;
import tellosimulator.words.Translation;

/** Opens the pages of a class as files in a browser. */
@NeedsTool(Tool.CHROMIUM)
class ClassPageInBrowserTest {

  /** Records errors. */
  private static final String PROBE =
      """
      <script>
      const problems = [];
      addEventListener('error', event => problems.push(event.message));
      </script>
      """;

  /** Clicks on all headings, and reports the errors. */
  private static final String REPORT_PROBLEMS =
      """
      <script>
      for (const button of document.querySelectorAll('thead button')) { button.click(); button.click(); }
      document.body.dataset.problems = problems.join() || 'none';
      </script>
      """;

  @TempDir private Path folder;

  @BeforeEach
  void writePages() throws IOException {
    new ClassReport(GradesFixture.in(folder), folder, new ReportTexts(Translation.ENGLISH))
        .write(true);
  }

  /** Copies a page with scripts, which its policy would block. */
  private Path with(Path page, String before, String after) throws IOException {
    String html =
        Files.readString(page)
            .replaceFirst("<meta http-equiv=\"Content-Security-Policy\"[^>]*>", before)
            .replace("</body>", after + "</body>");
    return Files.writeString(page.resolveSibling("copy.html"), html);
  }

  private List<String> namesAfter(String script) throws IOException {
    Path page = with(folder.resolve("index.html"), "", "<script>" + script + "</script>");
    return Pattern.compile("feedback\\.html\">([A-Z][a-z]+)")
        .matcher(Chromium.dom(page, "", folder))
        .results()
        .map(each -> each.group(1))
        .toList();
  }

  @Test
  void headingsSortTheTable() throws IOException {
    String click =
        "[...document.querySelectorAll('thead button')].find(b => b.textContent === '%s').click();";

    assertThat(namesAfter("")).containsExactly("Anna", "Bob", "Eve");
    assertThat(namesAfter(click.formatted("Points"))).containsExactly("Anna", "Bob", "Eve");
    assertThat(namesAfter(click.formatted("Points").repeat(2)))
        .containsExactly("Eve", "Bob", "Anna");
    assertThat(namesAfter(click.formatted("Hand-in").repeat(2)))
        .containsExactly("Eve", "Bob", "Anna");
  }

  @Test
  void itsOwnScriptRunsUnderItsPolicyAndNoOtherDoes() throws IOException {
    String dom = Chromium.dom(folder.resolve("index.html"), "", folder);

    assertThat(dom).contains("Bob &lt;img src=x onerror=alert(1)&gt;").doesNotContain("<img");
    String hostile =
        Files.readString(folder.resolve("index.html"))
            .replace("</body>", "<script>document.title = 'run'</script></body>");
    Path changed = Files.writeString(folder.resolve("changed.html"), hostile);

    assertThat(Chromium.dom(changed, "", folder)).doesNotContain("<title>run</title>");
  }

  @Test
  void pagesRunWithoutErrors() throws IOException {
    Path page = with(folder.resolve("index.html"), PROBE, REPORT_PROBLEMS);

    assertThat(Chromium.dom(page, "", folder)).contains("data-problems=\"none\"");
  }

  /** The pages are shown in a frame, because windows of the browser have a minimum width. */
  @Test
  void pagesFitIntoTheWidthOfATelephone() throws IOException {
    for (String name :
        List.of(
            "index.html",
            "leaderboard.html",
            "feedback/Bob-img-src-x-onerror-alert-/feedback.html")) {
      Path page =
          with(
              folder.resolve(name),
              "",
              "<script>const page = document.documentElement;"
                  + "parent.postMessage(page.scrollWidth - page.clientWidth, '*')</script>");
      Path frame =
          Files.writeString(
              folder.resolve("frame.html"),
              "<body><script>addEventListener('message', event => {"
                  + "document.body.dataset.beyond = event.data; });</script>"
                  + "<iframe width=\"360\" height=\"640\" style=\"border: 0\" src=\""
                  + page.toUri()
                  + "\"></iframe></body>");

      assertThat(Chromium.dom(frame, "", folder)).as(name).contains("data-beyond=\"0\"");
    }
  }
}
