package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import javafx.geometry.Point2D;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.shape.StrokeLineCap;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.overlay.ContactMark;
import tellosimulator.scenery.overlay.MarkColors;
import tellosimulator.view.fx.FxTextures;
import tellosimulator.world.Shape;

/**
 * Draws goals and contacts on a plan, in the colours and with the symbols that they have in the
 * room. For the JavaFX thread.
 */
final class MarkPainter {

  /** Half the edge of a number [px]. */
  private static final double TAG = 8;

  /** A number is at least this far above the middle, where one takes hold of a gate [px]. */
  private static final double ABOVE = TAG + 4;

  /** Radius of the sign of a touch, and of a crash [px]. */
  private static final double TOUCH = 5;

  private static final double CRASH = 9;

  /** Smallest radius of a goal [px]. */
  private static final double SMALLEST = 6;

  /** Length of the arrow of a gate, before and behind it [m]. Decided: by eye. */
  private static final double ARROW = 0.4;

  /** From the rim of a ball to the middle of its height below it [px]. */
  private static final double BELOW_BALL = 9;

  private static final Color CONTACT = FxTextures.color(MarkColors.CONTACT);

  private final GraphicsContext pen;
  private final PlanLabels labels;
  private final IntFunction<Color> drones;

  /**
   * @param drones gives the colour of the drone of a number
   */
  MarkPainter(GraphicsContext pen, IntFunction<Color> drones) {
    this.pen = pen;
    labels = new PlanLabels(pen);
    this.drones = drones;
  }

  /** Draws where goals are, which lies below what stands there. */
  void paintPlaces(List<GoalMark> goals, PlanViewport scale) {
    for (GoalMark goal : goals) {
      Color color = color(goal);
      pen.setStroke(color);
      pen.setFill(color.deriveColor(0, 1, 1, 0.3));
      pen.setLineWidth(2);
      if (goal.place() instanceof GoalMark.Ball ball) {
        disc(ball.middle(), ball.radius(), scale);
        height(ball, scale);
      } else if (goal.place() instanceof GoalMark.Circle circle) {
        disc(circle.middle(), circle.radius(), scale);
        ring(circle.middle(), circle.radius() / 2, scale);
      }
    }
  }

  /** Draws what lies above all else: the openings of gates, numbers and contacts. */
  void paintSigns(List<GoalMark> goals, List<ContactMark> contacts, PlanViewport scale) {
    for (GoalMark goal : goals) {
      if (goal.place() instanceof GoalMark.Opening opening) {
        paint(opening, goal, scale);
      }
    }
    for (ContactMark contact : contacts) {
      paint(contact, scale);
    }
    List<Point2D> tags = tags(goals, scale);
    for (int i = 0; i < goals.size(); i++) {
      tag(goals.get(i), tags.get(i));
    }
  }

  /**
   * The middles of the numbers: at the rims of what they are about, beside each other if that is
   * the same, and all of them within the picture [px].
   */
  static List<Point2D> tags(List<GoalMark> goals, PlanViewport scale) {
    Map<Vec3, Integer> at = new HashMap<>();
    List<Point2D> tags = new ArrayList<>();
    for (GoalMark goal : goals) {
      Vec3 middle = goal.place().middle();
      int aside = at.merge(middle, 1, Integer::sum) - 1;
      double x = scale.screenX(middle) + 2.2 * TAG * aside;
      double y = scale.screenY(middle) - Math.max(ABOVE, radius(goal.place()) * scale.pixels());
      tags.add(new Point2D(inside(x, scale.width()), inside(y, scale.height())));
    }
    return tags;
  }

  /** The place of a number that is near enough to an edge to be seen whole. */
  private static double inside(double middle, double size) {
    double edge = TAG + 1;
    return Math.max(edge, Math.min(size - edge, middle));
  }

  /** The uppermost goal whose number is at a point of the screen. */
  static Optional<GoalMark> tagged(List<GoalMark> goals, PlanViewport scale, double x, double y) {
    List<Point2D> tags = tags(goals, scale);
    for (int i = goals.size() - 1; i >= 0; i--) {
      if (Math.abs(tags.get(i).getX() - x) <= TAG && Math.abs(tags.get(i).getY() - y) <= TAG) {
        return Optional.of(goals.get(i));
      }
    }
    return Optional.empty();
  }

  private Color color(GoalMark goal) {
    Color color = FxTextures.color(MarkColors.of(goal, drone -> rgb(drones.apply(drone))));
    return goal.state() == GoalState.LATER ? color.deriveColor(0, 1, 1, 0.65) : color;
  }

  private static Rgb rgb(Color color) {
    return new Rgb(
        (int) Math.round(255 * color.getRed()),
        (int) Math.round(255 * color.getGreen()),
        (int) Math.round(255 * color.getBlue()));
  }

  private void disc(Vec3 middle, double meters, PlanViewport scale) {
    double radius = Math.max(SMALLEST, meters * scale.pixels());
    double left = scale.screenX(middle) - radius;
    double top = scale.screenY(middle) - radius;
    pen.fillOval(left, top, 2 * radius, 2 * radius);
    pen.strokeOval(left, top, 2 * radius, 2 * radius);
  }

  /** Says how high a ball is, below it. */
  private void height(GoalMark.Ball ball, PlanViewport scale) {
    double radius = Math.max(SMALLEST, ball.radius() * scale.pixels());
    pen.setFill(PlanLabels.INK);
    labels.write(
        PlanLabels.height(ball.middle().z()),
        scale.screenX(ball.middle()),
        scale.screenY(ball.middle()) + radius + BELOW_BALL,
        PlanLabels.SIZE);
  }

  private void ring(Vec3 middle, double meters, PlanViewport scale) {
    double radius = Math.max(SMALLEST / 2, meters * scale.pixels());
    pen.strokeOval(
        scale.screenX(middle) - radius, scale.screenY(middle) - radius, 2 * radius, 2 * radius);
  }

  private void paint(GoalMark.Opening opening, GoalMark goal, PlanViewport scale) {
    double half = Math.max(SMALLEST, width(opening.gate()) / 2 * scale.pixels());
    double reach = Math.max(14, ARROW * scale.pixels());
    pen.save();
    pen.translate(scale.screenX(opening.middle()), scale.screenY(opening.middle()));
    pen.setStroke(color(goal));
    pen.setLineCap(StrokeLineCap.ROUND);
    pen.rotate(-Math.toDegrees(opening.pose().attitude().heading()));
    pen.setLineWidth(5);
    pen.strokeLine(-half, 0, half, 0);
    if (opening.way().isPresent() && goal.state() == GoalState.ACTIVE) {
      double up = opening.way().get().dot(opening.pose().attitude().toRoom(new Vec3(1, 0, 0)));
      pen.setLineWidth(3);
      pen.strokeLine(0, up * reach, 0, -up * reach);
      pen.strokePolyline(
          new double[] {-6, 0, 6},
          new double[] {-up * (reach - 8), -up * reach, -up * (reach - 8)},
          3);
    }
    pen.restore();
  }

  private static double width(Shape.Gate gate) {
    return gate instanceof Shape.Ring ring ? 2 * ring.radius() : ((Shape.Frame) gate).width();
  }

  /** A number on a rounded square, or a tick. */
  private void tag(GoalMark goal, Point2D middle) {
    double x = middle.getX();
    double y = middle.getY();
    pen.setFill(color(goal).deriveColor(0, 1, 1, 1 / color(goal).getOpacity()));
    pen.setStroke(Color.WHITE);
    pen.setLineWidth(1);
    pen.fillRoundRect(x - TAG, y - TAG, 2 * TAG, 2 * TAG, TAG, TAG);
    pen.strokeRoundRect(x - TAG, y - TAG, 2 * TAG, 2 * TAG, TAG, TAG);
    if (goal.state() == GoalState.DONE) {
      pen.setLineWidth(2);
      pen.strokePolyline(
          new double[] {x - 4, x - 1, x + 4.5}, new double[] {y, y + 3.5, y - 3.5}, 3);
    } else {
      pen.setFill(Color.WHITE);
      labels.write(Integer.toString(goal.number()), x, y, PlanLabels.SIZE);
    }
  }

  private static double radius(GoalMark.Place place) {
    if (place instanceof GoalMark.Ball ball) {
      return ball.radius();
    }
    return place instanceof GoalMark.Circle circle ? circle.radius() : 0;
  }

  private void paint(ContactMark contact, PlanViewport scale) {
    double radius = contact.crash() ? CRASH : TOUCH;
    double cross = contact.crash() ? 2.8 : 2;
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
