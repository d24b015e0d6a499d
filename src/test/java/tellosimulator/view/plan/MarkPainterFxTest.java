package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;

import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.TimeoutException;
import javafx.scene.canvas.Canvas;
import javafx.scene.image.Image;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.testfx.api.FxToolkit;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.overlay.ContactMark;
import tellosimulator.scenery.overlay.MarkColors;
import tellosimulator.view.fx.FxTextures;
import tellosimulator.world.Shape;

/** What goals and contacts look like on a plan of 4 m, 100 pixels for a metre. */
class MarkPainterFxTest {

  private static final PlanViewport SCALE = new PlanViewport(Vec3.ZERO, 100, 400, 400);
  private static final Color ORANGE = Color.web("#e69f00");
  private static final GoalMark.Ball BALL = new GoalMark.Ball(new Vec3(1, 0, 1), 0.4);

  @BeforeEach
  void startToolkit() throws TimeoutException {
    FxToolkit.registerPrimaryStage();
  }

  @Test
  void theRimOfABallHasTheColorOfItsState() {
    for (GoalState state : GoalState.values()) {
      Image picture = picture(List.of(mark(state, BALL)), List.of());

      // 1 m ahead is 100 pixels up; the rim is 40 pixels below that
      Color rim = picture.getPixelReader().getColor(200, 140);
      assertThat(near(rim, MarkColors.of(state), state == GoalState.LATER ? 0.4 : 0.15))
          .as("%s: %s", state, rim)
          .isTrue();
    }
  }

  @Test
  void theGoalOfADroneHasItsColor() {
    GoalMark own = new GoalMark(1, OptionalInt.of(2), GoalState.ACTIVE, BALL);

    Color rim = picture(List.of(own), List.of()).getPixelReader().getColor(200, 140);

    assertThat(near(rim, new Rgb(0xe6, 0x9f, 0), 0.15)).as("%s", rim).isTrue();
  }

  @Test
  void theArrowOfAGateLeadsWhereOneShallFly() {
    Pose foot = new Pose(Vec3.ZERO, Attitude.LEVEL);
    Shape.Gate ring = new Shape.Ring(0.5, 0.05, 1);
    Image along =
        picture(
            List.of(mark(GoalState.ACTIVE, new GoalMark.Opening("A", ring, foot, Direction.ALONG))),
            List.of());
    Image against =
        picture(
            List.of(
                mark(GoalState.ACTIVE, new GoalMark.Opening("A", ring, foot, Direction.AGAINST))),
            List.of());

    // ahead is up: the head of the arrow is 40 pixels above the middle, 8 pixels long
    assertThat(covered(along, 160, 168)).isGreaterThan(covered(along, 232, 240) + 10);
    assertThat(covered(against, 232, 240)).isGreaterThan(covered(against, 160, 168) + 10);
  }

  @Test
  void contactsAreRedAndCrashesLarger() {
    int touch = red(new ContactMark(1, Vec3.ZERO, false));
    int crash = red(new ContactMark(1, Vec3.ZERO, true));

    assertThat(touch).isGreaterThan(20);
    assertThat(crash).isGreaterThan(touch * 3 / 2);
  }

  private static int red(ContactMark contact) {
    Image picture = picture(List.of(), List.of(contact));
    int count = 0;
    for (int x = 180; x < 220; x++) {
      for (int y = 180; y < 220; y++) {
        count += near(picture.getPixelReader().getColor(x, y), MarkColors.CONTACT, 0.1) ? 1 : 0;
      }
    }
    return count;
  }

  /** How many pixels of some rows are not white, beside the middle as in it. */
  private static int covered(Image picture, int top, int bottom) {
    int count = 0;
    for (int x = 180; x < 220; x++) {
      for (int y = top; y < bottom; y++) {
        count += picture.getPixelReader().getColor(x, y).getSaturation() > 0.3 ? 1 : 0;
      }
    }
    return count;
  }

  private static boolean near(Color color, Rgb wanted, double tolerance) {
    Color other = FxTextures.color(wanted);
    return Math.abs(color.getRed() - other.getRed()) < tolerance
        && Math.abs(color.getGreen() - other.getGreen()) < tolerance
        && Math.abs(color.getBlue() - other.getBlue()) < tolerance;
  }

  private static GoalMark mark(GoalState state, GoalMark.Place place) {
    return new GoalMark(1, OptionalInt.empty(), state, place);
  }

  private static Image picture(List<GoalMark> goals, List<ContactMark> contacts) {
    return onFxThread(
        () -> {
          Canvas canvas = new Canvas(SCALE.width(), SCALE.height());
          MarkPainter painter = new MarkPainter(canvas.getGraphicsContext2D(), drone -> ORANGE);
          painter.paintPlaces(goals, SCALE);
          painter.paintSigns(goals, contacts, SCALE);
          return canvas.snapshot(null, null);
        });
  }
}
