package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.view.testing.StageExtension;

@ExtendWith(StageExtension.class)
class ChartPanelFxTest {

  private PanelWindow window;
  private ChartPanel panel;

  @Start
  void open(Stage stage) {
    window =
        PanelWindow.open(
            stage,
            1,
            context -> {
              panel = new ChartPanel(context);
              panel.foldingProperty().set(Card.Folding.OPEN);
              return new VBox(panel);
            });
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void whereThereIsRoomTheyAreBelowEachOtherAndTheChargeHasLeast(FxRobot robot) {
    setHeight(robot, 380);

    window.until(() -> bounds("#speed-chart").getMinY() > bounds("#height-chart").getMaxY());
    assertThat(bounds("#battery-chart").getMinY()).isGreaterThan(bounds("#speed-chart").getMaxY());
    assertThat(bounds("#battery-chart").getHeight()).isEqualTo(64);
    assertThat(bounds("#height-chart").getHeight())
        .isEqualTo(bounds("#speed-chart").getHeight())
        .isGreaterThan(80);
  }

  @Test
  void elseTheyAreBesideEachOther(FxRobot robot) {
    setHeight(robot, 150);

    window.until(() -> bounds("#speed-chart").getMinX() > bounds("#height-chart").getMaxX());
    assertThat(bounds("#battery-chart").getMinX()).isGreaterThan(bounds("#speed-chart").getMaxX());
    assertThat(bounds("#battery-chart").getMinY()).isEqualTo(bounds("#height-chart").getMinY());
  }

  private void setHeight(FxRobot robot, double height) {
    robot.interact(
        () -> {
          panel.setMinHeight(height);
          panel.setMaxHeight(height);
        });
  }

  private Bounds bounds(String id) {
    Node chart = panel.lookup(id);
    return chart.localToScene(chart.getLayoutBounds());
  }
}
