package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import javafx.geometry.Dimension2D;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.orbit.Orbit;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.scenery.orbit.ViewWindow;

class ViewWindowTest {

  private static final double FIELD_OF_VIEW = Math.toRadians(38);
  private static final Dimension2D SIZE = new Dimension2D(1000, 600);

  private static ViewWindow window(Rectangle2D part) {
    return ViewWindow.of(
        SIZE.getHeight() / 2 / Math.tan(FIELD_OF_VIEW / 2),
        SIZE.getWidth() / 2 - part.getMinX(),
        SIZE.getWidth() / 2 - part.getMaxX(),
        SIZE.getHeight() / 2 - part.getMinY(),
        SIZE.getHeight() / 2 - part.getMaxY());
  }

  @Test
  void straightAheadTheDistanceIsThatOfTheFieldOfView() {
    ViewWindow all = window(new Rectangle2D(0, 0, 1000, 600));
    List<Vec3> square =
        List.of(new Vec3(0, 1, 1), new Vec3(0, -1, 1), new Vec3(0, 1, -1), new Vec3(0, -1, -1));

    Vec3 place = all.nearest(square, Attitude.LEVEL);

    // half the height is 1 m at half the field of view: 1 / tan 19° = 2.904 m
    assertThat(place.distanceTo(new Vec3(-2.9042109, 0, 0))).isLessThan(1e-6);
  }

  /** So that walls fit above a floor, without empty space below it. */
  @ParameterizedTest
  @CsvSource({"0, 1", "0, 0.5", "45, 1", "90, 0.5"})
  void theMoreLevelOneLooksTheLowerAreFlatThings(double elevationDeg, double halfWidth) {
    ViewWindow all = window(new Rectangle2D(0, 0, 1000, 600));
    Attitude attitude = new Orbit(0, Math.toRadians(elevationDeg), 1, Vec3.ZERO).attitude();
    Vec3 right = new Vec3(0, -halfWidth, 0);
    List<Vec3> line = List.of(right, right.times(-1));

    Vec3 place = all.nearest(line, attitude);

    Viewpoint viewpoint = new Viewpoint(new Pose(place, attitude), FIELD_OF_VIEW, true, 0.01, 1000);
    double down = viewpoint.project(right.times(0.99), 1000, 600).orElseThrow().getY();
    assertThat(down)
        .isCloseTo(
            300 + 300 * StrictMath.pow(Math.cos(Math.toRadians(elevationDeg)), 2), within(3.0));
  }

  @ParameterizedTest
  @EnumSource(RoomView.class)
  void inEachDirectionAllPointsAreSeenAndTouchTwoEdges(RoomView view) {
    assertTight(view, box(5, 5, 1), new Rectangle2D(20, 30, 960, 540));
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1, 0.5, 20, 20, 960, 560",
    "200, 200, 3, 20, 20, 960, 560",
    "3, 30, 3, 340, 20, 640, 500",
    "30, 3, 3, 20, 350, 960, 160",
    "5, 5, 3, 700, 20, 200, 500"
  })
  void whateverTheSizeAndThePartOfThePicture(
      double depth, double width, double height, double x, double y, double partX, double partY) {
    assertTight(RoomView.START, box(depth, width, height), new Rectangle2D(x, y, partX, partY));
  }

  private static void assertTight(RoomView view, List<Vec3> points, Rectangle2D part) {
    Attitude attitude = new Orbit(view.heading(), view.elevation(), 1, Vec3.ZERO).attitude();
    ViewWindow window = window(part);

    Vec3 place = window.nearest(points, attitude);

    Viewpoint viewpoint = new Viewpoint(new Pose(place, attitude), FIELD_OF_VIEW, true, 0.01, 1000);
    List<Point2D> seen =
        points.stream().flatMap(point -> viewpoint.project(point, 1000, 600).stream()).toList();
    assertThat(seen).hasSameSizeAs(points);
    double left = seen.stream().mapToDouble(Point2D::getX).min().orElseThrow();
    double right = seen.stream().mapToDouble(Point2D::getX).max().orElseThrow();
    double top = seen.stream().mapToDouble(Point2D::getY).min().orElseThrow();
    double bottom = seen.stream().mapToDouble(Point2D::getY).max().orElseThrow();
    assertThat(left).isGreaterThanOrEqualTo(part.getMinX() - 1e-6);
    assertThat(right).isLessThanOrEqualTo(part.getMaxX() + 1e-6);
    assertThat(top).isGreaterThanOrEqualTo(part.getMinY() - 1e-6);
    assertThat(bottom).isLessThanOrEqualTo(part.getMaxY() + 1e-6);
    double filled = Math.max((right - left) / part.getWidth(), (bottom - top) / part.getHeight());
    assertThat(filled).as("part of one direction").isCloseTo(1, within(1e-6));
  }

  private static List<Vec3> box(double depth, double width, double height) {
    List<Vec3> corners = new ArrayList<>();
    for (double x : new double[] {-depth / 2, depth / 2}) {
      for (double y : new double[] {-width / 2, width / 2}) {
        for (double z : new double[] {0, height}) {
          corners.add(new Vec3(x, y, z));
        }
      }
    }
    return corners;
  }
}
