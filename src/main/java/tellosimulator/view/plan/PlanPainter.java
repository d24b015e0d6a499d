package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.scenery.overlay.ContactDecal;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.words.Phrase;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Wind;

/** Draws a plan, on a light background in every theme. Confined to the JavaFX thread. */
final class PlanPainter {

  private static final Color FLOOR = Color.web("#f4f0e8");
  private static final Color GRID = Color.web("#d9d2c5");
  private static final Color AXIS = Color.web("#b9b0a0");
  private static final Color WALL = Color.web("#6f6658");
  private static final Color INK = PlanLabels.INK;
  private static final Color CHOSEN = Color.web("#0969da");
  private static final Color WRONG = Color.web("#cf222e");
  private static final Color WIND = Color.web("#0969da", 0.35);

  /** Minimum distance between grid lines [px]; denser lines are omitted. */
  private static final double NARROWEST_GRID = 7;

  /**
   * Candidate intervals between numbered grid lines, counted in grid lines. The smallest one that
   * leaves enough space is used.
   */
  private static final int[] NUMBERED_LINES = {1, 2, 5, 10, 20, 50};

  /** Minimum distance between numbers along the walls [px]. Decided: fits four digits and a gap. */
  private static final double NARROWEST_NUMBERS = 44;

  /** Distance between a pad and the label with its number [px]. Decided: by eye. */
  private static final double BESIDE_PAD = 16;

  /** Number of characters in a shortened name, without the ellipsis. */
  private static final int SHORT = 8;

  /** Size below which items are drawn without a name [px]. */
  private static final double SMALLEST_NAMED = 34;

  /** Minimum drawn size of an item, so that it can be seen and grabbed [px]. */
  static final double SMALLEST = 7;

  /**
   * Distance from a start's rim to the centre line of the ring that marks the selected drone [px].
   */
  static final double CHOSEN_GAP = 4;

  private static final double CHOSEN_LINE = 3;

  private final GraphicsContext pen;
  private final IntFunction<Color> colors;
  private final Function<Phrase, String> said;
  private final PlanLabels labels;
  private final OverlayPainter marks;
  private PlanViewport scale;

  /**
   * Creates a painter.
   *
   * @param colors returns the colour of a drone, given its number
   * @param said translates a phrase into the window's language
   */
  PlanPainter(GraphicsContext pen, IntFunction<Color> colors, Function<Phrase, String> said) {
    this.pen = pen;
    this.colors = colors;
    this.said = said;
    labels = new PlanLabels(pen);
    marks = new OverlayPainter(pen, labels, colors);
  }

  /**
   * The content to draw besides the placed items.
   *
   * @param chosen the number of the selected drone, whose start gets a bold ring; empty if there is
   *     only one drone
   * @param front the caption of the front wall
   */
  record Remarks(
      List<PlacedGoal> goals, List<ContactDecal> contacts, OptionalInt chosen, String front) {

    static final Remarks NONE = new Remarks(List.of(), List.of(), OptionalInt.empty(), "");
  }

  /**
   * Redraws the plan, except for the marks of selected items, the labels of items and a measured
   * distance.
   */
  void paint(FloorPlan plan, PlanViewport newScale, Remarks remarks) {
    scale = newScale;
    pen.clearRect(0, 0, scale.width(), scale.height());
    paintRoom(plan.arena().room(), plan.arena().decor().grid());
    pen.setFill(WALL);
    Vec3 middleOfFront = new Vec3(plan.arena().room().depth() / 2, 0, 0);
    labels.write(
        remarks.front,
        scale.screenX(middleOfFront),
        scale.screenY(middleOfFront) - 14,
        PlanLabels.SIZE);
    paintWind(plan.arena().wind());
    marks.paintPlaces(remarks.goals, scale);
    for (PlanItem item : plan.items()) {
      if (item instanceof Start start && remarks.chosen.equals(OptionalInt.of(start.drone()))) {
        choose(start.drone(), plan.placement(start));
      }
      if (!(item instanceof GoalItem)) { // goals are drawn with the remarks
        paint(plan, item);
      }
    }
    marks.paintSigns(remarks.goals, remarks.contacts, scale);
  }

  private void paintRoom(Room room, double grid) {
    Vec3 corner = new Vec3(room.depth() / 2, room.width() / 2, 0);
    double left = scale.screenX(corner);
    double top = scale.screenY(corner);
    double width = room.width() * scale.pixels();
    double height = room.depth() * scale.pixels();
    labels.clear(new Rectangle2D(left, top, width, height));
    double margin = PlanViewport.MARGIN;
    pen.setFill(FLOOR);
    pen.fillRect(left - margin, top - margin, width + 2 * margin, height + 2 * margin);
    pen.setLineWidth(1);
    if (grid * scale.pixels() >= NARROWEST_GRID) {
      pen.setStroke(GRID);
      for (int i = 1; i * grid < room.width() / 2; i++) {
        upright(new Vec3(0, i * grid, 0), top, height);
        upright(new Vec3(0, -i * grid, 0), top, height);
      }
      for (int i = 1; i * grid < room.depth() / 2; i++) {
        across(new Vec3(i * grid, 0, 0), left, width);
        across(new Vec3(-i * grid, 0, 0), left, width);
      }
    }
    pen.setStroke(AXIS);
    upright(Vec3.ZERO, top, height);
    across(Vec3.ZERO, left, width);
    pen.setStroke(WALL);
    pen.setLineWidth(4);
    pen.strokeRect(left - 2, top - 2, width + 4, height + 4);
    paintAxes(room, grid, left, top, top + height);
  }

  /** Draws the room's coordinates [cm] along the left and the back wall, at grid lines. */
  private void paintAxes(Room room, double grid, double left, double top, double bottom) {
    double step = numberStep(grid, scale.pixels());
    pen.setFill(WALL);
    labels.write("x", left - 20, top - 12, PlanLabels.SIZE);
    labels.write("y", left - 20, bottom + 14, PlanLabels.SIZE);
    int mostX = (int) Math.floor(room.depth() / 2 / step + 1e-9);
    for (int i = -mostX; i <= mostX; i++) {
      labels.write(
          PlanLabels.centimeters(i * step),
          left - 20,
          scale.screenY(new Vec3(i * step, 0, 0)),
          PlanLabels.SIZE);
    }
    int mostY = (int) Math.floor(room.width() / 2 / step + 1e-9);
    for (int i = -mostY; i <= mostY; i++) {
      labels.write(
          PlanLabels.centimeters(i * step),
          scale.screenX(new Vec3(0, i * step, 0)),
          bottom + 14,
          PlanLabels.SIZE);
    }
  }

  /**
   * Returns the distance between numbers along the walls [m].
   *
   * @param grid the distance between grid lines [m]
   * @param pixels the scale [pixels per metre]
   */
  static double numberStep(double grid, double pixels) {
    int lines =
        IntStream.of(NUMBERED_LINES)
            .filter(count -> count * grid * pixels >= NARROWEST_NUMBERS)
            .findFirst()
            .orElse(NUMBERED_LINES[NUMBERED_LINES.length - 1]);
    return lines * grid;
  }

  /** Draws a measured distance and its length. */
  void paint(MeasuredDistance measured) {
    Point2D from = scale.screen(measured.from());
    Point2D to = scale.screen(measured.to());
    pen.setStroke(CHOSEN);
    pen.setFill(CHOSEN);
    pen.setLineWidth(2);
    pen.strokeLine(from.getX(), from.getY(), to.getX(), to.getY());
    for (Point2D end : List.of(from, to)) {
      pen.fillOval(end.getX() - 3, end.getY() - 3, 6, 6);
    }
    Point2D middle = from.midpoint(to);
    labels.writeInFront(middle.getX(), middle.getY() - 12, measured.text());
  }

  private void upright(Vec3 place, double top, double height) {
    double x = Math.round(scale.screenX(place)) + 0.5;
    pen.strokeLine(x, top, x, top + height);
  }

  private void across(Vec3 place, double left, double width) {
    double y = Math.round(scale.screenY(place)) + 0.5;
    pen.strokeLine(left, y, left + width, y);
  }

  /** Draws the wind as an arrow in the lower left corner. */
  private void paintWind(Wind wind) {
    Vec3 mean = wind.mean().horizontal();
    if (mean.norm() < 0.005) {
      return;
    }
    pen.save();
    pen.translate(36, scale.height() - 36);
    pen.rotate(-Math.toDegrees(Math.atan2(mean.y(), mean.x())));
    pen.setFill(WIND);
    pen.fillPolygon(
        new double[] {0, 13, 4, 4, -4, -4, -13}, new double[] {-24, 0, -3, 24, 24, -3, 0}, 7);
    pen.restore();
  }

  private void paint(FloorPlan plan, PlanItem item) {
    Placement placement = plan.placement(item);
    PlanOutline outline = plan.outline(item);
    pen.save();
    pen.translate(scale.screenX(placement.place()), scale.screenY(placement.place()));
    pen.rotate(-Math.toDegrees(placement.heading()));
    if (item instanceof ObstacleItem body) {
      paint(plan.obstacle(body), outline);
    } else if (item instanceof Pad pad) {
      paint(plan.pad(pad), outline, labeled(plan, pad));
    } else {
      paintStart(((Start) item).drone());
    }
    pen.restore();
    if (item instanceof Start start) {
      number(start.drone(), placement);
    } else if (item instanceof Pad) {
      labels.space().block(scale.screen(placement.place()), outline.reach() * scale.pixels());
    }
  }

  /** Writes the labels of items where there is space. Selected items come first. */
  void label(FloorPlan plan, List<PlanItem> selected) {
    for (PlanItem item :
        Stream.concat(selected.stream(), plan.items().stream()).distinct().toList()) {
      if (item instanceof ObstacleItem body) {
        name(plan.obstacle(body), plan.outline(item), plan.placement(item));
      } else if (item instanceof Pad pad && labeled(plan, pad)) {
        Vec3 inside = plan.placement(pad).toRoom(new Vec3(scale.meters(BESIDE_PAD), 0, 0));
        labels.writeInFront(
            scale.screenX(inside), scale.screenY(inside), Integer.toString(pad.id()));
      }
    }
  }

  /** Returns the goal whose number is drawn at a point of the screen. */
  Optional<PlacedGoal> tagged(double x, double y) {
    return marks.tagged(x, y);
  }

  /** Draws an obstacle in its own frame. The x axis of this frame points up. */
  private void paint(Obstacle obstacle, PlanOutline outline) {
    int rgb = obstacle.appearance().rgb();
    Color fill = Color.rgb(rgb >> 16 & 0xff, rgb >> 8 & 0xff, rgb & 0xff);
    pen.setFill(fill.deriveColor(0, 1, 1, obstacle.foot().z() > 0.01 ? 0.55 : 0.9));
    pen.setStroke(fill.darker());
    pen.setLineWidth(1);
    shape(outline);
    if (obstacle.shape() instanceof Shape.Gate) {
      double reach = arrow();
      pen.setLineWidth(1.5);
      pen.setLineDashes(3, 3);
      pen.strokeLine(0, reach, 0, -reach);
      pen.setLineDashes();
      pen.strokePolyline(new double[] {-4, 0, 4}, new double[] {-reach + 6, -reach, -reach + 6}, 3);
    }
  }

  /**
   * Returns whether the number of a pad is a label beside it, because the pad hangs on a wall or a
   * drone starts on it.
   */
  private static boolean labeled(FloorPlan plan, Pad pad) {
    Placement placement = plan.placement(pad);
    return plan.pad(pad).surface().wall()
        || plan.starts().stream()
            .anyMatch(start -> plan.outline(pad).covers(start.position(), placement, 0));
  }

  private void paint(MissionPad pad, PlanOutline outline, boolean labeled) {
    double width = size(outline.width());
    double depth = size(outline.depth());
    pen.setFill(Color.WHITE);
    pen.setStroke(INK);
    pen.setLineWidth(1);
    pen.fillRect(-width / 2, -depth / 2, width, depth);
    pen.strokeRect(-width / 2, -depth / 2, width, depth);
    if (pad.surface().wall()) {
      return;
    }
    pen.setFill(INK);
    double tip = depth / 2 * 0.88;
    pen.fillPolygon(
        new double[] {0, width * 0.2, -width * 0.2},
        new double[] {-tip, -tip * 0.35, -tip * 0.35},
        3);
    if (!labeled) {
      labels.write(Integer.toString(pad.id()), 0, depth * 0.16, Math.max(8, depth * 0.5));
    }
  }

  private void paintStart(int drone) {
    Color own = colors.apply(drone);
    double radius = startRadius();
    pen.setFill(own);
    pen.fillPolygon(
        new double[] {0, radius * 0.62, -radius * 0.62},
        new double[] {-radius * 1.75, -radius * 0.7, -radius * 0.7},
        3);
    pen.setStroke(Color.WHITE);
    pen.setLineWidth(1.5);
    pen.fillOval(-radius, -radius, 2 * radius, 2 * radius);
    pen.strokeOval(-radius, -radius, 2 * radius, 2 * radius);
  }

  /**
   * Draws a ring around a start, like the ring around the drone in the 3D scene. The start itself
   * is drawn over it.
   */
  private void choose(int drone, Placement placement) {
    double radius = startRadius() + CHOSEN_GAP;
    double x = scale.screenX(placement.place()) - radius;
    double y = scale.screenY(placement.place()) - radius;
    labels.space().blockRim(scale.screen(placement.place()), radius);
    pen.setStroke(Color.WHITE);
    pen.setLineWidth(CHOSEN_LINE + 4);
    pen.strokeOval(x, y, 2 * radius, 2 * radius);
    pen.setStroke(colors.apply(drone));
    pen.setLineWidth(CHOSEN_LINE);
    pen.strokeOval(x, y, 2 * radius, 2 * radius);
  }

  private double startRadius() {
    return Math.max(SMALLEST + 2, DroneSpec.COLLIDER.radius() * scale.pixels());
  }

  private void number(int drone, Placement placement) {
    double radius = startRadius();
    Vec3 nose = placement.toRoom(new Vec3(scale.meters(1.3 * radius), 0, 0));
    labels.space().block(scale.screen(placement.place()), radius);
    labels.space().block(scale.screen(nose), 0.5 * radius);
    pen.setFill(DroneColors.inkOn(colors.apply(drone)));
    labels.write(
        Integer.toString(drone),
        scale.screenX(placement.place()),
        scale.screenY(placement.place()),
        Math.max(9, radius * 0.95));
  }

  private void name(Obstacle obstacle, PlanOutline outline, Placement placement) {
    double largest = size(Math.max(outline.width(), outline.depth()));
    if (largest < SMALLEST_NAMED) {
      return;
    }
    boolean below = size(Math.min(outline.width(), outline.depth())) < 22;
    double lowest =
        outline.corners(placement).stream().mapToDouble(scale::screenY).max().orElseThrow();
    double gap = obstacle.shape() instanceof Shape.Gate ? arrow() + 8 : 10;
    double y = below ? lowest + gap : scale.screenY(placement.place());
    String name = said.apply(obstacle.label());
    String shortened = name.length() > SHORT ? name.substring(0, SHORT) + "…" : name;
    labels.writeInFront(scale.screenX(placement.place()), y, name + height(obstacle), shortened);
  }

  /** Returns half the length of a gate's arrow [px]. */
  private double arrow() {
    return Math.max(10, 0.25 * scale.pixels());
  }

  /**
   * Formats the height of the middle of a gate's opening, or of the top of any other obstacle. For
   * an obstacle that does not stand on the floor, the height of its bottom is included.
   */
  static String height(Obstacle obstacle) {
    double foot = obstacle.foot().z();
    if (obstacle.shape() instanceof Shape.Gate gate) {
      return " · " + PlanLabels.height(foot + gate.middle());
    }
    String top = PlanLabels.centimeters(foot + obstacle.shape().height());
    return foot < 0.005 ? " · h " + top : " · " + PlanLabels.height(foot) + "–" + top;
  }

  private void shape(PlanOutline outline) {
    double width = size(outline.width());
    double depth = size(outline.depth());
    if (outline.round()) {
      pen.fillOval(-width / 2, -depth / 2, width, depth);
      pen.strokeOval(-width / 2, -depth / 2, width, depth);
    } else {
      pen.fillRect(-width / 2, -depth / 2, width, depth);
      pen.strokeRect(-width / 2, -depth / 2, width, depth);
    }
  }

  /**
   * Marks a selected item.
   *
   * @param wrong whether the last change was refused; the mark is then red
   */
  void mark(FloorPlan plan, PlanItem item, boolean wrong) {
    Placement placement = plan.placement(item);
    PlanOutline outline = plan.outline(item);
    double gap = 5;
    double width = size(outline.width()) + 2 * gap;
    double depth = size(outline.depth()) + 2 * gap;
    pen.save();
    pen.translate(scale.screenX(placement.place()), scale.screenY(placement.place()));
    pen.rotate(-Math.toDegrees(placement.heading()));
    pen.setStroke(wrong ? WRONG : CHOSEN);
    pen.setLineWidth(2);
    if (outline.round()) {
      pen.strokeOval(-width / 2, -depth / 2, width, depth);
    } else {
      pen.strokeRect(-width / 2, -depth / 2, width, depth);
    }
    pen.restore();
  }

  private double size(double meters) {
    return Math.max(SMALLEST, meters * scale.pixels());
  }
}
