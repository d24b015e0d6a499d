package tellosimulator.view.controls;

import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.network.Silence;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Says once where the selected drone listens, if it is on and nothing comes to it; goes away when
 * something does. For the JavaFX thread.
 */
public final class ContactHint extends HBox {

  private final ViewContext context;
  private final Messages messages;
  private final Label sentence = new Label();
  private final Button close = new Button("", new FontIcon(Feather.X));
  private Silence reason = Silence.NOTHING_CAME;

  /**
   * @param log takes the sentence, too
   */
  public ContactHint(ViewContext context, Consumer<Function<Language, String>> log) {
    this.context = context;
    messages = context.language().messages(ContactHint.class);
    initializeSelf();
    initializeParts();
    getChildren().addAll(new FontIcon(Feather.INFO), sentence, close);
    close.setOnAction(pressed -> show(false));
    context.actions().onSilence(silence -> hint(silence, log));
    context.pulse().onBeat(nanos -> hideWhenHeard());
  }

  private void initializeSelf() {
    setId("contact-hint");
    getStyleClass().add("contact-hint");
    getStylesheets().add(ContactHint.class.getResource("controls.css").toExternalForm());
    show(false);
  }

  private void initializeParts() {
    sentence.setId("contact-hint-text");
    sentence.setWrapText(true);
    sentence.setMaxWidth(Double.MAX_VALUE);
    sentence.setMinHeight(USE_PREF_SIZE);
    HBox.setHgrow(sentence, Priority.ALWAYS);
    close.setId("contact-hint-close");
    close.getStyleClass().add("icon-button");
    Tooltips.install(close, messages.text("contact.close"));
    close.accessibleTextProperty().bind(messages.text("contact.close"));
  }

  private void hint(Silence silence, Consumer<Function<Language, String>> log) {
    int drone = context.simulation().selected().number();
    InetSocketAddress first = context.actions().addresses(drone).get(0);
    String place = first.getAddress().getHostAddress() + ":" + first.getPort();
    String key = "contact." + silence.name().toLowerCase(Locale.ROOT).replace('_', '-');
    sentence.textProperty().bind(messages.text(key, drone, place));
    log.accept(language -> language.messages(ContactHint.class).now(key, drone, place));
    reason = silence;
    show(true);
  }

  private void hideWhenHeard() {
    if (isVisible() && context.simulation().drones().stream().anyMatch(this::isOver)) {
      show(false);
    }
  }

  private boolean isOver(FxDroneModel drone) {
    return reason == Silence.VIDEO_NOT_ASKED
        ? drone.snapshotProperty().get().state().video().on()
        : context.actions().traffic(drone.number()).received() > 0;
  }

  private void show(boolean shown) {
    setVisible(shown);
    setManaged(shown);
  }
}
