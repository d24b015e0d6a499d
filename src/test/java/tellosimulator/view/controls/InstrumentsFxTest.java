package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Locale;
import java.util.Map;
import javafx.beans.property.SimpleStringProperty;
import javafx.css.PseudoClass;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.layout.FlowPane;
import javafx.scene.shape.Arc;
import javafx.scene.shape.Polyline;
import javafx.scene.shape.Rectangle;
import javafx.scene.text.Text;
import javafx.stage.Stage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.view.testing.StageExtension;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

@ExtendWith(StageExtension.class)
class InstrumentsFxTest {

  private static final double SIZE = 100;

  private AttitudeIndicator attitude;
  private Compass compass;
  private HeightBar height;
  private BatteryGauge battery;
  private LiveChart chart;

  @Start
  void open(Stage stage) {
    Messages messages = new Language(Locale.ENGLISH).messages(Compass.class);
    attitude = new AttitudeIndicator(messages, SIZE);
    compass = new Compass(messages, SIZE);
    height = new HeightBar(messages, SIZE);
    battery = new BatteryGauge(messages);
    chart = new LiveChart("chart", new SimpleStringProperty("Height cm"), 100);
    stage.setScene(new Scene(new FlowPane(attitude, compass, height, battery, chart), 400, 300));
    stage.show();
  }

  @Test
  void theHorizonSinksWhenTheNoseGoesUpAndTiltsAgainstTheRoll(FxRobot robot) {
    Node horizon = attitude.lookup(".horizon");
    Arc ground = (Arc) attitude.lookup(".ground");
    robot.interact(() -> attitude.show(20, 0));
    assertThat(horizon.getTranslateY()).isPositive();
    assertThat(ground.getLength()).isLessThan(180);

    robot.interact(() -> attitude.show(0, 30));
    Point2D right = inWindow(horizon, SIZE - 2, SIZE / 2);
    Point2D left = inWindow(horizon, 2, SIZE / 2);
    assertThat(right.getY()).isLessThan(left.getY()); // the right side is down: its sky is higher
  }

  @Test
  void theDroneOfTheCompassTurnsClockwise(FxRobot robot) {
    robot.interact(() -> compass.show(90));

    Bounds nose = compass.lookup(".nose").localToScene(compass.lookup(".nose").getLayoutBounds());
    Bounds card = compass.lookup(".card").localToScene(compass.lookup(".card").getLayoutBounds());
    assertThat(nose.getCenterX()).isGreaterThan(card.getCenterX() + 5);
    assertThat(nose.getCenterY()).isCloseTo(card.getCenterY(), within(1.0));
    assertThat(((Arc) compass.lookup(".turned")).getLength()).isEqualTo(-90); // clockwise
  }

  @Test
  void theBarReachesToTheShareOfTheRoom(FxRobot robot) {
    Rectangle filled = (Rectangle) height.lookup(".filled");
    robot.interact(() -> height.show(100, 400));
    double whole = ((Rectangle) height.lookup(".track")).getHeight();
    assertThat(filled.getHeight()).isCloseTo(whole / 4, within(0.5));
    assertThat(height.lookupAll(".scale-number").stream().map(node -> ((Text) node).getText()))
        .containsExactlyInAnyOrder("0", "100", "200", "300", "400");

    robot.interact(() -> height.show(1000, 400));
    assertThat(filled.getHeight()).isEqualTo(whole);
  }

  @Test
  void theBatteryWarnsInSteps(FxRobot robot) {
    robot.interact(() -> battery.show(50));
    assertThat(battery.getPseudoClassStates()).isEmpty();
    Map<Integer, String> steps =
        Map.of(49, "fair", 20, "fair", 19, "low", 11, "low", 10, "critical");
    steps.forEach(
        (percent, look) -> {
          robot.interact(() -> battery.show(percent));
          assertThat(battery.getPseudoClassStates())
              .as("%d %%", percent)
              .containsExactly(PseudoClass.getPseudoClass(look));
          assertThat(((Text) battery.lookup("#battery-percent")).getText())
              .isEqualTo(percent + " %");
        });
  }

  @Test
  void theCurveRunsFromLeftToRightAndUpwards(FxRobot robot) {
    TimeSeries ring = new TimeSeries();
    ring.add(0, 0);
    ring.add(60, 50);
    robot.interact(() -> chart.show(ring, 60));

    Rectangle plot = (Rectangle) chart.lookup(".plot");
    Polyline curve = (Polyline) chart.lookup(".curve");
    assertThat(curve.getPoints()).hasSize(4);
    assertThat(curve.getPoints().get(0)).isEqualTo(plot.getX());
    assertThat(curve.getPoints().get(2)).isEqualTo(plot.getX() + plot.getWidth());
    assertThat(curve.getPoints().get(1)).isGreaterThan(curve.getPoints().get(3));
    assertThat(curve.getPoints().get(3))
        .isCloseTo(plot.getY() + plot.getHeight() / 2, within(1.0)); // 50 of 100
  }

  @Test
  void theScaleOfTheChartGrowsAndShrinks(FxRobot robot) {
    TimeSeries ring = new TimeSeries();
    ring.add(0, 130);
    robot.interact(() -> chart.show(ring, 0));
    assertThat(highest()).isEqualTo("200");

    robot.interact(() -> chart.show(ring, 61));
    assertThat(highest()).isEqualTo("100");
    assertThat(((Polyline) chart.lookup(".curve")).getPoints()).isEmpty();
  }

  private String highest() {
    return chart.lookupAll(".axis-text").stream()
        .map(node -> ((Label) node).getText())
        .findFirst()
        .orElseThrow();
  }

  private static Point2D inWindow(Node node, double x, double y) {
    return node.localToScene(x, y);
  }
}
