package tellosimulator.view.controls;

import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.network.Silence;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * A hint with the address of the selected drone. It appears when a {@link Silence} is reported, and
 * disappears once a drone receives a datagram or, if the report was about video, sends video.
 * Confined to the JavaFX thread.
 */
public final class ContactHint extends HBox {

  private final ViewContext context;
  private final Messages messages;
  private final Label sentence = Nodes.named(new Label(), "contact-hint-text");
  private Silence reason = Silence.NOTHING_CAME;

  /**
   * @param log receives the hint, too
   */
  public ContactHint(ViewContext context, Consumer<Function<Language, String>> log) {
    this.context = context;
    messages = context.language().messages(ContactHint.class);
    Nodes.named(this, "contact-hint", "contact-hint");
    getStylesheets().add(ContactHint.class.getResource("controls.css").toExternalForm());
    show(false);
    Nodes.growing(Nodes.wrapping(sentence));
    Button close =
        Nodes.iconButton("contact-hint-close", Feather.X, messages.text("contact.close"));
    getChildren().addAll(new FontIcon(Feather.INFO), sentence, close);
    close.setOnAction(pressed -> show(false));
    context.actions().onSilence(silence -> hint(silence, log));
    context.ticker().onTick(nanos -> hideWhenHeard());
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
    Nodes.setShown(this, shown);
  }
}
