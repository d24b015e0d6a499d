package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SystemBrowserTest {

  @ParameterizedTest
  @CsvSource({"Linux,xdg-open", "Mac OS X,open", "Windows 11,rundll32", "FreeBSD,xdg-open"})
  void eachSystemHasItsWayToOpenAFile(String system, String program) {
    assertThat(SystemBrowser.command(system, Path.of("report.html")).get(0)).isEqualTo(program);
  }

  @Test
  void aFileIsNamedByAnAddressInWhichNothingMeansSomethingToAShell() {
    String address = SystemBrowser.command("Linux", Path.of("/a b/\u00e4&c/report.html")).get(1);

    assertThat(address).startsWith("file:///").endsWith("/report.html").doesNotContain(" ");
  }
}
