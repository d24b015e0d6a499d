package tellosimulator.view.controls;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.geometry.Orientation;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import tellosimulator.sim.LastCommand.Outcome;
import tellosimulator.sim.LastCommand.Shown;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * A row that shows the latest command to any drone and its outcome. The row is invisible before the
 * first command, and ignores the mouse. Confined to the JavaFX thread.
 */
public final class LastCommandRow extends HBox {

  private static final PseudoClass REACHED = PseudoClass.getPseudoClass("reached");
  private static final PseudoClass FAILED = PseudoClass.getPseudoClass("failed");

  /**
   * Time without commands after which the age of the last one is shown [simulated s]. Decided:
   * longer than the usual pauses of a program.
   */
  private static final double SILENCE = 20;

  private final ViewContext context;
  private final Language language;
  private final Messages messages;
  private final Label command = new Label();
  private final Label outcome = new Label();
  private final Label reason = new Label();
  private final Label heard = new Label();

  /**
   * @param id the id of the row; the ids of its labels are this id followed by {@code -text},
   *     {@code -outcome}, {@code -reason} and {@code -heard}
   * @param explanation where the reason for a failure is shown: beside the other labels if
   *     horizontal, below them if vertical
   */
  public LastCommandRow(ViewContext context, String id, Orientation explanation) {
    this.context = context;
    language = context.language();
    messages = language.messages(LastCommandRow.class);
    Nodes.named(this, id, "last-command");
    setMouseTransparent(true);
    Nodes.collapsible(this);
    Nodes.named(command, id + "-text", "command");
    Nodes.named(Nodes.unshrinkable(outcome), id + "-outcome", "outcome");
    Nodes.named(reason, id + "-reason", "reason");
    reason.setMinWidth(0);
    Nodes.named(Nodes.unshrinkable(heard), id + "-heard", "reason");
    heard.managedProperty().bind(heard.textProperty().isNotEmpty());
    if (explanation == Orientation.HORIZONTAL) {
      getChildren().addAll(command, outcome, reason, heard);
    } else {
      reason.setWrapText(true);
      HBox said = Nodes.styled(new HBox(command, outcome, heard), "said");
      getChildren().add(new VBox(said, reason));
    }
    show(Optional.empty());
    context.ticker().onTick(nanos -> show(context.lastCommand().newest()));
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

  /**
   * Formats the time since the last command. The steps are coarse, so that an idle window is seldom
   * redrawn.
   */
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
