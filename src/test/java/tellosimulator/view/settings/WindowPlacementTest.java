package tellosimulator.view.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javafx.geometry.Rectangle2D;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WindowPlacementTest {

  private static final Rectangle2D LAPTOP = new Rectangle2D(0, 0, 1280, 800);
  private static final Rectangle2D BESIDE = new Rectangle2D(1280, -200, 1920, 1080);

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # x,  y,    on the laptop, with a second monitor
          0,    0,    true,  true
          600,  300,  true,  true
          -50,  10,   true,  true
          -200, 10,   false, false
          1250, 10,   false, true
          1400, -150, false, true
          10,   -150, false, false
          10,   790,  false, false
          5000, 10,   false, false
          NaN,  NaN,  false, false
          """)
  void aWindowThatOneCannotTakeHoldOfIsCentered(double x, double y, boolean alone, boolean two) {
    assertThat(WindowPlacement.visible(x, y, List.of(LAPTOP)).isPresent()).isEqualTo(alone);
    assertThat(WindowPlacement.visible(x, y, List.of(LAPTOP, BESIDE)).isPresent()).isEqualTo(two);
  }
}
