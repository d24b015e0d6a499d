package tellosimulator.words;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SpellingTest {

  private static final List<String> KNOWN =
      List.of("takeoff", "land", "forward", "time-factor", "up", "left", "lift");

  @ParameterizedTest
  @CsvSource({
    "takeof, takeoff",
    "take off, takeoff", // the blank counts as a hyphen, which is one letter too many
    "TAKEOFF, takeoff",
    "foward, forward",
    "fowrard, forward", // two transposed letters are one slip
    "time_factor, time-factor",
    "lnad, land",
    "pu, up", // of two letters one may be wrong
    "u, up",
    "x, ",
    "sideways, ",
    "'', "
  })
  void theNearestWordIsMeantIfItIsNear(String written, String meant) {
    assertThat(Spelling.meant(written, KNOWN)).isEqualTo(Optional.ofNullable(meant));
  }

  @Test
  void ofTwoThatAreEquallyNearTheFirstIsMeant() {
    assertThat(Spelling.meant("leift", List.of("left", "lift"))).contains("left");
    assertThat(Spelling.meant("leift", List.of("lift", "left"))).contains("lift");
  }

  @Test
  void longTextsAreNotGuessedAt() {
    String longest = "a".repeat(40);

    assertThat(Spelling.meant(longest, List.of(longest))).contains(longest);
    assertThat(Spelling.meant(longest + "a", List.of(longest, longest + "a"))).isEmpty();
  }
}
