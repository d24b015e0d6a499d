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
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.overlay.GoalTags;

/**
 * The names of the gates that are goals, each at the right of the gate's numbers in the picture of
 * the room: so one finds the gate that the list of goals names. Gates that are done say it no
 * longer. For the JavaFX thread.
 */
final class GateNames extends Pane {

  /** From a number to the name [px]. */
  private static final double GAP = 3;

  /** Decided: what is longer ends in an ellipsis before it covers the next gate [px]. */
  private static final double LONGEST = 110;

  /** From number to number, in edges of one. */
  private static final double STEP = 1.1;

  private static final PseudoClass NEXT = PseudoClass.getPseudoClass("next");

  /** The goals of one gate. */
  private static final class Gate {

    private final GoalMark.Opening opening;
    private int numbers;
    private boolean next;
    private boolean wanted;

    Gate(GoalMark.Opening opening) {
      this.opening = opening;
    }
  }

  private final List<Label> names = new ArrayList<>();
  private List<GoalMark> known = List.of();
  private List<Gate> gates = List.of();

  GateNames() {
    setMouseTransparent(true);
    setManaged(false);
  }

  /**
   * Follows the goals.
   *
   * @param viewpoint from where they are seen; empty for no names
   */
  void advance(List<GoalMark> goals, Optional<Viewpoint> viewpoint) {
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
      names.get(i).setVisible(seen); // once: a change and back would be drawn, too
    }
  }

  private static List<Gate> gates(List<GoalMark> goals) {
    Map<String, Gate> gates = new LinkedHashMap<>();
    for (GoalMark goal : goals) {
      if (goal.place() instanceof GoalMark.Opening opening) {
        Gate gate = gates.computeIfAbsent(opening.name(), name -> new Gate(opening));
        gate.numbers++;
        gate.next |= goal.state() == GoalState.ACTIVE;
        gate.wanted |= goal.state() != GoalState.DONE;
      }
    }
    return gates.values().stream().filter(gate -> gate.wanted).toList();
  }

  /**
   * Places a name beside the tags, which stand on the top of the gate.
   *
   * @return whether it is in sight
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
