package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;
import org.junit.jupiter.api.Test;

class LabelSpaceTest {

  private static final Rectangle2D ROOM = new Rectangle2D(0, 0, 400, 400);
  private static final Rectangle2D LABEL = new Rectangle2D(100, 50, 60, 14);

  private final LabelSpace space = new LabelSpace();

  @Test
  void labelsThatWantOnePlaceAreNextToEachOther() {
    assertThat(space.take(LABEL, ROOM)).contains(LABEL);
    // moves are multiples of 4 pixels; those up are tried before those down
    assertThat(space.take(LABEL, ROOM)).contains(new Rectangle2D(100, 34, 60, 14));
    assertThat(space.take(LABEL, ROOM)).contains(new Rectangle2D(100, 66, 60, 14));
  }

  @Test
  void labelsBesideEachOtherStayWhereTheyAre() {
    space.take(LABEL, ROOM);

    for (Rectangle2D beside :
        new Rectangle2D[] {
          new Rectangle2D(160, 50, 60, 14), new Rectangle2D(100, 64, 60, 14),
        }) {
      assertThat(space.take(beside, ROOM)).contains(beside);
    }
  }

  @Test
  void labelsStayInTheRoom() {
    Rectangle2D outside = new Rectangle2D(-30, 395, 60, 14);

    assertThat(space.take(outside, ROOM)).contains(new Rectangle2D(0, 386, 60, 14));
  }

  @Test
  void aLabelCrossesNoRimButFitsIntoALargeCircle() {
    space.blockRim(new Point2D(130, 57), 20);
    assertThat(space.take(LABEL, ROOM)).contains(new Rectangle2D(100, 18, 60, 14));

    space.clear();
    space.blockRim(new Point2D(130, 57), 40);
    assertThat(space.take(LABEL, ROOM)).contains(LABEL);
  }

  @Test
  void aLabelCrossesNoLine() {
    space.blockLine(new Point2D(130, 40), new Point2D(130, 60));

    assertThat(space.take(LABEL, ROOM)).contains(new Rectangle2D(100, 62, 60, 14));
  }

  @Test
  void aLabelWithoutSpaceIsLeftOut() {
    space.block(new Point2D(130, 57), 200);

    assertThat(space.take(LABEL, ROOM)).isEmpty();
  }

  @Test
  void anotherDrawingBeginsWithAnEmptyPlan() {
    space.take(LABEL, ROOM);
    space.clear();

    assertThat(space.take(LABEL, ROOM)).contains(LABEL);
  }
}
