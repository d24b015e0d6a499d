package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.world.Walls;

class FinishTest {

  @ParameterizedTest
  @CsvSource({"AUTO, CALM, TEXTURED", "TEXTURED, TEXTURED, TEXTURED", "PLAIN, PLAIN, PLAIN"})
  void onlyRoomsForWhichNothingWasChosenLookDifferentToPeople(
      Walls walls, Finish forPeople, Finish forFilm) {
    assertThat(Finish.forPeople(walls)).isEqualTo(forPeople);
    assertThat(Finish.forFilm(walls)).isEqualTo(forFilm);
  }
}
