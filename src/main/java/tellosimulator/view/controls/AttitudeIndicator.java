package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.Group;
import javafx.scene.shape.Arc;
import javafx.scene.shape.ArcType;
import javafx.scene.shape.Circle;
import javafx.scene.shape.Line;
import javafx.scene.shape.Path;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Polyline;
import javafx.scene.transform.Rotate;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Messages;

/**
 * An artificial horizon: sky and ground as seen from the drone, a pitch ladder with a rung every 10
 * degrees, and a roll scale. Confined to the JavaFX thread.
 */
final class AttitudeIndicator extends Instrument {

  /** The smallest visible change of an angle [deg]. */
  private static final double VISIBLE = 0.25;

  private static final int RUNG_STEP = 10;
  private static final int HIGHEST_RUNG = 40;

  /** Roll angles of the scale at the rim [deg]. */
  private static final double[] ROLL_MARKS = {-60, -30, -15, 0, 15, 30, 60};

  private record Rung(int angleDeg, Line line) {}

  private final Messages messages;
  private final double middle;
  private final double radius;
  private final Rotate bank = new Rotate();
  private final Arc ground = Nodes.styled(new Arc(), "ground");
  private final Line horizon;
  private final List<Rung> rungs = new ArrayList<>();
  private double pitchDeg;
  private double rollDeg;
  private double drawnPitch = Double.NaN;

  /**
   * @param size the width and height [px]
   */
  AttitudeIndicator(Messages messages, double size) {
    super("attitude", "attitude-indicator", size, size);
    this.messages = messages;
    this.middle = size / 2;
    this.radius = size / 2 - 2;
    this.horizon = line(radius, "horizon");
    initializeParts();
    layoutParts();
    drawPitch();
  }

  private void initializeParts() {
    bank.setPivotX(middle);
    bank.setPivotY(middle);
    ground.setCenterX(middle);
    ground.setCenterY(middle);
    ground.setRadiusX(radius);
    ground.setRadiusY(radius);
    ground.setType(ArcType.CHORD);
    for (int angle = -HIGHEST_RUNG; angle <= HIGHEST_RUNG; angle += RUNG_STEP) {
      if (angle != 0) {
        boolean even = angle % (2 * RUNG_STEP) == 0;
        rungs.add(new Rung(angle, line(radius * (even ? 0.34 : 0.18), "rung")));
      }
    }
  }

  private void layoutParts() {
    Circle sky = Nodes.styled(new Circle(middle, middle, radius), "sky");
    Path marks = new DialScale(middle, radius).marks(0.86, ROLL_MARKS);
    Group world = new Group(sky, ground, horizon, marks);
    rungs.forEach(rung -> world.getChildren().add(rung.line()));
    world.getTransforms().add(bank);

    double wing = radius * 0.52;
    double gap = radius * 0.2;
    Polyline left = new Polyline(-wing, 0, -gap, 0, -gap, gap * 0.6);
    Polyline right = new Polyline(wing, 0, gap, 0, gap, gap * 0.6);
    Circle nose = new Circle(0, 0, 2);
    Polygon index = new Polygon(0, -radius * 0.84, -4, -radius * 0.84 + 7, 4, -radius * 0.84 + 7);
    Circle bezel = new Circle(0, 0, radius);
    List.of(left, right).forEach(part -> Nodes.styled(part, "wing"));
    List.of(nose, index).forEach(part -> part.getStyleClass().add("symbol"));
    bezel.getStyleClass().add("bezel");
    Group frame = new Group(left, right, nose, index, bezel);
    frame.setLayoutX(middle);
    frame.setLayoutY(middle);
    addShapes(world, frame);
  }

  /**
   * Shows an attitude.
   *
   * @param newPitchDeg the pitch; nose up is positive [deg]
   * @param newRollDeg the roll; right side down is positive [deg]
   */
  void show(double newPitchDeg, double newRollDeg) {
    pitchDeg = newPitchDeg;
    rollDeg = newRollDeg;
    drawPitch();
    if (Math.abs(-rollDeg - bank.getAngle()) >= VISIBLE) {
      bank.setAngle(-rollDeg);
    }
  }

  private void drawPitch() {
    if (Math.abs(pitchDeg - drawnPitch) < VISIBLE) {
      return;
    }
    drawnPitch = pitchDeg;
    Horizon geometry = Horizon.of(pitchDeg, radius);
    ground.setStartAngle(geometry.groundStartDeg());
    ground.setLength(geometry.groundExtentDeg());
    double half = Math.sqrt(radius * radius - geometry.offset() * geometry.offset());
    horizon.setStartX(middle - half);
    horizon.setEndX(middle + half);
    horizon.setTranslateY(geometry.offset());
    for (Rung rung : rungs) {
      double offset = geometry.rung(rung.angleDeg());
      rung.line().setTranslateY(offset);
      rung.line().setVisible(Math.abs(offset) < radius * 0.74);
    }
  }

  private Line line(double half, String styleClass) {
    Line line = Nodes.styled(new Line(middle - half, middle, middle + half, middle), styleClass);
    return line;
  }

  @Override
  String description() {
    return messages.now(
        "attitude.accessible", NumberText.whole(pitchDeg), NumberText.whole(rollDeg));
  }

  /**
   * The geometry of the artificial horizon for a given pitch, before it is rotated by the roll.
   * Lengths are in pixels, measured downwards from the centre of a round dial.
   *
   * @param radius the radius of the dial
   * @param offset the horizon's distance below the centre
   */
  record Horizon(double radius, double offset) {

    /**
     * Pitch at which the horizon reaches the dial's edge [deg]. Decided: twice the drone's maximum
     * tilt of 25°, so that maximum tilt shifts the horizon by half the radius.
     */
    static final double PITCH_AT_EDGE = 50;

    /**
     * Returns the horizon of a drone whose nose points up by {@code pitchDeg}. The higher the nose,
     * the more sky is visible.
     */
    static Horizon of(double pitchDeg, double radius) {
      double share = Math.max(-1, Math.min(1, pitchDeg / PITCH_AT_EDGE));
      return new Horizon(radius, share * radius);
    }

    /**
     * Returns the start angle of the ground's circular segment, counter-clockwise from the right
     * [deg].
     */
    double groundStartDeg() {
      return 180 + Math.toDegrees(Math.asin(offset / radius));
    }

    /** Returns the extent of the ground's circular segment, counter-clockwise [deg]. */
    double groundExtentDeg() {
      return 180 - 2 * Math.toDegrees(Math.asin(offset / radius));
    }

    /** Returns the position of the pitch ladder's rung for a pitch angle [deg]. */
    double rung(double angleDeg) {
      return offset - angleDeg / PITCH_AT_EDGE * radius;
    }
  }
}
