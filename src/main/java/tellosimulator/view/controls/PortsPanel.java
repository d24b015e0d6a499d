package tellosimulator.view.controls;

import atlantafx.base.theme.Styles;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Shows the addresses at which the selected drone accepts commands, and the ports to which it sends
 * its state and video. The ports can be changed while the drone is off. Confined to the JavaFX
 * thread.
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
   * @param changed called when the user has changed a port or the reach of the drones
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
    layoutParts();
    setupEventHandlers();
    setupBindings();
    refresh();
  }

  private void layoutParts() {
    layoutCard(
        addresses,
        reach,
        new FormRow(messages, "command-port", command),
        command.error(),
        warning,
        messages.label("heading.listen", "heading"),
        new FormRow(messages, "state-port", state),
        state.error(),
        new FormRow(messages, "video-port", video),
        video.error());
  }

  private void setupEventHandlers() {
    command.setRule(port -> PortRules.command(port, addresses(drone()), addressesOfOthers()));
    state.setRule(port -> PortRules.streamPort(port, (int) video.number()));
    video.setRule(port -> PortRules.streamPort(port, (int) state.number()));
    command.onNumber(
        port -> actions.setCommandPort(drone().number(), (int) port, this::afterChange));
    state.onNumber(port -> configure());
    video.onNumber(port -> configure());
  }

  private void setupBindings() {
    simulation.selected(FxDroneModel::onProperty).addListener((property, before, now) -> restore());
    simulation.selectedProperty().addListener((property, before, now) -> restore());
    restore();
  }

  /** Shows the current values, except in fields that the user is editing. */
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

  /**
   * The switch that makes the drones reachable from other machines of the network, with a sentence
   * about the consequences. Confined to the JavaFX thread.
   */
  private static final class ReachPanel extends VBox {

    private final SimulatorActions actions;
    private final CheckBox reachable = Nodes.named(new CheckBox(), "reachable");

    /**
     * @param changed notified when the user has used the switch
     */
    ReachPanel(ViewContext context, Runnable changed) {
      this.actions = context.actions();
      Messages messages = context.language().messages(ReachPanel.class);
      reachable.textProperty().bind(messages.text("reach"));
      Label sentence = Nodes.wrapping(Nodes.named(new Label(), "reach-sentence", "caption"));
      sentence
          .textProperty()
          .bind(
              reachable
                  .selectedProperty()
                  .flatMap(on -> messages.text(on ? "reach.open" : "reach.closed")));
      Tooltips.install(this, messages.text("reach.hint"));
      reachable.accessibleHelpProperty().bind(messages.text("reach.hint"));
      getChildren().addAll(reachable, sentence);
      reachable.setOnAction(
          pressed -> actions.setReachableFromNetwork(reachable.isSelected(), changed));
      refresh();
    }

    /** Shows the current value. */
    void refresh() {
      reachable.setSelected(actions.reachableFromNetwork());
    }
  }
}
