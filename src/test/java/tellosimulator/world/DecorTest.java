package tellosimulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DecorTest {

  @ParameterizedTest
  @ValueSource(doubles = {0.099, 2.001, Double.NaN})
  void aGridBeyondItsLimitsIsRefused(double grid) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Decor.DEFAULT.withGrid(grid))
        .withMessage("grid is " + grid + " m, but must be from 0.1 to 2.0");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.009, 200.1, Double.NaN})
  void aPosterOfNoWidthIsRefused(double width) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Poster(Surface.FRONT_WALL, 0, 1, width, "a.png"))
        .withMessage("poster is " + width + " m wide, but must be from 0.01 to 200.0");
  }

  @ParameterizedTest
  @CsvSource({
    "cat.png, cat",
    "/home/me/cat.of.mine.jpeg, cat.of.mine",
    "C:\\pictures\\cat.png, cat",
    "cat, cat",
    ".png, .png"
  })
  void aPosterIsCalledAfterItsFileUnlessItHasAName(String file, String name) {
    assertThat(new Poster(Surface.FLOOR, 0, 0, 1, file).name()).isEqualTo(name);
    assertThat(new Poster(Surface.FLOOR, 0, 0, 1, file, Optional.of("dog")).name())
        .isEqualTo("dog");
  }

  @Test
  void itDoesNotChangeWhenTheListDoes() {
    List<Poster> posters = new ArrayList<>();
    Decor decor = Decor.DEFAULT.withPosters(posters);

    posters.add(new Poster(Surface.FLOOR, 0, 0, 1, "a.png"));

    assertThat(decor.posters()).isEmpty();
  }
}
