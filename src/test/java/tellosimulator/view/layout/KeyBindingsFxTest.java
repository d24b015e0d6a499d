package tellosimulator.view.layout;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;

import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.Pane;
import javafx.util.Subscription;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.testfx.api.FxToolkit;

class KeyBindingsFxTest {

  private final AtomicInteger acted = new AtomicInteger();
  private Scene scene;
  private Subscription installed;

  @BeforeEach
  void install() throws TimeoutException {
    FxToolkit.registerPrimaryStage();
    onFxThread(
        () -> {
          scene = new Scene(new Pane());
          installed =
              new KeyBindings()
                  .on(WindowKey.FULL_SCREEN, acted::incrementAndGet)
                  .on(WindowKey.FRONT_VIEW, acted::incrementAndGet)
                  .install(scene);
          return scene;
        });
  }

  @Test
  void aHeldKeyActsOnceHoweverOftenTheSystemRepeatsIt() {
    for (KeyCode code : new KeyCode[] {KeyCode.F11, KeyCode.DIGIT1}) {
      acted.set(0);
      for (int i = 0; i < 5; i++) {
        fire(KeyEvent.KEY_PRESSED, code);
      }
      assertThat(acted).hasValue(1);

      fire(KeyEvent.KEY_RELEASED, code);
      fire(KeyEvent.KEY_PRESSED, code);
      assertThat(acted).hasValue(2);
    }
  }

  @Test
  void otherKeysActWhileOneIsHeld() {
    fire(KeyEvent.KEY_PRESSED, KeyCode.F11);
    fire(KeyEvent.KEY_PRESSED, KeyCode.DIGIT1);

    assertThat(acted).hasValue(2);
  }

  @Test
  void afterTheEndNothingActs() {
    onFxThread(
        () -> {
          installed.unsubscribe();
          return true;
        });

    fire(KeyEvent.KEY_PRESSED, KeyCode.F11);

    assertThat(acted).hasValue(0);
  }

  private void fire(EventType<KeyEvent> type, KeyCode code) {
    onFxThread(
        () -> {
          Event.fireEvent(scene, new KeyEvent(type, "", "", code, false, false, false, false));
          return true;
        });
  }
}
