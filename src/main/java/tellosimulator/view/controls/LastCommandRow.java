package tellosimulator.view.controls;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.geometry.Orientation;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import tellosimulator.view.model.LastCommand.Outcome;
import tellosimulator.view.model.LastCommand.Shown;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The command that the drones were told last, and what became of it. Not there before the first
 * one. Takes no mouse. For the JavaFX thread.
 */
public final class LastCommandRow extends HBox {

  private static final PseudoClass REACHED = PseudoClass.getPseudoClass("reached");
  private static final PseudoClass FAILED = PseudoClass.getPseudoClass("failed");

  /** Silence after which it is said how old the command is [s]. Decided: no pause of a program. */
  private static final double SILENCE = 20;

  private final ViewContext context;
  private final Language language;
  private final Messages messages;
  private final Label command = new Label();
  private final Label outcome = new Label();
  private final Label reason = new Label();
  private final Label heard = new Label();

  /**
   * @param id that of the row; its labels have it with {@code -text}, {@code -outcome} and {@code
   *     -reason}
   * @param explanation where it says why a command failed: beside the rest, or below it
   */
  public LastCommandRow(ViewContext context, String id, Orientation explanation) {
    this.context = context;
    language = context.language();
    messages = language.messages(LastCommandRow.class);
    setId(id);
    getStyleClass().add("last-command");
    setMouseTransparent(true);
    managedProperty().bind(visibleProperty());
    command.setId(id + "-text");
    command.getStyleClass().add("command");
    outcome.setId(id + "-outcome");
    outcome.getStyleClass().add("outcome");
    outcome.setMinWidth(USE_PREF_SIZE);
    reason.setId(id + "-reason");
    reason.getStyleClass().add("reason");
    reason.setMinWidth(0);
    heard.setId(id + "-heard");
    heard.getStyleClass().add("reason");
    heard.setMinWidth(USE_PREF_SIZE);
    heard.managedProperty().bind(heard.textProperty().isNotEmpty());
    if (explanation == Orientation.HORIZONTAL) {
      getChildren().addAll(command, outcome, reason, heard);
    } else {
      reason.setWrapText(true);
      HBox said = new HBox(command, outcome, heard);
      said.getStyleClass().add("said");
      getChildren().add(new VBox(said, reason));
    }
    show(Optional.empty());
    context.pulse().onBeat(nanos -> show(context.lastCommand().newest()));
  }

  private void show(Optional<Shown> newest) {
    setVisible(newest.isPresent());
    newest.ifPresent(this::show);
  }

  private void show(Shown shown) {
    boolean several = context.simulation().drones().size() > 1;
    String who = several ? messages.now("last-command.drone", shown.drone()) + "  " : "";
    command.setText(who + shown.text());
    outcome.setText(outcome(shown));
    outcome.pseudoClassStateChanged(REACHED, shown.outcome() == Outcome.DONE);
    outcome.pseudoClassStateChanged(FAILED, shown.outcome() == Outcome.FAILED);
    reason.setText(shown.reason().map(language::say).orElse(""));
    reason.setManaged(shown.reason().isPresent());
    heard.setText(
        heard(context.lastCommand().silence(context.simulation().secondsProperty().get())));
  }

  /** How long ago something was heard, in steps in which an idle window need not be drawn often. */
  private String heard(double silence) {
    if (silence < SILENCE) {
      return "";
    }
    int seconds = (int) silence;
    return seconds < 60
        ? messages.now("last-command.heard-seconds", seconds / 10 * 10)
        : messages.now("last-command.heard-minutes", seconds / 60);
  }

  private String outcome(Shown shown) {
    return switch (shown.outcome()) {
      case RUNNING -> "…";
      case DONE -> shown.reply();
      case FAILED ->
          shown.reply().isEmpty() ? messages.now("last-command.no-answer") : shown.reply();
    };
  }
}
