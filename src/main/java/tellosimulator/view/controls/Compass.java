package tellosimulator.view.controls;

import java.util.Map;
import java.util.stream.IntStream;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.scene.Group;
import javafx.scene.shape.Arc;
import javafx.scene.shape.ArcType;
import javafx.scene.shape.Circle;
import javafx.scene.shape.Path;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Polyline;
import javafx.scene.text.Text;
import javafx.scene.transform.Rotate;
import tellosimulator.view.text.Messages;

/**
 * The heading, seen from above: the drone's picture turns clockwise with a growing yaw, above is
 * where a drone looks at its start. An arc shows how far it has turned. For the JavaFX thread.
 */
final class Compass extends Instrument {

  /** Changes below this cannot be seen [deg]. */
  private static final double VISIBLE = 0.5;

  private static final Map<Integer, String> NUMBERS =
      Map.of(0, "0", 90, "90", 180, "180", -90, "\u221290");

  private final DoubleProperty yawDeg = new SimpleDoubleProperty(this, "yawDeg");
  private final Messages messages;
  private final double middle;
  private final double radius;
  private final Group drone;
  private final Rotate turn = new Rotate();
  private final Arc turned = new Arc();
  private double drawnYaw;

  /**
   * @param size its width and height [px]
   */
  Compass(Messages messages, double size) {
    super("compass", "compass", size, size);
    this.messages = messages;
    this.middle = size / 2;
    this.radius = size / 2 - 2;
    this.drone = picture(radius * 0.38);
    initializeParts();
    layoutParts();
    setupBindings();
  }

  private void initializeParts() {
    turned.setCenterX(middle);
    turned.setCenterY(middle);
    turned.setRadiusX(radius);
    turned.setRadiusY(radius);
    turned.setStartAngle(90);
    turned.setType(ArcType.OPEN);
    turned.setManaged(false);
    turned.getStyleClass().add("turned");
    drone.setLayoutX(middle);
    drone.setLayoutY(middle);
    drone.setManaged(false);
    drone.getTransforms().add(turn);
  }

  private void layoutParts() {
    DialScale dial = new DialScale(middle, radius);
    Circle card = new Circle(middle, middle, radius);
    card.getStyleClass().addAll("card", "bezel");
    card.setManaged(false);
    Path fine = dial.marks(0.93, IntStream.range(0, 24).mapToDouble(i -> i * 15).toArray());
    Path coarse = dial.marks(0.87, IntStream.range(0, 12).mapToDouble(i -> i * 30).toArray());
    coarse.getStyleClass().add("coarse");
    fine.setManaged(false);
    coarse.setManaged(false);
    getChildren().addAll(card, fine, coarse, turned);
    NUMBERS.forEach(
        (angle, number) -> {
          Text text = new Text(number);
          text.getStyleClass().add("scale-number");
          boolean aside = Math.abs(angle) == 90;
          getChildren()
              .add(new CenteredText(text, dial.x(angle, aside ? 0.66 : 0.7), dial.y(angle, 0.7)));
        });
    getChildren().add(drone);
  }

  private void setupBindings() {
    yawDeg.addListener((property, before, now) -> draw());
  }

  /** Clockwise seen from above, within ±180 [deg]. */
  DoubleProperty yawDegProperty() {
    return yawDeg;
  }

  private void draw() {
    if (Math.abs(yawDeg.get() - drawnYaw) >= VISIBLE) {
      drawnYaw = yawDeg.get();
      turn.setAngle(drawnYaw);
      turned.setLength(-drawnYaw);
    }
  }

  /** A drone seen from above whose nose points up, around the origin. */
  private static Group picture(double reach) {
    double motor = reach * 0.62;
    Group picture = new Group();
    Polyline arms = new Polyline(-motor, -motor, motor, motor);
    Polyline otherArms = new Polyline(-motor, motor, motor, -motor);
    arms.getStyleClass().add("arm");
    otherArms.getStyleClass().add("arm");
    picture.getChildren().addAll(arms, otherArms);
    for (int i = 0; i < 4; i++) {
      Circle rotor = new Circle(i % 2 == 0 ? -motor : motor, i < 2 ? -motor : motor, reach * 0.36);
      rotor.getStyleClass().add(i < 2 ? "front-rotor" : "rotor");
      picture.getChildren().add(rotor);
    }
    double tip = -reach * 1.28;
    Polygon nose =
        new Polygon(
            0, tip, reach * 0.34, -reach * 0.2, 0, reach * 0.1, -reach * 0.34, -reach * 0.2);
    nose.getStyleClass().add("nose");
    picture.getChildren().add(nose);
    return picture;
  }

  @Override
  String description() {
    return messages.now("compass.accessible", NumberText.whole(yawDeg.get()));
  }
}
