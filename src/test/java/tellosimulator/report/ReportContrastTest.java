package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Text must be readable for everyone, even in sunlight: WCAG 2.1 requires a contrast of 4.5 to 1.
 */
class ReportContrastTest {

  private static final Pattern COLOR = Pattern.compile("--([a-z]+): #([0-9a-f]{6});");

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          ink, page
          ink, panel
          ink, soft
          ink, chosen
          ink, badback
          muted, page
          muted, panel
          muted, soft
          muted, chosen
          muted, floor
          ink, floor
          accent, panel
          second, panel
          good, soft
          good, panel
          good, chosen
          bad, panel
          bad, badback
          bad, chosen
          warn, warnback
          """)
  void textCanBeReadOnItsGround(String text, String ground) {
    for (boolean dark : new boolean[] {false, true}) {
      Map<String, Integer> colors = colors(dark);
      assertThat(contrast(colors.get(text), colors.get(ground)))
          .as("%s on %s, dark: %s", text, ground, dark)
          .isGreaterThanOrEqualTo(4.5);
    }
  }

  private static Map<String, Integer> colors(boolean dark) {
    String css = HtmlTemplate.resource("report.css");
    int from = dark ? css.indexOf("@media (prefers-color-scheme: dark)") : 0;
    Matcher matcher = COLOR.matcher(css.substring(from, css.indexOf("}", from)));
    Map<String, Integer> colors = new HashMap<>();
    while (matcher.find()) {
      colors.put(matcher.group(1), Integer.parseInt(matcher.group(2), 16));
    }
    assertThat(colors).hasSizeGreaterThan(15);
    return colors;
  }

  /** Source: WCAG 2.1, contrast ratio. */
  private static double contrast(int one, int other) {
    double light = Math.max(luminance(one), luminance(other));
    double dark = Math.min(luminance(one), luminance(other));
    return (light + 0.05) / (dark + 0.05);
  }

  private static double luminance(int rgb) {
    return 0.2126 * linear(rgb >> 16 & 255)
        + 0.7152 * linear(rgb >> 8 & 255)
        + 0.0722 * linear(rgb & 255);
  }

  private static double linear(int channel) {
    double share = channel / 255.0;
    return share <= 0.03928 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
  }
}
