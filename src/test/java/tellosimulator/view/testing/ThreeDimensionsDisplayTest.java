package tellosimulator.view.testing;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.Group;
import javafx.scene.PerspectiveCamera;
import javafx.scene.SceneAntialiasing;
import javafx.scene.SubScene;
import javafx.scene.image.WritableImage;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.Box;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import tellosimulator.view.model.ViewContext;

/** The display draws solids, which all tests of the 3D scene stand on. */
@NeedsDisplay
class ThreeDimensionsDisplayTest {

  @RegisterExtension final WindowFixture window = new WindowFixture(this::build);

  @Test
  void aRedBoxIsRedInTheMiddleAndNowhereElse() {
    WritableImage picture =
        WindowFixture.onFxThread(() -> window.stage().getScene().snapshot(null));

    Color middle = picture.getPixelReader().getColor(100, 100);
    Color corner = picture.getPixelReader().getColor(5, 5);
    assertThat(middle.getRed()).isGreaterThan(0.5);
    assertThat(middle.getBlue()).isLessThan(0.2);
    assertThat(corner).isEqualTo(Color.BLUE);
  }

  private StackPane build(ViewContext context) {
    Box box = new Box(1, 1, 1);
    box.setMaterial(new PhongMaterial(Color.RED));
    box.setTranslateZ(5);
    SubScene scene = new SubScene(new Group(box), 200, 200, true, SceneAntialiasing.DISABLED);
    scene.setCamera(new PerspectiveCamera(true));
    scene.setFill(Color.BLUE);
    return new StackPane(scene);
  }
}
