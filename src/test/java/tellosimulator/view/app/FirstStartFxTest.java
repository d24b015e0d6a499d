package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;

import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** The first start, without any settings, and the second one. */
class FirstStartFxTest {

  @RegisterExtension
  final AppFixture window =
      new AppFixture(() -> new Stage(StageStyle.UNDECORATED)).beginningWithGallery();

  @Test
  void theFirstStartShowsTheGalleryAndTheSecondDoesNot() {
    assertThat(shown()).isTrue();

    change(() -> window.stage().hide());
    window.startAgain();

    assertThat(shown()).isFalse();
  }

  private boolean shown() {
    return window.robot().lookup("#page-overlay").query().isVisible()
        && window.robot().lookup("#gallery-page").tryQuery().isPresent();
  }
}
