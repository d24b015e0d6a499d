package tellosimulator.view.controls;

import javafx.scene.control.Label;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.model.ViewContext;

/** Says that time stands still, while it does. Takes no mouse. For the JavaFX thread. */
public final class PauseNotice extends Label {

  public PauseNotice(ViewContext context) {
    setId("pause-notice");
    setGraphic(new FontIcon(Feather.PAUSE));
    setMouseTransparent(true);
    textProperty().bind(context.language().messages(PauseNotice.class).text("paused"));
    visibleProperty().bind(context.simulation().pausedProperty());
    managedProperty().bind(visibleProperty());
  }
}
