package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;

import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.TimeoutException;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.image.Image;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.testfx.api.FxToolkit;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.overlay.ContactDecal;
import tellosimulator.scenery.overlay.OverlayColors;
import tellosimulator.view.fx.FxTextures;
import tellosimulator.world.Shape;

/** The look of goals and contacts on a plan of 4 m with 100 pixels per metre. */
class OverlayPainterFxTest {

  private static final PlanViewport SCALE = new PlanViewport(Vec3.ZERO, 100, 400, 400);
  private static final Color ORANGE = Color.web("#e69f00");
  private static final PlacedGoal.Ball BALL = new PlacedGoal.Ball(new Vec3(1, 0, 1), 0.4);

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
      assertThat(near(rim, OverlayColors.of(state), state == GoalState.LATER ? 0.4 : 0.15))
          .as("%s: %s", state, rim)
          .isTrue();
    }
  }

  @Test
  void theGoalOfADroneHasItsColor() {
    PlacedGoal own = new PlacedGoal(1, OptionalInt.of(2), GoalState.ACTIVE, BALL);

    Color rim = picture(List.of(own), List.of()).getPixelReader().getColor(200, 140);

    assertThat(near(rim, new Rgb(0xe6, 0x9f, 0), 0.15)).as("%s", rim).isTrue();
  }

  @Test
  void theArrowOfAGateLeadsWhereOneShallFly() {
    Pose foot = new Pose(Vec3.ZERO, Attitude.LEVEL);
    Shape.Gate ring = new Shape.Ring(0.5, 0.05, 1);
    Image along =
        picture(
            List.of(
                mark(GoalState.ACTIVE, new PlacedGoal.Opening("A", ring, foot, Direction.ALONG))),
            List.of());
    Image against =
        picture(
            List.of(
                mark(GoalState.ACTIVE, new PlacedGoal.Opening("A", ring, foot, Direction.AGAINST))),
            List.of());

    // ahead is up: the head of the arrow is 40 pixels above the middle, 8 pixels long
    assertThat(covered(along, 160, 168)).isGreaterThan(covered(along, 232, 240) + 10);
    assertThat(covered(against, 232, 240)).isGreaterThan(covered(against, 160, 168) + 10);
  }

  @Test
  void contactsAreRedAndCrashesLarger() {
    int touch = red(new ContactDecal(1, Vec3.ZERO, false));
    int crash = red(new ContactDecal(1, Vec3.ZERO, true));

    assertThat(touch).isGreaterThan(20);
    assertThat(crash).isGreaterThan(touch * 3 / 2);
  }

  @Test
  void numbersOfGoalsAtTheEdgeAreSeenWhole() {
    PlanViewport scale = new PlanViewport(new Vec3(-1, 0, 0), 100, 400, 400);
    PlacedGoal mark = mark(GoalState.ACTIVE, new PlacedGoal.Ball(new Vec3(1.5, 0, 1), 0.3));
    assertThat(scale.screenY(mark.place().middle())).as("above the picture").isNegative();

    onFxThread(
        () -> {
          GraphicsContext pen = new Canvas(400, 400).getGraphicsContext2D();
          OverlayPainter painter = new OverlayPainter(pen, new PlanLabels(pen), drone -> ORANGE);
          painter.paintSigns(List.of(mark), List.of(), scale);
          assertThat(painter.tagged(200, 2)).contains(mark);
          assertThat(painter.tagged(200, 16)).as("with half its height").contains(mark);
          return painter;
        });
  }

  @Test
  void aPlanWithoutSizeIsDrawn() {
    PlanViewport scale = new PlanViewport(Vec3.ZERO, 0.1, 0, 0);
    List<PlacedGoal> goals = List.of(mark(GoalState.ACTIVE, BALL), mark(GoalState.LATER, BALL));

    onFxThread(
        () -> {
          GraphicsContext pen = new Canvas(0, 0).getGraphicsContext2D();
          OverlayPainter painter = new OverlayPainter(pen, new PlanLabels(pen), drone -> ORANGE);
          painter.paintPlaces(goals, scale);
          painter.paintSigns(goals, List.of(), scale);
          assertThat(painter.tagged(0, 0)).isPresent();
          return painter;
        });
  }

  private static int red(ContactDecal contact) {
    Image picture = picture(List.of(), List.of(contact));
    int count = 0;
    for (int x = 180; x < 220; x++) {
      for (int y = 180; y < 220; y++) {
        count += near(picture.getPixelReader().getColor(x, y), OverlayColors.CONTACT, 0.1) ? 1 : 0;
      }
    }
    return count;
  }

  /** Returns the number of coloured pixels in some rows, including the sides. */
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

  private static PlacedGoal mark(GoalState state, PlacedGoal.Place place) {
    return new PlacedGoal(1, OptionalInt.empty(), state, place);
  }

  private static Image picture(List<PlacedGoal> goals, List<ContactDecal> contacts) {
    return onFxThread(
        () -> {
          Canvas canvas = new Canvas(SCALE.width(), SCALE.height());
          GraphicsContext pen = canvas.getGraphicsContext2D();
          OverlayPainter painter = new OverlayPainter(pen, new PlanLabels(pen), drone -> ORANGE);
          painter.paintPlaces(goals, SCALE);
          painter.paintSigns(goals, contacts, SCALE);
          return canvas.snapshot(null, null);
        });
  }
}
