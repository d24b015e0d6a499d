package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.view.world.SceneFixture.HEIGHT;
import static tellosimulator.view.world.SceneFixture.WIDTH;
import static tellosimulator.view.world.SceneFixture.find;

import java.util.function.Supplier;
import javafx.geometry.Point2D;
import javafx.scene.image.Image;
import javafx.scene.paint.Color;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.scenery.overlay.ContactDecal;

/** Checks of goals and contacts that apply to each renderer of the window's scene. */
final class OverlayPictures {

  private OverlayPictures() {}

  static void assertGoalIsABall(SceneFixture fixture, Supplier<Image> picture) {
    fixture.put(new Pose(new Vec3(-1, 0, 1), Attitude.LEVEL), FlightPhase.FLYING);
    fixture.change(() -> fixture.scene().camera().look(RoomView.CHASE));
    Vec3 place = new Vec3(1, -0.4, 1.1);
    Image before = picture.get();
    fixture.ask(new Goal.Reach(Terms.ANY, new GoalRegion(place, 0.3)));
    Image after = picture.get();

    Point2D middle = seen(fixture, place);
    Point2D outside = seen(fixture, place.minus(new Vec3(0, 0.4, 0))); // not on its drop line
    assertThat(blueness(after, middle)).isGreaterThan(blueness(before, middle) + 0.1);
    assertThat(blueness(after, outside)).isCloseTo(blueness(before, outside), within(0.02));
    int shown = find(after, OverlayPictures::isBlue).count();
    assertThat(shown).as("its number and lines").isGreaterThan(100);

    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));
    assertThat(find(picture.get(), OverlayPictures::isBlue).count())
        .as("in the drone's picture")
        .isLessThan(shown / 10);
  }

  static void assertTouchIsRed(SceneFixture fixture, Supplier<Image> picture) {
    fixture.put(new Pose(new Vec3(0, 0, 1), Attitude.LEVEL), FlightPhase.FLYING);
    fixture.mark(new ContactDecal(1, new Vec3(0.4, 0.4, 1), false));
    int touch = find(picture.get(), OverlayPictures::isRed).count();
    fixture.mark(new ContactDecal(1, new Vec3(0.4, 0.4, 1), true));
    int crash = find(picture.get(), OverlayPictures::isRed).count();
    fixture.mark();

    // 0.018 and 0.03 of the distance are 10 and 16 pixels of 360 at 38 degrees
    assertThat(touch).isBetween(15, 90);
    assertThat(crash).isGreaterThan(touch);
    assertThat(find(picture.get(), OverlayPictures::isRed).count()).isZero();
  }

  private static Point2D seen(SceneFixture fixture, Vec3 place) {
    return fixture.scene().camera().viewpoint().project(place, WIDTH, HEIGHT).orElseThrow();
  }

  private static boolean isBlue(Color color) {
    return color.getBlue() > 0.5 && color.getBlue() > 2 * color.getRed();
  }

  private static boolean isRed(Color color) {
    return color.getRed() > 0.6 && color.getGreen() < 0.4 && color.getBlue() < 0.4;
  }

  /** Mean blueness of the pixels around a place of an image. */
  private static double blueness(Image picture, Point2D place) {
    double sum = 0;
    for (int i = -4; i <= 4; i++) {
      Color color =
          picture.getPixelReader().getColor((int) place.getX() + i, (int) place.getY() + 6);
      sum += color.getBlue() - color.getRed();
    }
    return sum / 9;
  }
}
