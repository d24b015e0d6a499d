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
import javafx.scene.layout.Priority;
import javafx.util.StringConverter;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultText;
import tellosimulator.fault.FaultTextException;
import tellosimulator.fault.LinkPreset;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.words.Phrase;

/**
 * What goes wrong: how good the link is, a field for a fault in a line, and the faults that act on
 * the selected drone. For the JavaFX thread.
 */
final class FaultPanel extends Card {

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final ChoiceBox<LinkPreset> link = new ChoiceBox<>();
  private final TextField text = new TextField();
  private final Label diagnostic = new Label();
  private final Label running = new Label();
  private final Button clear = new Button();
  private final ObjectProperty<Optional<Phrase>> wrong =
      new SimpleObjectProperty<>(Optional.empty());

  FaultPanel(ViewContext context) {
    super("faults", context.language().messages(FaultPanel.class).text("faults.heading"));
    simulation = context.simulation();
    actions = context.actions();
    Messages messages = context.language().messages(FaultPanel.class);
    initializeParts(messages, context.language());
    layoutParts();
    setupEventHandlers();
    context.pulse().onBeat(nanos -> refresh());
    refresh();
  }

  private void initializeParts(Messages messages, Language language) {
    link.setId("link-preset");
    link.getItems().setAll(LinkPreset.values());
    language.localeProperty().subscribe(locale -> link.setConverter(new PresetNames(messages)));
    link.setMaxWidth(Double.MAX_VALUE);
    Tooltips.install(link, messages.text("faults.link.hint"));
    link.accessibleTextProperty().bind(messages.text("faults.link"));
    text.setId("fault-text");
    text.promptTextProperty().bind(messages.text("faults.text.prompt"));
    Tooltips.install(text, messages.text("faults.text.hint"));
    text.accessibleTextProperty().bind(messages.text("faults.text"));
    diagnostic.setId("fault-error");
    diagnostic.getStyleClass().addAll("sentence", "danger");
    diagnostic
        .textProperty()
        .bind(
            Bindings.createStringBinding(
                () -> wrong.get().map(language::say).orElse(""), wrong, language.localeProperty()));
    running.setId("faults-running");
    running.getStyleClass().addAll("sentence", "warning");
    for (Label label : List.of(diagnostic, running)) {
      label.setWrapText(true);
      label.setMaxWidth(Double.MAX_VALUE);
      label.setMinHeight(USE_PREF_SIZE);
      label.visibleProperty().bind(label.textProperty().isNotEmpty());
      label.managedProperty().bind(label.visibleProperty());
    }
    clear.setId("fault-clear");
    clear.textProperty().bind(messages.text("faults.clear"));
    Tooltips.install(clear, messages.text("faults.clear.hint"));
  }

  private void layoutParts() {
    HBox.setHgrow(link, Priority.ALWAYS);
    HBox row = new HBox(link, clear);
    row.getStyleClass().add("fault-row");
    layoutCard(row, text, diagnostic, running);
  }

  private void setupEventHandlers() {
    text.setOnAction(entered -> inject());
    text.textProperty().addListener(typed -> wrong.set(Optional.empty()));
    clear.setOnAction(pressed -> actions.carryOut(new Control.ClearFaults()));
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

  /** The names of the presets in the present language. */
  private static final class PresetNames extends StringConverter<LinkPreset> {

    private final Messages messages;

    PresetNames(Messages messages) {
      this.messages = messages;
    }

    @Override
    public String toString(LinkPreset preset) {
      return preset == null ? "" : messages.now("faults.link." + preset.option());
    }

    @Override
    public LinkPreset fromString(String word) {
      throw new UnsupportedOperationException("nobody types a preset");
    }
  }
}
