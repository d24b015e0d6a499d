package tellosimulator.view.controls;

import java.util.Map;
import java.util.stream.IntStream;
import javafx.scene.Group;
import javafx.scene.shape.Arc;
import javafx.scene.shape.ArcType;
import javafx.scene.shape.Circle;
import javafx.scene.shape.Path;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Polyline;
import javafx.scene.text.Text;
import javafx.scene.transform.Rotate;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Messages;

/**
 * Shows the drone's heading as seen from above. A symbol of the drone turns clockwise as the yaw
 * grows. The top of the dial is the heading at power-on, and an arc shows how far the drone has
 * turned since then. Confined to the JavaFX thread.
 */
final class Compass extends Instrument {

  /** The smallest visible change [deg]. */
  private static final double VISIBLE = 0.5;

  private static final Map<Integer, String> NUMBERS =
      Map.of(0, "0", 90, "90", 180, "180", -90, "\u221290");

  private final Messages messages;
  private final double middle;
  private final double radius;
  private final Group drone;
  private final Rotate turn = new Rotate();
  private final Arc turned = Nodes.styled(new Arc(), "turned");
  private double yawDeg;
  private double drawnYaw;

  /**
   * @param size the width and height [px]
   */
  Compass(Messages messages, double size) {
    super("compass", "compass", size, size);
    this.messages = messages;
    this.middle = size / 2;
    this.radius = size / 2 - 2;
    this.drone = picture(radius * 0.38);
    initializeParts();
    layoutParts();
  }

  private void initializeParts() {
    turned.setCenterX(middle);
    turned.setCenterY(middle);
    turned.setRadiusX(radius);
    turned.setRadiusY(radius);
    turned.setStartAngle(90);
    turned.setType(ArcType.OPEN);
    drone.setLayoutX(middle);
    drone.setLayoutY(middle);
    drone.getTransforms().add(turn);
  }

  private void layoutParts() {
    DialScale dial = new DialScale(middle, radius);
    Circle card = Nodes.styled(new Circle(middle, middle, radius), "card", "bezel");
    Path fine = dial.marks(0.93, IntStream.range(0, 24).mapToDouble(i -> i * 15).toArray());
    Path coarse = dial.marks(0.87, IntStream.range(0, 12).mapToDouble(i -> i * 30).toArray());
    coarse.getStyleClass().add("coarse");
    addShapes(card, fine, coarse, turned);
    NUMBERS.forEach(
        (angle, number) -> {
          Text text = Nodes.styled(new Text(number), "scale-number");
          boolean aside = Math.abs(angle) == 90;
          addShapes(new CenteredText(text, dial.x(angle, aside ? 0.66 : 0.7), dial.y(angle, 0.7)));
        });
    addShapes(drone);
  }

  /**
   * Shows a heading.
   *
   * @param newYawDeg the yaw, clockwise seen from above, within ±180 [deg]
   */
  void show(double newYawDeg) {
    yawDeg = newYawDeg;
    if (Math.abs(yawDeg - drawnYaw) >= VISIBLE) {
      drawnYaw = yawDeg;
      turn.setAngle(drawnYaw);
      turned.setLength(-drawnYaw);
    }
  }

  /**
   * Returns a symbol of a drone seen from above. It is centred at the origin, and its nose points
   * up.
   */
  private static Group picture(double reach) {
    double motor = reach * 0.62;
    Group picture = new Group();
    Polyline arms = new Polyline(-motor, -motor, motor, motor);
    Polyline otherArms = new Polyline(-motor, motor, motor, -motor);
    arms.getStyleClass().add("arm");
    otherArms.getStyleClass().add("arm");
    picture.getChildren().addAll(arms, otherArms);
    for (int i = 0; i < 4; i++) {
      Circle rotor =
          Nodes.styled(
              new Circle(i % 2 == 0 ? -motor : motor, i < 2 ? -motor : motor, reach * 0.36),
              i < 2 ? "front-rotor" : "rotor");
      picture.getChildren().add(rotor);
    }
    double tip = -reach * 1.28;
    Polygon nose =
        Nodes.styled(
            new Polygon(
                0, tip, reach * 0.34, -reach * 0.2, 0, reach * 0.1, -reach * 0.34, -reach * 0.2),
            "nose");
    picture.getChildren().add(nose);
    return picture;
  }

  @Override
  String description() {
    return messages.now("compass.accessible", NumberText.whole(yawDeg));
  }
}
