package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.geometry.Rectangle2D;
import org.junit.jupiter.api.Test;

class LabelSpaceTest {

  private static final Rectangle2D LABEL = new Rectangle2D(100, 50, 60, 14);

  private final LabelSpace space = new LabelSpace();

  @Test
  void labelsAtOnePlaceAreBelowEachOther() {
    assertThat(space.take(LABEL)).isZero();
    assertThat(space.take(LABEL)).isEqualTo(14);
    assertThat(space.take(LABEL)).isEqualTo(28);
  }

  @Test
  void labelsBesideEachOtherStayWhereTheyAre() {
    space.take(LABEL);

    assertThat(space.take(new Rectangle2D(160, 50, 60, 14))).isZero();
    assertThat(space.take(new Rectangle2D(100, 64, 60, 14))).isZero();
  }

  @Test
  void anotherDrawingBeginsWithAnEmptyPlan() {
    space.take(LABEL);
    space.clear();

    assertThat(space.take(LABEL)).isZero();
  }
}
