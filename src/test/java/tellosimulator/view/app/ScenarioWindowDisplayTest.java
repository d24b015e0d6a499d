package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.util.concurrent.atomic.AtomicBoolean;
import javafx.geometry.Dimension2D;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.image.Image;
import javafx.scene.input.KeyCode;
import javafx.scene.paint.Color;
import javafx.stage.Screen;
import javafx.stage.Stage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.testfx.api.FxRobot;
import tellosimulator.view.testing.NeedsDisplay;

/** Scenarios opened in a window that its manager has maximised. */
@NeedsDisplay
class ScenarioWindowDisplayTest {

  @RegisterExtension
  final AppFixture window = new AppFixture(ScenarioWindowDisplayTest::smallStage);

  private final FxRobot robot = window.robot();
  private SimulatorApp app;
  private Stage stage;

  private static Stage smallStage() {
    Stage stage = new Stage();
    stage.setWidth(900);
    stage.setHeight(600);
    return stage;
  }

  @BeforeEach
  void open() {
    app = window.app();
    stage = window.stage();
    waitUntil(() -> stage.isFocused());
  }

  @Test
  void anotherScenarioFillsAMaximizedWindow() {
    change(() -> stage.setMaximized(true));
    waitUntil(() -> stage.getScene().getWidth() > 1000);
    Scene scene = onFxThread(stage::getScene);
    Dimension2D before = onFxThread(() -> size(stage.getScene()));

    change(() -> app.openKnown("slalom"));

    waitUntil(() -> stage.getTitle().startsWith("Slalom") && stage.isMaximized());
    assertThat(onFxThread(() -> size(stage.getScene()))).isEqualTo(before);
    waitUntil(() -> find("window-bar").getLayoutBounds().getWidth() == before.getWidth());
    waitUntil(() -> !black(corner(0, 0)) && !black(corner(1, 0)) && !black(corner(0, 1)));

    robot.clickOn("#show-network");

    waitUntil(() -> !find("network-controls").isVisible());
    // if the user maximises the window, another scene would be in a corner of a black window
    assertThat(onFxThread(stage::getScene)).isSameAs(scene);
  }

  @Test
  void inFullScreenAnotherScenarioAndAReloadStayThere() {
    robot.type(KeyCode.F11);
    waitUntil(this::fillsScreen);
    AtomicBoolean left = new AtomicBoolean();
    change(() -> stage.fullScreenProperty().subscribe(full -> left.compareAndSet(false, !full)));

    change(() -> app.openKnown("slalom"));
    waitUntil(() -> stage.getTitle().startsWith("Slalom") && fillsScreen());
    change(app::reload);
    waitUntil(this::fillsScreen);

    assertThat(left).isFalse();
    robot.type(KeyCode.F11);
    waitUntil(() -> !stage.isFullScreen());
  }

  private boolean fillsScreen() {
    Rectangle2D screen = Screen.getPrimary().getBounds();
    return stage.isFullScreen()
        && find("scene-3d").getLayoutBounds().getWidth() == screen.getWidth()
        && find("scene-3d").getLayoutBounds().getHeight() == screen.getHeight();
  }

  private Node find(String id) {
    return stage.getScene().lookup("#" + id);
  }

  private static Dimension2D size(Scene scene) {
    return new Dimension2D(scene.getWidth(), scene.getHeight());
  }

  /** Returns the colour on the screen just inside a corner of the window; 0 is left or top. */
  private Color corner(int across, int down) {
    Scene scene = stage.getScene();
    double left = stage.getX() + scene.getX();
    double top = stage.getY() + scene.getY();
    double x = left + 2 + across * (scene.getWidth() - 5);
    double y = top + 2 + down * (scene.getHeight() - 5);
    Image pixel = robot.capture(new Rectangle2D(Math.floor(x), Math.floor(y), 1, 1)).getImage();
    return pixel.getPixelReader().getColor(0, 0);
  }

  private static boolean black(Color color) {
    return color.getBrightness() < 0.2;
  }
}
