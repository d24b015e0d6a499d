package tellosimulator.view.controls;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javafx.beans.binding.Bindings;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.scene.control.Button;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.layout.HBox;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultText;
import tellosimulator.fault.FaultTextException;
import tellosimulator.fault.LinkPreset;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.words.Phrase;

/**
 * The panel for faults: the link quality, a one-line field for adding a fault, and the faults that
 * affect the selected drone. Confined to the JavaFX thread.
 */
final class FaultPanel extends Card {

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final ChoiceBox<LinkPreset> link = Nodes.named(new ChoiceBox<>(), "link-preset");
  private final TextField text = Nodes.named(new TextField(), "fault-text");
  private final Label diagnostic = Nodes.sentence("fault-error", "sentence", "danger");
  private final Label running = Nodes.sentence("faults-running", "sentence", "warning");
  private final ObjectProperty<Optional<Phrase>> wrong =
      new SimpleObjectProperty<>(Optional.empty());

  FaultPanel(ViewContext context) {
    super("faults", context.language().messages(FaultPanel.class).text("faults.heading"));
    simulation = context.simulation();
    actions = context.actions();
    Messages messages = context.language().messages(FaultPanel.class);
    initializeParts(messages, context.language());
    setupEventHandlers();
    context.ticker().onTick(nanos -> refresh());
    refresh();
  }

  private void initializeParts(Messages messages, Language language) {
    link.getItems().setAll(LinkPreset.values());
    Nodes.nameItems(
        link, language.localeProperty(), preset -> messages.now("faults.link." + preset.option()));
    Nodes.growing(link);
    Tooltips.install(link, messages.text("faults.link.hint"));
    link.accessibleTextProperty().bind(messages.text("faults.link"));
    text.promptTextProperty().bind(messages.text("faults.text.prompt"));
    Tooltips.install(text, messages.text("faults.text.hint"));
    text.accessibleTextProperty().bind(messages.text("faults.text"));
    diagnostic
        .textProperty()
        .bind(
            Bindings.createStringBinding(
                () -> wrong.get().map(language::say).orElse(""), wrong, language.localeProperty()));
    List.of(diagnostic, running).forEach(label -> label.setMaxWidth(Double.MAX_VALUE));
    Button clear = Nodes.named(new Button(), "fault-clear");
    clear.textProperty().bind(messages.text("faults.clear"));
    clear.setOnAction(pressed -> actions.carryOut(new Control.ClearFaults()));
    Tooltips.install(clear, messages.text("faults.clear.hint"));
    layoutCard(Nodes.styled(new HBox(link, clear), "fault-row"), text, diagnostic, running);
  }

  private void setupEventHandlers() {
    text.setOnAction(entered -> inject());
    text.textProperty().addListener(typed -> wrong.set(Optional.empty()));
    link.setOnAction(
        chosen -> {
          if (link.getValue() != acting().link()) {
            actions.carryOut(new Control.SetLink(link.getValue()));
          }
        });
  }

  private void inject() {
    try {
      Fault fault = FaultText.read(text.getText());
      int drones = simulation.drones().size();
      int drone = fault.target().drone().orElse(1);
      if (drone > drones) {
        throw new FaultTextException(
            Phrase.of("there is no drone %d, the drones are 1 to %d", drone, drones));
      }
      actions.carryOut(new Control.InjectFault(fault));
      text.clear();
    } catch (FaultTextException e) {
      wrong.set(Optional.of(e.phrase()));
    }
  }

  private void refresh() {
    if (!actions.pending() && !link.isShowing()) {
      link.setValue(acting().link());
    }
    running.setText(acting().faults().stream().map(Fault::text).collect(Collectors.joining("\n")));
  }

  private ActiveFaults acting() {
    return simulation.selectedProperty().get().snapshotProperty().get().faults();
  }
}
