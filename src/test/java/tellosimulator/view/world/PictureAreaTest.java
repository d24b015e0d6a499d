package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.world.PictureArea.MARGIN;

import java.util.List;
import javafx.geometry.Dimension2D;
import javafx.geometry.Insets;
import javafx.geometry.Rectangle2D;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

class PictureAreaTest {

  private static final Dimension2D SIZE = new Dimension2D(1000, 600);

  private static final Rectangle2D ALL =
      new Rectangle2D(MARGIN, MARGIN, 1000 - 2 * MARGIN, 600 - 2 * MARGIN);

  @Test
  void withoutCoversAllButAMarginIsFree() {
    assertThat(area().free()).containsExactly(ALL);
  }

  @Test
  void besideACoverInTheCornerThereAreTwoParts() {
    List<Rectangle2D> free = area(new Rectangle2D(0, 0, 300, 200)).free();

    double x = 300 + MARGIN;
    double y = 200 + MARGIN;
    assertThat(free)
        .containsExactlyInAnyOrder(
            new Rectangle2D(x, MARGIN, 1000 - MARGIN - x, ALL.getHeight()),
            new Rectangle2D(MARGIN, y, ALL.getWidth(), 600 - MARGIN - y));
  }

  @Test
  void noPartMeetsACover() {
    List<Rectangle2D> covers =
        List.of(
            new Rectangle2D(10, 10, 300, 280),
            new Rectangle2D(250, 540, 500, 50),
            new Rectangle2D(740, 10, 250, 190));

    List<Rectangle2D> free = new PictureArea(SIZE, Insets.EMPTY, covers).free();

    assertThat(free).isNotEmpty();
    for (Rectangle2D part : free) {
      assertThat(covers).noneMatch(part::intersects);
      assertThat(ALL.contains(part)).isTrue();
    }
  }

  @Test
  void ifNothingIsFreeAllIs() {
    assertThat(area(new Rectangle2D(20, 20, 960, 560)).free()).containsExactly(ALL);
  }

  @Test
  void aPlaceUnderACoverIsNotShown() {
    Viewpoint ahead =
        new Viewpoint(new Pose(Vec3.ZERO, Attitude.LEVEL), Math.toRadians(38), true, 0.1, 100);
    Vec3 middle = new Vec3(5, 0, 0);

    assertThat(area().shows(middle, ahead)).isTrue();
    assertThat(area(new Rectangle2D(480, 280, 40, 40)).shows(middle, ahead)).isFalse();
    assertThat(area().shows(new Vec3(-5, 0, 0), ahead)).as("behind").isFalse();
    assertThat(area().shows(new Vec3(5, 9, 0), ahead)).as("aside").isFalse();
  }

  @Test
  void whatIsCoveredAlongAnEdgeIsNeverFree() {
    PictureArea area = new PictureArea(SIZE, new Insets(50, 200, 100, 0), List.of());
    Rectangle2D open = new Rectangle2D(MARGIN, 50 + MARGIN, 800 - 2 * MARGIN, 450 - 2 * MARGIN);

    assertThat(area.free()).containsExactly(open);
    Rectangle2D part = new Rectangle2D(300, 300, 100, 100);
    assertThat(area.between(part, 1)).isEqualTo(open);
    assertThat(area.downwards(part))
        .isEqualTo(new Rectangle2D(300, 300, 100, open.getMaxY() - 300));
  }

  private static PictureArea area(Rectangle2D... covers) {
    return new PictureArea(SIZE, Insets.EMPTY, List.of(covers));
  }
}
