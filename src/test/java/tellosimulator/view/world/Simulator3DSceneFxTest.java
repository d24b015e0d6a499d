package tellosimulator.view.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Comparator;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import javafx.css.PseudoClass;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.LightBase;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import tellosimulator.fault.Fault;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Terms;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Shape;

class Simulator3DSceneFxTest {

  @RegisterExtension final SceneFixture fixture = new SceneFixture();

  @BeforeEach
  void follow() {
    fixture.follow();
  }

  private static final Comparator<Color> BY_IDENTITY = (one, other) -> one == other ? 0 : 1;

  /** The modifier keys that are pressed. */
  private enum Keys {
    NONE,
    CTRL,
    SHIFT
  }

  @Test
  void theLeftButtonTurnsAroundTheDroneAndKeepsTheDistance() {
    Pose before = camera().pose();

    drag(MouseButton.PRIMARY, Keys.NONE, 60);

    Pose after = camera().pose();
    assertThat(headingChange(before, after)).isCloseTo(Math.toRadians(-18), within(1e-9));
    assertThat(after.position().distanceTo(drone()))
        .isCloseTo(before.position().distanceTo(drone()), within(1e-9));
  }

  @Test
  void ctrlMakesATurnFineAndShiftStrong() {
    Pose first = camera().pose();
    drag(MouseButton.PRIMARY, Keys.NONE, 10);
    Pose plain = camera().pose();
    drag(MouseButton.PRIMARY, Keys.CTRL, 10);
    Pose fine = camera().pose();
    drag(MouseButton.PRIMARY, Keys.SHIFT, 10);
    Pose strong = camera().pose();

    double turn = headingChange(first, plain);
    assertThat(headingChange(plain, fine)).isCloseTo(0.15 * turn, within(1e-9));
    assertThat(headingChange(fine, strong)).isCloseTo(5 * turn, within(1e-9));
  }

  @Test
  void theRightButtonAndThePressedWheelShift() {
    for (MouseButton button : new MouseButton[] {MouseButton.SECONDARY, MouseButton.MIDDLE}) {
      Pose before = camera().pose();

      drag(button, Keys.NONE, 40);

      Pose after = camera().pose();
      Vec3 moved = before.attitude().toBody(after.position().minus(before.position()));
      assertThat(moved.y()).as("to the left, so that the scene follows the hand").isPositive();
      assertThat(after.attitude()).isEqualTo(before.attitude());
    }
  }

  @Test
  void scrollingZoomsAndWithShiftTheSidewaysScrollCountsToo() {
    double far = camera().distance();
    scroll(0, 40, Keys.NONE);
    double near = camera().distance();
    scroll(0, 40, Keys.CTRL);
    double fine = camera().distance();
    scroll(40, 0, Keys.SHIFT);
    double strong = camera().distance();

    double step = Math.log(near / far);
    assertThat(step).isCloseTo(-0.1, within(1e-9));
    assertThat(Math.log(fine / near)).isCloseTo(0.15 * step, within(1e-9));
    assertThat(Math.log(strong / fine)).isCloseTo(5 * step, within(1e-9));
  }

  @Test
  void theSceneIsSeenThroughEitherCamera() {
    assertThat(fixture.scene().viewCameraProperty().get()).isEqualTo(ViewCamera.SIMULATOR);

    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));
    fixture.pass(0.1);

    assertThat(fixture.scene().viewCameraProperty().get()).isEqualTo(ViewCamera.DRONE);
  }

  /** Setting a light makes JavaFX redraw the whole room. */
  @Test
  void lightsAreSetOnlyWhenTheyChange() {
    SceneNodes nodes = new SceneNodes();
    List<Color> bright = lights(nodes);

    nodes.dim(1);
    assertThat(lights(nodes)).usingElementComparator(BY_IDENTITY).isEqualTo(bright);
    nodes.dim(0.5);
    List<Color> dim = lights(nodes);
    assertThat(dim.get(0)).as("on lamps and aids").isSameAs(bright.get(0));
    assertThat(dim.get(1).getBrightness()).isCloseTo(0.5, within(1e-6));
    nodes.dim(0.5);
    assertThat(lights(nodes)).usingElementComparator(BY_IDENTITY).isEqualTo(dim);
    nodes.dim(1);
    assertThat(lights(nodes)).isEqualTo(bright);
  }

  private static List<Color> lights(SceneNodes nodes) {
    return nodes.getChildren().stream()
        .filter(LightBase.class::isInstance)
        .map(light -> ((LightBase) light).getColor())
        .toList();
  }

  /** Without 3D, the image of the room is translucent. */
  @Test
  void aDarkWindowDimsTheRoomButNotWhatADroneFilms() {
    Simulator3DScene scene = fixture.scene();
    fixture.change(() -> scene.dimmedProperty().set(true));
    fixture.pass(0.1);
    assertThat(scene.view().node().getOpacity()).isEqualTo(0.78);

    fixture.change(() -> scene.viewCameraProperty().set(ViewCamera.DRONE));
    fixture.pass(0.1);
    assertThat(scene.view().node().getOpacity()).isEqualTo(1);
    assertThat(scene.getPseudoClassStates()).contains(PseudoClass.getPseudoClass("from-drone"));

    fixture.change(
        () -> {
          scene.viewCameraProperty().set(ViewCamera.SIMULATOR);
          scene.dimmedProperty().set(false);
        });
    fixture.pass(0.1);
    assertThat(scene.view().node().getOpacity()).isEqualTo(1);
    assertThat(scene.getPseudoClassStates())
        .doesNotContain(PseudoClass.getPseudoClass("from-drone"));
  }

  @Test
  void theInsetsButtonsShowAndEnlargeIt() {
    Simulator3DScene scene = fixture.scene();
    assertThat(scene.insetVisibleProperty().get()).isFalse();
    assertThat(scene.lookup("#inset-enlarge").isVisible()).isFalse();

    fixture.change(((Button) scene.lookup("#inset-toggle"))::fire);
    fixture.change(((Button) scene.lookup("#inset-enlarge"))::fire);

    assertThat(scene.insetVisibleProperty().get()).isTrue();
    assertThat(scene.insetEnlargedProperty().get()).isTrue();
    assertThat(scene.lookup("#inset-picture").isVisible()).isTrue();
  }

  @Test
  void faultsAreNamedBelowTheirDrone() {
    Label tag = (Label) fixture.scene().lookup(".fault-tag");
    assertThat(tag.isVisible()).isFalse();

    fly(0, new Vec3(0.5, 0, 1));
    fixture.disturb(Fault.of("loss 20%"), Fault.of("loss 30%"), Fault.of("dark"));
    fixture.pass(0.1);

    assertThat(tag.isVisible()).isTrue();
    assertThat(tag.getText()).isEqualTo("loss, dark");
    Bounds bounds = tag.getBoundsInParent(); // the camera looks at the drone
    assertThat(bounds.getCenterX()).isCloseTo(SceneFixture.WIDTH / 2.0, within(2.0));
    assertThat(bounds.getMinY()).isBetween(SceneFixture.HEIGHT / 2.0, SceneFixture.HEIGHT * 0.75);

    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));
    fixture.pass(0.1);
    assertThat(tag.isVisible()).isFalse();
  }

  @Test
  void gatesThatAreGoalsAreNamedBesideTheirNumbers() {
    fixture.furnish(arena -> arena.withObstacles(List.of(ring("A", 0.5), ring("C", -0.5))));
    fixture.ask(pass("C"), pass("C"));
    fly(0, new Vec3(-1, 0, 1));

    Label name = onlyName();
    assertThat(name.getText()).isEqualTo("C");
    AtomicInteger changes = new AtomicInteger();
    name.visibleProperty().addListener((property, before, now) -> changes.incrementAndGet());
    fixture.pass(0.2);
    assertThat(changes).as("what rests is not drawn anew").hasValue(0);
    Point2D top =
        camera()
            .viewpoint()
            .project(new Vec3(1, -0.5, 0.95), SceneFixture.WIDTH, SceneFixture.HEIGHT)
            .orElseThrow();
    // two numbers, each 0.032 of the distance wide; half of the first one is left of the gate
    double number = 0.032 * SceneFixture.HEIGHT / 2 / Math.tan(Math.toRadians(19));
    assertThat(name.getBoundsInParent().getMinX())
        .isCloseTo(top.getX() + 1.6 * number, within(6.0));
    assertThat(name.getBoundsInParent().getCenterY())
        .isCloseTo(top.getY() - number / 2, within(3.0));

    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.DRONE));
    fixture.pass(0.1);
    assertThat(name.isVisible()).as("in the picture from the drone").isFalse();

    fixture.change(() -> fixture.scene().viewCameraProperty().set(ViewCamera.SIMULATOR));
    fixture.ask(pass("A"));
    fixture.pass(0.1);
    assertThat(onlyName().getText()).isEqualTo("A");

    fixture.ask();
    fixture.pass(0.1);
    assertThat(name.isVisible()).isFalse();
  }

  @Test
  void aGateThatIsDoneSaysItsNameNoLonger() {
    fixture.furnish(arena -> arena.withObstacles(List.of(ring("A", 0.5), ring("C", -0.5))));
    fixture.ask(pass("A"), pass("C"), pass("A"));
    fly(0, new Vec3(-1, 0, 1));
    fixture.pass(0.1);
    assertThat(shownNames()).containsExactlyInAnyOrder("A", "C");

    fixture.reachFirst();
    fixture.pass(0.1);
    assertThat(shownNames()).as("A is asked for once more").containsExactlyInAnyOrder("A", "C");

    fixture.ask(pass("A"), pass("C"));
    fixture.reachFirst();
    fixture.pass(0.1);
    assertThat(shownNames()).containsExactly("C");
  }

  private List<String> shownNames() {
    return fixture.scene().lookupAll(".gate-name").stream()
        .filter(Node::isVisible)
        .map(name -> ((Label) name).getText())
        .toList();
  }

  /** Returns the only visible name of a gate. */
  private Label onlyName() {
    return (Label)
        fixture.scene().lookupAll(".gate-name").stream()
            .filter(Node::isVisible)
            .reduce(
                (one, other) -> {
                  throw new AssertionError("two names are shown");
                })
            .orElseThrow();
  }

  private static Obstacle ring(String name, double y) {
    Shape.Ring ring = new Shape.Ring(0.3, 0.05, 0.6);
    return new Obstacle(name, ring, new Vec3(1, y, 0), 0, ObstacleAppearance.DEFAULT);
  }

  private static Goal pass(String gate) {
    return new Goal.Pass(Terms.ANY, gate, Goal.Direction.EITHER);
  }

  private SimulatorCamera camera() {
    return fixture.scene().camera();
  }

  /** Returns the middle of the drone. */
  private Vec3 drone() {
    Pose pose = fixture.simulation().selected().poseProperty().get();
    return pose.position().plus(new Vec3(0, 0, 0.02));
  }

  /** Moves the drone, and waits until the camera rests. */
  private void fly(double heading, Vec3 position) {
    fixture.put(new Pose(position, Attitude.ofHeading(heading)), FlightPhase.FLYING);
    for (int i = 0; i < 40; i++) {
      fixture.pass(0.25);
    }
  }

  private static double headingChange(Pose before, Pose after) {
    return after.attitude().heading() - before.attitude().heading();
  }

  private void drag(MouseButton button, Keys keys, double right) {
    fixture.change(
        () -> {
          fire(MouseEvent.MOUSE_PRESSED, button, keys, 200);
          fire(MouseEvent.MOUSE_DRAGGED, button, keys, 200 + right);
          fire(MouseEvent.MOUSE_RELEASED, button, keys, 200 + right);
        });
  }

  private void fire(EventType<MouseEvent> type, MouseButton button, Keys keys, double x) {
    boolean down = type != MouseEvent.MOUSE_RELEASED;
    Event.fireEvent(
        fixture.scene(),
        new MouseEvent(
            type,
            x,
            100,
            x,
            100,
            button,
            1,
            keys == Keys.SHIFT,
            keys == Keys.CTRL,
            false,
            false,
            down && button == MouseButton.PRIMARY,
            down && button == MouseButton.MIDDLE,
            down && button == MouseButton.SECONDARY,
            false,
            false,
            false,
            null));
  }

  private void scroll(double deltaX, double deltaY, Keys keys) {
    fixture.change(
        () ->
            Event.fireEvent(
                fixture.scene(),
                new ScrollEvent(
                    ScrollEvent.SCROLL,
                    100,
                    100,
                    100,
                    100,
                    keys == Keys.SHIFT,
                    keys == Keys.CTRL,
                    false,
                    false,
                    false,
                    false,
                    deltaX,
                    deltaY,
                    deltaX,
                    deltaY,
                    ScrollEvent.HorizontalTextScrollUnits.NONE,
                    0,
                    ScrollEvent.VerticalTextScrollUnits.NONE,
                    0,
                    0,
                    null)));
  }
}
