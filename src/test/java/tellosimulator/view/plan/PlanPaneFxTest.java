package tellosimulator.view.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import javafx.geometry.Point2D;
import javafx.geometry.VerticalDirection;
import javafx.scene.control.Button;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.image.PixelReader;
import javafx.scene.input.KeyCode;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.testfx.api.FxRobot;
import tellosimulator.goal.Goal;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.testing.WindowFixture;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Wind;

class PlanPaneFxTest {

  private static final SimConfig TWO_DRONES =
      SimConfig.DEFAULT
          .withRoom(Room.DEFAULT, Formation.row(2, Vec3.ZERO, Room.DEFAULT))
          .withStreamPorts(new StreamPorts(9, 9));

  @RegisterExtension
  final WindowFixture window = new WindowFixture(TWO_DRONES, PlanPaneFxTest::pane);

  private static PlanPane pane(ViewContext context) {
    PlanPane pane = new PlanPane(context);
    pane.setPrefSize(800, 640);
    pane.shownProperty().set(true);
    return pane;
  }

  @Test
  void aDraggedStartComesToRestAtFiveCentimeters() {
    drag(start(1), new Vec3(1.03, -0.87, 0));

    waitUntil(() -> start(1).distanceTo(new Vec3(1.05, -0.85, 0)) < 1e-9);
    Pose drone = window.snapshot().drones().get(0).state().motion().pose();
    assertThat(drone.position()).as("it stands there").isEqualTo(start(1));
    assertThat(status()).isEqualTo("Start of drone 1: X 105, Y -85 cm, 0°");
  }

  @Test
  void thingsOfThePaletteAreAddedSelectedTurnedAndMoved() {
    robot().clickOn("#plan-add-box");
    assertThat(obstacles()).hasSize(1);
    Obstacle box = obstacles().get(0);
    assertThat(box.name()).isEqualTo("box 1");
    assertThat(box.shape()).isInstanceOf(Shape.Box.class);

    robot().type(KeyCode.R).type(KeyCode.UP, 3);

    assertThat(obstacles().get(0).heading()).isCloseTo(Math.toRadians(15), within(1e-9));
    assertThat(obstacles().get(0).foot().x() - box.foot().x()).isCloseTo(0.15, within(1e-9));

    robot().press(KeyCode.CONTROL).type(KeyCode.R, KeyCode.DOWN).release(KeyCode.CONTROL);
    assertThat(obstacles().get(0).heading()).isCloseTo(Math.toRadians(16), within(1e-9));
    assertThat(obstacles().get(0).foot().x() - box.foot().x()).isCloseTo(0.14, within(1e-9));
  }

  @Test
  void theWheelTurnsTheSelectedThing() {
    robot().clickOn("#plan-add-ring");
    Vec3 foot = obstacles().get(0).foot();

    robot().moveTo(at(foot)).scroll(2, VerticalDirection.UP);

    waitUntil(() -> Math.abs(obstacles().get(0).heading()) > 0.1);
    double notches = Math.toDegrees(obstacles().get(0).heading()) / 15;
    assertThat(notches).isCloseTo(Math.rint(notches), within(1e-6));
  }

  @Test
  void padsGetTheNextFreeNumberAndEachOnlyOnce() {
    for (int i = 0; i < MissionPad.LAST_ID; i++) {
      robot().clickOn("#plan-add-pad");
    }
    assertThat(arena().pads()).extracting(MissionPad::id).containsExactly(1, 2, 3, 4, 5, 6, 7, 8);
    assertThat(window.find("plan-add-pad", Button.class).isDisabled()).isTrue();

    robot().clickOn(at(arena().pads().get(4).pose(arena().room()).position()));
    robot().type(KeyCode.DELETE);
    assertThat(arena().pads()).extracting(MissionPad::id).doesNotContain(5).hasSize(7);
    robot().clickOn("#plan-add-pad");
    assertThat(arena().pads()).extracting(MissionPad::id).contains(5);
  }

  @Test
  void aDragIsUndoneAsOneAndDoneAgain() {
    robot().clickOn("#plan-add-cylinder");
    Vec3 first = obstacles().get(0).foot();
    drag(first, new Vec3(-1.5, -1.5, 0));
    waitUntil(() -> obstacles().get(0).foot().distanceTo(new Vec3(-1.5, -1.5, 0)) < 1e-9);

    control(KeyCode.Z);
    waitUntil(() -> obstacles().get(0).foot().equals(first));
    control(KeyCode.Z);
    waitUntil(() -> obstacles().isEmpty());
    control(KeyCode.Y);
    control(KeyCode.Y);
    waitUntil(
        () ->
            !obstacles().isEmpty()
                && obstacles().get(0).foot().distanceTo(new Vec3(-1.5, -1.5, 0)) < 1e-9);
  }

  @Test
  void undoingLeavesWindAndLooksAlone() {
    robot().clickOn("#plan-add-box");
    Wind wind = new Wind(new Vec3(0.5, 0, 0), 0);
    onFxThread(
        () -> {
          window.context().actions().carryOut(new Control.SetWind(wind));
          return true;
        });
    waitUntil(() -> window.context().simulation().arenaProperty().get().wind().equals(wind));

    control(KeyCode.Z);

    assertThat(obstacles()).isEmpty();
    assertThat(arena().wind()).isEqualTo(wind);
  }

  @Test
  void nothingLeavesTheRoomOrLandsOnAStart() {
    robot().clickOn("#plan-add-box");
    Vec3 before = obstacles().get(0).foot();

    robot().drag(at(before)).moveTo(at(start(2)));
    waitUntil(() -> status().equals("A drone starts there."));
    robot().moveTo(at(new Vec3(2.4, 0, 0)));
    waitUntil(() -> status().equals("That would be outside of the room."));
    robot().drop();

    assertThat(status()).startsWith("box 1");
    Obstacle box = obstacles().get(0);
    assertThat(Math.abs(box.foot().x())).isLessThanOrEqualTo(2.2); // half of it is 30 cm
    assertThat(box.foot().distanceTo(start(2))).isGreaterThan(0.3);
  }

  @Test
  void thePropertyPanelChangesWhatIsSelected() {
    robot().clickOn("#plan-add-box");

    type("property-width", "120");
    type("property-x", "-100");
    type("property-name", "table");

    waitUntil(() -> obstacles().get(0).name().equals("table"));
    Obstacle table = obstacles().get(0);
    assertThat(((Shape.Box) table.shape()).width()).isCloseTo(1.2, within(1e-9));
    assertThat(table.foot().x()).isCloseTo(-1, within(1e-9));
    control("plan", KeyCode.Z);
    assertThat(obstacles().get(0).name()).isEqualTo("box 1");
  }

  @Test
  void whatDoesNotFitIsToldAndTheOldNumberComesBack() {
    robot().clickOn("#plan-add-box");
    Obstacle before = obstacles().get(0);

    type("property-height", "900");

    waitUntil(() -> status().equals("That is higher than the room."));
    assertThat(obstacles().get(0)).isEqualTo(before);
    assertThat(window.find("property-height", TextField.class).getText()).isEqualTo("60");
  }

  @Test
  void twoObstaclesHaveNoCommonName() {
    robot().clickOn("#plan-add-box").clickOn("#plan-add-ring");

    type("property-name", "box 1");

    assertThat(status()).isEqualTo("Another obstacle has this name.");
    assertThat(obstacles()).extracting(Obstacle::name).containsExactly("box 1", "ring 1");
    assertThat(window.find("property-name", TextField.class).getText()).isEqualTo("ring 1");
  }

  @Test
  void severalThingsAreMovedAlignedAndRemovedTogether() {
    robot().clickOn("#plan-add-box").clickOn("#plan-add-cylinder");
    Vec3 box = obstacles().get(0).foot();
    Vec3 cylinder = obstacles().get(1).foot();
    robot().press(KeyCode.SHIFT).clickOn(at(box)).release(KeyCode.SHIFT);
    waitUntil(() -> status().startsWith("2 objects are selected"));

    robot().type(KeyCode.DOWN, 2);
    assertThat(obstacles().get(0).foot().x()).isCloseTo(box.x() - 0.1, within(1e-9));
    assertThat(obstacles().get(1).foot().x()).isCloseTo(cylinder.x() - 0.1, within(1e-9));

    robot().type(KeyCode.DELETE);
    assertThat(obstacles()).isEmpty();
    control(KeyCode.Z);
    assertThat(obstacles()).hasSize(2);
  }

  @Test
  void aDuplicateStandsBesideAndIsSelected() {
    robot().clickOn("#plan-add-frame").type(KeyCode.R);
    control(KeyCode.D);

    assertThat(obstacles()).extracting(Obstacle::name).containsExactly("frame 1", "frame 2");
    Obstacle first = obstacles().get(0);
    Obstacle second = obstacles().get(1);
    assertThat(second.shape()).isEqualTo(first.shape());
    assertThat(second.heading()).isEqualTo(first.heading());
    assertThat(second.foot().distanceTo(first.foot())).isGreaterThan(0.2);
    assertThat(status()).startsWith("frame 2");
  }

  @Test
  void theRulerMeasuresAndLeavesThingsAlone() {
    robot().clickOn("#plan-add-box");
    List<Obstacle> before = obstacles();

    robot().clickOn("#plan-ruler");
    drag(obstacles().get(0).foot(), new Vec3(-1, -1, 0));

    assertThat(obstacles()).isEqualTo(before);
    robot().clickOn("#plan").type(KeyCode.ESCAPE);
    assertThat(window.find("plan-ruler", ToggleButton.class).isSelected()).isFalse();
    assertThat(window.view(PlanPane.class).shownProperty().get()).isTrue();
  }

  @Test
  void whileADroneFliesGoalsStayAsTheyAre() throws IOException {
    addGoal("land");
    assertThat(goals()).hasSize(1);
    onFxThread(
        () -> {
          window.context().actions().switchPower(1, true);
          return true;
        });
    window.snapshot();
    takeOff();

    addGoal("reach");
    assertThat(status()).startsWith("A drone is flying");
    robot().clickOn("#plan-remove");

    assertThat(goals()).hasSize(1);
  }

  @Test
  void aGoalThroughAGateIsDraggedToAnotherGate() {
    robot().clickOn("#plan-add-ring").clickOn("#plan-add-frame");
    addGoal("pass");
    assertThat(goals()).extracting(Goal::task).hasToString("[fly through gate frame 1]");
    Vec3 ring = obstacles().get(0).foot();
    Vec3 frame = obstacles().get(1).foot();

    Point2D tag = at(frame).subtract(0, 6);
    robot().drag(tag).moveTo(at(ring.plus(frame).times(0.5))).dropTo(at(ring));

    assertThat(goals()).extracting(Goal::task).hasToString("[fly through gate ring 1]");
    assertThat(obstacles()).extracting(Obstacle::foot).containsExactly(ring, frame);
    robot().clickOn(at(ring.plus(new Vec3(0, 0.3, 0)))).type(KeyCode.DELETE);
    assertThat(status()).startsWith("A goal refers to this");
  }

  @Test
  void aGoalToSeeNamesAPadAndHasASizeAndATime() {
    robot().clickOn("#plan-add-pad");
    addGoal("see");

    type("property-size", "25");
    type("property-seconds", "3");

    waitUntil(() -> goals().get(0).lasting() == 3);
    assertThat(goals())
        .extracting(Goal::task)
        .hasToString("[see mission pad 1 for 3.0 s, at least 25% of the picture's width]");
    ComboBox<?> target = window.find("property-target", ComboBox.class);
    assertThat(target.getButtonCell().getText()).isEqualTo("mission pad 1");
  }

  /** This test's pane has no application that could open another simulation. */
  @Test
  void aDroneThatCannotBeAddedIsNotSelected() {
    robot().clickOn("#plan-add-box");
    Vec3 box = obstacles().get(0).foot();

    robot().clickOn("#plan-add-drone").type(KeyCode.UP);

    assertThat(obstacles().get(0).foot().x()).isCloseTo(box.x() + 0.05, within(1e-9));
    control(KeyCode.Z);
    control(KeyCode.Z);
    assertThat(obstacles()).isEmpty();
  }

  @Test
  void theStartOfTheChosenDroneHasABoldRing() {
    waitUntil(() -> ringed(1));
    assertThat(ringed(2)).isFalse();

    onFxThread(
        () -> {
          window.context().simulation().selectNext(1);
          return true;
        });

    waitUntil(() -> ringed(2));
    assertThat(ringed(1)).isFalse();
  }

  @Test
  void thePlanSaysWhatACircleIs() {
    assertThat(window.find("plan-legend", Label.class).getText()).isEqualTo("Start of a drone");
  }

  /**
   * Whether the drone's colour is found left, right and behind its start, outside of the circle.
   */
  private boolean ringed(int drone) {
    return onFxThread(
        () -> {
          PlanView view = window.find("plan", PlanView.class);
          Color own = DroneColors.of(window.context().simulation().drones().get(drone - 1));
          PixelReader pixels = view.snapshot(null, null).getPixelReader();
          double x = view.scale().screenX(start(drone));
          double y = view.scale().screenY(start(drone));
          double reach =
              Math.max(9, DroneSpec.COLLIDER.radius() * view.scale().pixels())
                  + PlanPainter.CHOSEN_GAP;
          return Stream.of(
                  new Point2D(x - reach, y), new Point2D(x + reach, y), new Point2D(x, y + reach))
              .allMatch(at -> near(pixels.getColor((int) at.getX(), (int) at.getY()), own));
        });
  }

  private static boolean near(Color one, Color other) {
    return Math.abs(one.getRed() - other.getRed()) < 0.1
        && Math.abs(one.getGreen() - other.getGreen()) < 0.1
        && Math.abs(one.getBlue() - other.getBlue()) < 0.1;
  }

  private void takeOff() throws IOException {
    try (DatagramSocket operator = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      for (String command : List.of("command", "takeoff")) {
        byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
        operator.send(
            new DatagramPacket(bytes, bytes.length, window.simulation().addresses(1).get(0)));
      }
    }
    waitUntil(
        () -> window.context().simulation().snapshot().drones().get(0).state().phase().flying());
  }

  private void addGoal(String kind) {
    robot().clickOn("#plan-add-goal");
    waitUntil(() -> robot().lookup("#plan-add-" + kind).tryQuery().isPresent());
    robot().clickOn("#plan-add-" + kind);
  }

  private List<Goal> goals() {
    return window.context().scenario().challenge().goals();
  }

  private void type(String field, String text) {
    robot().clickOn("#" + field).press(KeyCode.CONTROL).type(KeyCode.A).release(KeyCode.CONTROL);
    robot().write(text).type(KeyCode.ENTER);
  }

  private void control(String focused, KeyCode key) {
    onFxThread(
        () -> {
          window.find(focused, PlanView.class).requestFocus();
          return true;
        });
    control(key);
  }

  @Test
  void thePlanStaysWhereItIsWhenSomethingIsSelected() {
    double before = onFxThread(() -> window.find("plan", PlanView.class).getWidth());

    robot().clickOn("#plan-add-box");
    assertThat(onFxThread(() -> window.find("plan", PlanView.class).getWidth())).isEqualTo(before);
  }

  @Test
  void escapeLetsGoAndThenClosesThePlan() {
    robot().clickOn("#plan-add-box").type(KeyCode.ESCAPE);
    assertThat(status()).startsWith("Drag with the mouse");

    robot().type(KeyCode.ESCAPE);
    assertThat(window.view(PlanPane.class).shownProperty().get()).isFalse();
  }

  private FxRobot robot() {
    return window.robot();
  }

  private void control(KeyCode key) {
    robot().press(KeyCode.CONTROL).type(key).release(KeyCode.CONTROL);
  }

  private void drag(Vec3 from, Vec3 to) {
    robot().drag(at(from)).moveTo(at(from.plus(to).times(0.5))).dropTo(at(to));
  }

  /** Returns the position of a place of the floor on the screen. */
  private Point2D at(Vec3 place) {
    return onFxThread(
        () -> {
          PlanView view = window.find("plan", PlanView.class);
          return view.localToScreen(view.scale().screenX(place), view.scale().screenY(place));
        });
  }

  private String status() {
    return window.find("plan-status", Label.class).getText();
  }

  private Arena arena() {
    return window.snapshot().arena();
  }

  private List<Obstacle> obstacles() {
    return arena().obstacles();
  }

  private Vec3 start(int drone) {
    return window.snapshot().drones().get(drone - 1).start().position();
  }
}
