package tellosimulator.view.controls;

import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * The switch that lets other machines of the network reach the drones, with a sentence that says
 * what it opens. For the JavaFX thread.
 */
final class ReachPanel extends VBox {

  private final SimulatorActions actions;
  private final Runnable changed;
  private final CheckBox reachable = new CheckBox();
  private final Label sentence = new Label();

  /**
   * @param changed is called when a person has used the switch
   */
  ReachPanel(ViewContext context, Runnable changed) {
    this.actions = context.actions();
    this.changed = changed;
    Messages messages = context.language().messages(ReachPanel.class);
    reachable.setId("reachable");
    reachable.textProperty().bind(messages.text("reach"));
    sentence.setId("reach-sentence");
    sentence.getStyleClass().add("caption");
    sentence.setWrapText(true);
    sentence.setMinHeight(USE_PREF_SIZE);
    sentence
        .textProperty()
        .bind(
            reachable
                .selectedProperty()
                .flatMap(on -> messages.text(on ? "reach.open" : "reach.closed")));
    Tooltips.install(this, messages.text("reach.hint"));
    reachable.accessibleHelpProperty().bind(messages.text("reach.hint"));
    getChildren().addAll(reachable, sentence);
    reachable.setOnAction(pressed -> use());
    refresh();
  }

  private void use() {
    actions.setReachableFromNetwork(reachable.isSelected(), changed);
  }

  /** Shows what holds now. */
  void refresh() {
    reachable.setSelected(actions.reachableFromNetwork());
  }
}
