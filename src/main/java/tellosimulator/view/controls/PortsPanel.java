package tellosimulator.view.controls;

import atlantafx.base.theme.Styles;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Where the selected drone takes commands, and where its state and video go; the ports can be
 * changed while it is off. For the JavaFX thread.
 */
final class PortsPanel extends Card {

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final Runnable changed;
  private final AddressList addresses;
  private final ReachPanel reach;
  private final NumberField command;
  private final NumberField state;
  private final NumberField video;
  private final MessageLabel warning;

  /**
   * @param changed is called when a person has chosen another port
   */
  PortsPanel(ViewContext context, Runnable changed) {
    super("ports", context.language().messages(PortsPanel.class).text("heading.send"));
    this.simulation = context.simulation();
    this.actions = context.actions();
    this.changed = changed;
    Language language = context.language();
    messages = language.messages(PortsPanel.class);
    addresses = new AddressList(messages);
    reach = new ReachPanel(context, changed);
    command = new NumberField("command-port", PortRules.PORTS, language);
    state = new NumberField("state-port", PortRules.PORTS, language);
    video = new NumberField("video-port", PortRules.PORTS, language);
    warning = new MessageLabel(messages, "port-warning", Styles.WARNING);
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
    refresh();
  }

  private void initializeParts() {
    command.setRule(port -> PortRules.command(port, addresses(drone()), addressesOfOthers()));
    state.setRule(port -> PortRules.streamPort(port, (int) video.number()));
    video.setRule(port -> PortRules.streamPort(port, (int) state.number()));
  }

  private void layoutParts() {
    layoutCard(
        addresses,
        reach,
        row("command-port", command),
        command.error(),
        warning,
        messages.label("heading.listen", "heading"),
        row("state-port", state),
        state.error(),
        row("video-port", video),
        video.error());
  }

  private void setupEventHandlers() {
    command.onNumber(
        port -> {
          actions.setCommandPort(drone().number(), (int) port, this::afterChange);
        });
    state.onNumber(port -> configure());
    video.onNumber(port -> configure());
  }

  private void setupBindings() {
    simulation
        .selectedProperty()
        .flatMap(FxDroneModel::onProperty)
        .addListener((property, before, now) -> restore());
    simulation.selectedProperty().addListener((property, before, now) -> restore());
    restore();
  }

  /** Shows what holds now, apart from what somebody is typing. */
  void refresh() {
    List<InetSocketAddress> own = addresses(drone());
    addresses.show(own);
    reach.refresh();
    int commandPort = own.get(0).getPort();
    command.show(commandPort);
    state.show(streamPorts().statePort());
    video.show(streamPorts().videoPort());
    warning.say(PortRules.warning(commandPort, streamPorts()));
  }

  private void restore() {
    refresh();
    for (NumberField field : List.of(command, state, video)) {
      field.restore();
      field.setDisable(drone().onProperty().get());
    }
  }

  private void configure() {
    StreamPorts streamPorts = new StreamPorts((int) state.number(), (int) video.number());
    DroneSnapshot snapshot = drone().snapshotProperty().get();
    actions.carryOut(new Control.Configure(drone().number(), snapshot.product(), streamPorts));
    changed.run();
  }

  private void afterChange() {
    refresh();
    changed.run();
  }

  private FxDroneModel drone() {
    return simulation.selected();
  }

  private StreamPorts streamPorts() {
    DroneSnapshot snapshot = drone().snapshotProperty().get();
    return new StreamPorts(snapshot.link().statePort(), snapshot.link().videoPort());
  }

  private List<InetSocketAddress> addresses(FxDroneModel drone) {
    return actions.addresses(drone.number());
  }

  private List<List<InetSocketAddress>> addressesOfOthers() {
    List<List<InetSocketAddress>> others = new ArrayList<>();
    for (FxDroneModel other : simulation.drones()) {
      others.add(other == drone() ? List.of() : addresses(other));
    }
    return others;
  }

  private HBox row(String key, NumberField field) {
    Label name = messages.label(key, "caption");
    name.setMaxWidth(Double.MAX_VALUE);
    name.setLabelFor(field);
    HBox.setHgrow(name, Priority.ALWAYS);
    field.accessibleTextProperty().bind(name.textProperty());
    HBox row = new HBox(name, field);
    row.getStyleClass().add("row");
    Tooltips.install(row, messages.text(key + ".hint"));
    return row;
  }
}
