package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.geometry.Point2D;
import javafx.scene.control.Label;
import javafx.scene.layout.Pane;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.overlay.GoalTags;

/**
 * Shows the names of the gates that are goals. Each name is to the right of the gate's numbers in
 * the 3D scene, so that users can find the gate in the list of goals. The label of a completed gate
 * is hidden. Confined to the JavaFX thread.
 */
final class GateNames extends Pane {

  /** Gap between a number and the name [px]. */
  private static final double GAP = 3;

  /**
   * Maximum width of a name [px]. Decided: longer names end in an ellipsis before they cover the
   * next gate.
   */
  private static final double LONGEST = 110;

  /** Distance between the middles of adjacent number tags, as a multiple of a tag's side length. */
  private static final double STEP = 1.1;

  private static final PseudoClass NEXT = PseudoClass.getPseudoClass("next");

  /** A gate with all of its goals. */
  private static final class Gate {

    private final PlacedGoal.Opening opening;
    private int numbers;
    private boolean next;
    private boolean wanted;

    Gate(PlacedGoal.Opening opening) {
      this.opening = opening;
    }
  }

  private final List<Label> names = new ArrayList<>();
  private List<PlacedGoal> known = List.of();
  private List<Gate> gates = List.of();

  GateNames() {
    setMouseTransparent(true);
    setManaged(false);
  }

  /**
   * Updates the names and their positions.
   *
   * @param viewpoint the viewpoint from which the gates are seen; empty hides all names
   */
  void advance(List<PlacedGoal> goals, Optional<Viewpoint> viewpoint) {
    if (!goals.equals(known)) {
      known = goals;
      gates = gates(goals);
    }
    while (names.size() < gates.size()) {
      Label name = new Label();
      name.getStyleClass().add("gate-name");
      names.add(name);
      getChildren().add(name);
    }
    for (int i = 0; i < names.size(); i++) {
      boolean seen =
          i < gates.size()
              && viewpoint.isPresent()
              && place(names.get(i), gates.get(i), viewpoint.get());
      names.get(i).setVisible(seen); // set once, to avoid a redraw
    }
  }

  private static List<Gate> gates(List<PlacedGoal> goals) {
    Map<String, Gate> gates = new LinkedHashMap<>();
    for (PlacedGoal goal : goals) {
      if (goal.place() instanceof PlacedGoal.Opening opening) {
        Gate gate = gates.computeIfAbsent(opening.name(), name -> new Gate(opening));
        gate.numbers++;
        gate.next |= goal.state() == GoalState.ACTIVE;
        gate.wanted |= goal.state() != GoalState.DONE;
      }
    }
    return gates.values().stream().filter(gate -> gate.wanted).toList();
  }

  /**
   * Places a name beside the number tags, which stand on top of the gate.
   *
   * @return whether the name is in view
   */
  private boolean place(Label name, Gate gate, Viewpoint viewpoint) {
    Pose camera = viewpoint.pose();
    Vec3 foot = gate.opening.top();
    double edge = GoalTags.SIZE * camera.position().distanceTo(foot);
    Vec3 head = foot.plusScaled(camera.attitude().toRoom(Vec3.UP), edge);
    Optional<Point2D> below = viewpoint.project(foot, getWidth(), getHeight());
    Optional<Point2D> above = viewpoint.project(head, getWidth(), getHeight());
    if (below.isEmpty() || above.isEmpty()) {
      return false;
    }
    name.setText(gate.opening.name());
    name.pseudoClassStateChanged(NEXT, gate.next);
    name.resize(Math.min(LONGEST, name.prefWidth(-1)), name.prefHeight(-1));
    double pixels = below.get().getY() - above.get().getY();
    double left = below.get().getX() + pixels * (0.5 + STEP * (gate.numbers - 1)) + GAP;
    double middle = below.get().getY() - pixels / 2;
    name.relocate(Math.rint(left), Math.rint(middle - name.getHeight() / 2));
    return true;
  }
}
