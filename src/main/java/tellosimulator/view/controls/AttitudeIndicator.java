package tellosimulator.view.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.scene.Group;
import javafx.scene.shape.Arc;
import javafx.scene.shape.ArcType;
import javafx.scene.shape.Circle;
import javafx.scene.shape.Line;
import javafx.scene.shape.Path;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Polyline;
import javafx.scene.transform.Rotate;
import tellosimulator.view.text.Messages;

/**
 * An artificial horizon: sky and ground as the drone sees them, a pitch ladder with a rung each 10
 * degrees, and a roll scale. For the JavaFX thread.
 */
final class AttitudeIndicator extends Instrument {

  /** Changes below this cannot be seen [deg]. */
  private static final double VISIBLE = 0.25;

  private static final int RUNG_STEP = 10;
  private static final int HIGHEST_RUNG = 40;

  /** Roll angles of the scale at the rim [deg]. */
  private static final double[] ROLL_MARKS = {-60, -30, -15, 0, 15, 30, 60};

  private record Rung(int angleDeg, Line line) {}

  private final DoubleProperty pitchDeg = new SimpleDoubleProperty(this, "pitchDeg");
  private final DoubleProperty rollDeg = new SimpleDoubleProperty(this, "rollDeg");
  private final Messages messages;
  private final double middle;
  private final double radius;
  private final Rotate bank = new Rotate();
  private final Arc ground = new Arc();
  private final Line horizon;
  private final List<Rung> rungs = new ArrayList<>();
  private double drawnPitch = Double.NaN;

  /**
   * @param size its width and height [px]
   */
  AttitudeIndicator(Messages messages, double size) {
    super("attitude", "attitude-indicator", size, size);
    this.messages = messages;
    this.middle = size / 2;
    this.radius = size / 2 - 2;
    this.horizon = line(radius, "horizon");
    initializeParts();
    layoutParts();
    setupBindings();
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
    ground.getStyleClass().add("ground");
    for (int angle = -HIGHEST_RUNG; angle <= HIGHEST_RUNG; angle += RUNG_STEP) {
      if (angle != 0) {
        boolean even = angle % (2 * RUNG_STEP) == 0;
        rungs.add(new Rung(angle, line(radius * (even ? 0.34 : 0.18), "rung")));
      }
    }
  }

  private void layoutParts() {
    Circle sky = new Circle(middle, middle, radius);
    sky.getStyleClass().add("sky");
    Path marks = new DialScale(middle, radius).marks(0.86, ROLL_MARKS);
    Group world = new Group(sky, ground, horizon, marks);
    rungs.forEach(rung -> world.getChildren().add(rung.line()));
    world.getTransforms().add(bank);
    world.setManaged(false);

    double wing = radius * 0.52;
    double gap = radius * 0.2;
    Polyline left = new Polyline(-wing, 0, -gap, 0, -gap, gap * 0.6);
    Polyline right = new Polyline(wing, 0, gap, 0, gap, gap * 0.6);
    Circle nose = new Circle(0, 0, 2);
    Polygon index = new Polygon(0, -radius * 0.84, -4, -radius * 0.84 + 7, 4, -radius * 0.84 + 7);
    Circle bezel = new Circle(0, 0, radius);
    List.of(left, right).forEach(part -> part.getStyleClass().add("wing"));
    List.of(nose, index).forEach(part -> part.getStyleClass().add("symbol"));
    bezel.getStyleClass().add("bezel");
    Group frame = new Group(left, right, nose, index, bezel);
    frame.setLayoutX(middle);
    frame.setLayoutY(middle);
    frame.setManaged(false);
    getChildren().addAll(world, frame);
  }

  private void setupBindings() {
    pitchDeg.addListener((property, before, now) -> drawPitch());
    rollDeg.addListener((property, before, now) -> drawRoll());
  }

  /** Nose up is positive [deg]. */
  DoubleProperty pitchDegProperty() {
    return pitchDeg;
  }

  /** Right side down is positive [deg]. */
  DoubleProperty rollDegProperty() {
    return rollDeg;
  }

  private void drawPitch() {
    double pitch = pitchDeg.get();
    if (Math.abs(pitch - drawnPitch) < VISIBLE) {
      return;
    }
    drawnPitch = pitch;
    Horizon geometry = Horizon.of(pitch, radius);
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

  private void drawRoll() {
    if (Math.abs(-rollDeg.get() - bank.getAngle()) >= VISIBLE) {
      bank.setAngle(-rollDeg.get());
    }
  }

  private Line line(double half, String styleClass) {
    Line line = new Line(middle - half, middle, middle + half, middle);
    line.getStyleClass().add(styleClass);
    return line;
  }

  @Override
  String description() {
    return messages.now(
        "attitude.accessible", NumberText.whole(pitchDeg.get()), NumberText.whole(rollDeg.get()));
  }
}
