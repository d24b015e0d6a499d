package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/**
 * The same seed and the same commands result in the same video, byte for byte, on each machine and
 * JDK: simulation, camera and encoder use no function of {@code Math} whose last bits may differ.
 */
class FilmDeterminismTest {

  /** SHA-256 of the stream, to be updated when camera, room or encoder change on purpose. */
  private static final String EXPECTED =
      "2ec3bf2ede2b51be4b458db706ff9ab8430817fc2b15a4a59d185222f104326b";

  @Test
  void aFlightGivesTheSameBytesEverywhere() throws Exception {
    assertThat(GoldenFilm.hash(GoldenFilm.FLIGHT)).isEqualTo(EXPECTED);
  }

  @Test
  void anotherFlightGivesOthers() throws Exception {
    assertThat(GoldenFilm.hash("rc 20 30 10 41", "rc 0 -40 0 -90", "flip l", "land"))
        .isNotEqualTo(EXPECTED);
  }
}
