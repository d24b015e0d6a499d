package tellosimulator.view.controls;

import java.util.function.Supplier;
import javafx.animation.PauseTransition;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import javafx.util.Duration;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;

/**
 * Copies a text to the clipboard and briefly shows a confirmation. Confined to the JavaFX thread.
 */
public final class CopyButton extends Button {

  /** The time for which the confirmation is shown [s]. */
  private static final double THANKS = 1.5;

  private final PauseTransition thanks = new PauseTransition(Duration.seconds(THANKS));

  /**
   * @param hint a description of the text, used as the tooltip and by screen readers
   * @param copied returns the text; called when the button is pressed
   */
  public CopyButton(ObservableValue<String> hint, Supplier<String> copied) {
    setGraphic(new FontIcon(Feather.COPY));
    accessibleTextProperty().bind(hint);
    Tooltips.install(this, hint);
    setOnAction(pressed -> copy(copied.get()));
    thanks.setOnFinished(over -> setGraphic(new FontIcon(Feather.COPY)));
  }

  private void copy(String text) {
    ClipboardContent content = new ClipboardContent();
    content.putString(text);
    Clipboard.getSystemClipboard().setContent(content);
    setGraphic(new FontIcon(Feather.CHECK));
    thanks.playFromStart();
  }
}
