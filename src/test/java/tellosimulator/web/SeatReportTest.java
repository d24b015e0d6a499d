package tellosimulator.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import tellosimulator.video.picture.JpegEncoder;
import tellosimulator.video.picture.Picture;

final class SeatReportTest {

  private static byte[] body(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static SeatReport report(String json) {
    return SeatReport.of(body(json));
  }

  private static SeatReport result(int points, int reached, double clock) {
    return report(
        String.format(
            java.util.Locale.ROOT,
            "{\"name\": \"Ada\", \"points\": %d, \"reached\": %d, \"clock\": %s}",
            points,
            reached,
            clock));
  }

  @Test
  void aLineIsFollowedByThePicture() {
    byte[] jpeg = JpegEncoder.encode(new Picture(160, 90), 0.8f);
    byte[] line = body("{\"name\": \"Ada\", \"clock\": 3.5}\n");
    byte[] body = Arrays.copyOf(line, line.length + jpeg.length);
    System.arraycopy(jpeg, 0, body, line.length, jpeg.length);

    assertThat(SeatReport.of(body).members())
        .containsEntry("name", "Ada")
        .containsEntry("clock", 3.5);
    assertThat(SeatReport.picture(body)).isEqualTo(jpeg);
  }

  @Test
  void aPictureThatIsLargeOrNoneIsRefused() {
    byte[] large = JpegEncoder.encode(new Picture(1280, 720), 0.1f);
    byte[] body = Arrays.copyOf(body("\n"), 1 + large.length);
    System.arraycopy(large, 0, body, 1, large.length);

    assertThatThrownBy(() -> SeatReport.picture(body))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("the picture is not a small JPEG file");
    assertThatThrownBy(() -> SeatReport.picture(body("\n\u00ff")))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> SeatReport.picture(body("\n<script>")))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void thereMayBeNoPicture() {
    assertThat(SeatReport.picture(body("{}"))).isEmpty();
    assertThat(SeatReport.picture(body("{}\n"))).isEmpty();
  }

  @Test
  void membersOfAnotherTypeAreIgnored() {
    SeatReport report =
        report("{\"name\": 7, \"goals\": \"<script>\", \"failed\": null, \"more\": \"x\"}");

    assertThat(report).isEqualTo(SeatReport.NONE);
  }

  @Test
  void textsAreShortAndPrintable() {
    SeatReport report =
        report("{\"name\": \"a\\u0007b\\nc\", \"failed\": \"" + "x".repeat(999) + "\"}");

    assertThat(report.members().get("name")).isEqualTo("a b c");
    assertThat(report.members().get("failed")).isEqualTo("x".repeat(120));
  }

  @Test
  void whatIsNoObjectIsRefused() {
    assertThatThrownBy(() -> report("[1]")).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> report("{\"name\": {\"a\": 1}}"))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> report("")).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void pointsCountBeforeGoalsAndGoalsBeforeTime() {
    assertThat(SeatReport.BEST_FIRST.compare(result(9, 1, 50), result(8, 4, 1))).isNegative();
    assertThat(SeatReport.BEST_FIRST.compare(result(8, 2, 50), result(8, 1, 1))).isNegative();
    assertThat(SeatReport.BEST_FIRST.compare(result(8, 2, 3), result(8, 2, 4))).isNegative();
  }

  @Test
  void theBestResultStaysUntilTheCourseChanges() {
    SeatReport good = result(8, 2, 30);
    SeatReport worse = result(0, 0, 0);
    SeatReport elsewhere = report("{\"course\": 2}");

    assertThat(SeatReport.better(good, worse)).isEqualTo(good);
    assertThat(SeatReport.better(worse, good)).isEqualTo(good);
    assertThat(SeatReport.better(good, elsewhere)).isEqualTo(elsewhere);
  }

  @Test
  void aNewNameIsUsedAtOnce() {
    SeatReport renamed = report("{\"name\": \"Bob\", \"team\": \"Red\"}");

    assertThat(SeatReport.better(result(8, 2, 30), renamed).members())
        .containsEntry("name", "Bob")
        .containsEntry("team", "Red")
        .containsEntry("points", 8.0);
  }
}
