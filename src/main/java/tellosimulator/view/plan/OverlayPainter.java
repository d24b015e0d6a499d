package tellosimulator.view.plan;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.shape.StrokeLineCap;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.overlay.ContactDecal;
import tellosimulator.scenery.overlay.OverlayColors;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.fx.FxTextures;

/**
 * Draws goals and contacts on a plan, with the colours and symbols of the 3D scene. Confined to the
 * JavaFX thread.
 */
final class OverlayPainter {

  /** Half the side length of a number tag [px]. */
  private static final double TAG = 8;

  /**
   * Distance from the middle of a gate up to the preferred place of its number tag [px]. The tag
   * leaves the middle free, so that the mouse can grab the gate there.
   */
  private static final double ABOVE = TAG + 4;

  /** Distance from the middle of a number tag to the middle of the height label below it [px]. */
  private static final double BELOW_TAG = 16;

  /** Radius of the symbol for a touch [px]. */
  private static final double TOUCH = 5;

  /** Radius of the symbol for a crash [px]. */
  private static final double CRASH = 9;

  /** Minimum drawn radius of a goal, and half the minimum drawn width of a gate's opening [px]. */
  private static final double SMALLEST = 6;

  /** Length of a gate's direction arrow on each side of the gate [m]. Decided: by eye. */
  private static final double ARROW = 0.4;

  private static final Color CONTACT = FxTextures.color(OverlayColors.CONTACT);

  private final GraphicsContext pen;
  private final PlanLabels labels;
  private final IntFunction<Color> drones;

  /** The places at which the number tags were last drawn [px]. */
  private final Map<PlacedGoal, Rectangle2D> tags = new LinkedHashMap<>();

  /**
   * Creates a painter.
   *
   * @param drones returns the colour of a drone, given its number
   */
  OverlayPainter(GraphicsContext pen, PlanLabels labels, IntFunction<Color> drones) {
    this.pen = pen;
    this.labels = labels;
    this.drones = drones;
  }

  /** Draws the areas of goals. Items that stand on these areas are drawn later. */
  void paintPlaces(List<PlacedGoal> goals, PlanViewport scale) {
    for (PlacedGoal goal : goals) {
      Color color = color(goal);
      pen.setStroke(color);
      pen.setFill(color.deriveColor(0, 1, 1, 0.3));
      pen.setLineWidth(2);
      if (goal.place() instanceof PlacedGoal.Ball ball) {
        disc(scale.screen(ball.middle()), Math.max(SMALLEST, ball.radius() * scale.pixels()));
      } else if (goal.place() instanceof PlacedGoal.Circle circle) {
        double radius = Math.max(SMALLEST, circle.radius() * scale.pixels());
        disc(scale.screen(circle.middle()), radius);
        rim(scale.screen(circle.middle()), radius / 2);
      } else if (goal.place() instanceof PlacedGoal.Square square) {
        disc(scale.screen(square.middle()), Math.max(SMALLEST, square.edge() / 2 * scale.pixels()));
      }
    }
  }

  /**
   * Draws the symbols over everything else: contacts, number tags, the openings of gates, and the
   * heights of balls. The areas of the items must already be blocked in the label space.
   */
  void paintSigns(List<PlacedGoal> goals, List<ContactDecal> contacts, PlanViewport scale) {
    for (PlacedGoal goal : goals) {
      if (goal.place() instanceof PlacedGoal.Opening opening) {
        paint(opening, goal, scale);
      }
    }
    for (ContactDecal contact : contacts) {
      paint(contact, scale);
    }
    tags.clear();
    for (PlacedGoal goal : goals) {
      tags.put(goal, place(goal, scale));
      tag(goal, tags.get(goal));
    }
    for (PlacedGoal goal : goals) {
      if (goal.place() instanceof PlacedGoal.Ball ball) {
        Point2D middle = scale.screen(ball.middle());
        String height = PlanLabels.height(ball.middle().z());
        labels.writeInFront(middle.getX(), middle.getY() + BELOW_TAG, height);
      }
    }
  }

  /**
   * Reserves a place within the plan for a number tag: the free place nearest to the preferred one.
   * If there is none nearby, returns the preferred place.
   */
  private Rectangle2D place(PlacedGoal goal, PlanViewport scale) {
    Point2D middle = scale.screen(goal.place().middle());
    double above = goal.place() instanceof PlacedGoal.Opening ? ABOVE : 0;
    Rectangle2D wanted = LabelSpace.square(middle.subtract(0, above), TAG + 1);
    Rectangle2D plan = new Rectangle2D(0, 0, scale.width(), scale.height());
    return labels.space().take(wanted, plan).orElse(wanted);
  }

  /** Returns the goal whose number tag is drawn at a point of the screen. */
  Optional<PlacedGoal> tagged(double x, double y) {
    return tags.keySet().stream().filter(goal -> tags.get(goal).contains(x, y)).findFirst();
  }

  private Color color(PlacedGoal goal) {
    Color color = FxTextures.color(OverlayColors.of(goal, drone -> rgb(drones.apply(drone))));
    return goal.state() == GoalState.LATER ? color.deriveColor(0, 1, 1, 0.65) : color;
  }

  private static Rgb rgb(Color color) {
    return new Rgb(
        (int) Math.round(255 * color.getRed()),
        (int) Math.round(255 * color.getGreen()),
        (int) Math.round(255 * color.getBlue()));
  }

  private void disc(Point2D middle, double radius) {
    pen.fillOval(middle.getX() - radius, middle.getY() - radius, 2 * radius, 2 * radius);
    rim(middle, radius);
  }

  private void rim(Point2D middle, double radius) {
    pen.strokeOval(middle.getX() - radius, middle.getY() - radius, 2 * radius, 2 * radius);
    labels.space().blockRim(middle, radius);
  }

  private void paint(PlacedGoal.Opening opening, PlacedGoal goal, PlanViewport scale) {
    double half = Math.max(SMALLEST, opening.gate().width() / 2 * scale.pixels());
    double reach = Math.max(14, ARROW * scale.pixels());
    double heading = opening.pose().attitude().heading();
    Point2D middle = scale.screen(opening.middle());
    Point2D side = new Point2D(Math.cos(heading), -Math.sin(heading)).multiply(half);
    labels.space().blockLine(middle.subtract(side), middle.add(side));
    pen.save();
    pen.translate(middle.getX(), middle.getY());
    pen.setStroke(color(goal));
    pen.setLineCap(StrokeLineCap.ROUND);
    pen.rotate(-Math.toDegrees(heading));
    pen.setLineWidth(5);
    pen.strokeLine(-half, 0, half, 0);
    if (opening.way().isPresent() && goal.state() == GoalState.ACTIVE) {
      double up = opening.way().get().dot(opening.pose().attitude().toRoom(new Vec3(1, 0, 0)));
      Point2D tip = new Point2D(-Math.sin(heading), -Math.cos(heading)).multiply(reach);
      labels.space().blockLine(middle.subtract(tip), middle.add(tip));
      pen.setLineWidth(3);
      pen.strokeLine(0, up * reach, 0, -up * reach);
      pen.strokePolyline(
          new double[] {-6, 0, 6},
          new double[] {-up * (reach - 8), -up * reach, -up * (reach - 8)},
          3);
    }
    pen.restore();
  }

  /**
   * Draws a rounded square with the number of a goal, or with a tick if the goal has been reached.
   */
  private void tag(PlacedGoal goal, Rectangle2D place) {
    double x = place.getMinX() + place.getWidth() / 2;
    double y = place.getMinY() + place.getHeight() / 2;
    Color fill = color(goal).deriveColor(0, 1, 1, 1 / color(goal).getOpacity());
    Color ink = goal.drone().isPresent() ? DroneColors.inkOn(fill) : Color.WHITE;
    pen.setFill(fill);
    pen.setStroke(Color.WHITE);
    pen.setLineWidth(1);
    pen.fillRoundRect(x - TAG, y - TAG, 2 * TAG, 2 * TAG, TAG, TAG);
    pen.strokeRoundRect(x - TAG, y - TAG, 2 * TAG, 2 * TAG, TAG, TAG);
    if (goal.state() == GoalState.DONE) {
      pen.setStroke(ink);
      pen.setLineWidth(2);
      pen.strokePolyline(
          new double[] {x - 4, x - 1, x + 4.5}, new double[] {y, y + 3.5, y - 3.5}, 3);
    } else {
      pen.setFill(ink);
      labels.write(Integer.toString(goal.number()), x, y, PlanLabels.SIZE);
    }
  }

  private void paint(ContactDecal contact, PlanViewport scale) {
    double radius = contact.crash() ? CRASH : TOUCH;
    double cross = contact.crash() ? 2.8 : 2;
    labels.space().block(scale.screen(contact.place()), radius);
    pen.save();
    pen.translate(scale.screenX(contact.place()), scale.screenY(contact.place()));
    pen.setFill(CONTACT);
    pen.setStroke(Color.WHITE);
    pen.setLineWidth(1);
    if (contact.crash()) {
      double[] x = {0, radius, 0, -radius};
      double[] y = {-radius, 0, radius, 0};
      pen.fillPolygon(x, y, 4);
      pen.strokePolygon(x, y, 4);
    } else {
      pen.fillOval(-radius, -radius, 2 * radius, 2 * radius);
      pen.strokeOval(-radius, -radius, 2 * radius, 2 * radius);
    }
    pen.setLineWidth(1.5);
    pen.strokeLine(-cross, -cross, cross, cross);
    pen.strokeLine(-cross, cross, cross, -cross);
    pen.restore();
  }
}
