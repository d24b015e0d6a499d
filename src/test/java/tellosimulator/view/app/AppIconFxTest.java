package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.image.Image;
import javafx.stage.Stage;
import org.junit.jupiter.api.Test;
import org.testfx.framework.junit5.ApplicationTest;

class AppIconFxTest extends ApplicationTest {

  private Stage stage;

  @Override
  public void start(Stage shown) {
    stage = shown;
    AppIcon.show(stage);
  }

  @Test
  void isAPictureForTaskBars() {
    assertThat(stage.getIcons()).hasSize(1);
    Image icon = stage.getIcons().get(0);
    assertThat(icon.isError()).isFalse();
    assertThat(icon.getWidth()).isEqualTo(256);
  }
}
