package tellosimulator.view.controls;

import atlantafx.base.controls.Spacer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import javafx.beans.property.IntegerProperty;
import javafx.beans.property.SimpleIntegerProperty;
import javafx.css.PseudoClass;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import javafx.scene.shape.Circle;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.model.Battery;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.Control;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * A list of all drones with the number, state, battery and address of each. A click selects the
 * drone that panels and cameras show. Only visible rows are updated, several times a second.
 * Confined to the JavaFX thread.
 */
public final class DroneList extends VBox {

  /** Width of the list [px]. Decided: fits the longest address. */
  private static final double WIDTH = 336;

  private static final double ROW_HEIGHT = 24;

  /**
   * Maximum number of visible rows. Decided: leaves enough space for the room on a common screen.
   */
  private static final int MOST_ROWS = 5;

  /** Time between two updates [ns]. Decided: four updates a second. */
  private static final long PERIOD_NANOS = 250_000_000;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;

  /** The cells of the list. Only visible rows have cells. */
  private final List<DroneCell> cells = new ArrayList<>();

  private final Label heading = Nodes.named(new Label(), "drones-heading", "heading");
  private final Button fold = Nodes.named(new Button(), "drones-fold", "fold");
  private final ListView<FxDroneModel> list = Nodes.named(new ListView<>(), "drones");
  private final IntegerProperty on = new SimpleIntegerProperty(this, "on");
  private long lookedNanos = Long.MIN_VALUE;

  public DroneList(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(DroneList.class);
    context.language().localeProperty().addListener(changed -> refresh());
    Nodes.named(this, "drone-list", "drone-list");
    getStylesheets().add(DroneList.class.getResource("controls.css").toExternalForm());
    Nodes.fixWidth(this, WIDTH);
    initializeParts();
    layoutParts();
    setupBindings();
    context.ticker().onTick(this::beat);
  }

  private void initializeParts() {
    int count = simulation.drones().size();
    heading.textProperty().bind(messages.text("drones.heading", simulation.drones().size(), on));
    fold.setOnAction(pressed -> unfold(!list.isVisible()));
    fold.accessibleTextProperty().bind(messages.text("drones.fold"));
    list.setItems(simulation.drones());
    list.setFixedCellSize(ROW_HEIGHT);
    list.setCellFactory(view -> cell());
    list.setPrefHeight(Math.min(count, MOST_ROWS) * ROW_HEIGHT + 2);
    list.setMinHeight(ROW_HEIGHT);
    list.accessibleTextProperty().bind(messages.text("drones.accessible"));
  }

  private void layoutParts() {
    Button allOn = button("drones-on", () -> switchAll(true));
    Button allOff = button("drones-off", () -> switchAll(false));
    Button allBack =
        button(
            "drones-reset",
            () ->
                simulation.drones().forEach(d -> actions.carryOut(new Control.Reset(d.number()))));
    Nodes.unshrinkable(heading);
    HBox head = new HBox(heading, new Spacer(), allOn, allOff, allBack, fold);
    Nodes.styled(head, "head");
    getChildren().addAll(head, list);
    unfold(true);
  }

  private Button button(String id, Runnable action) {
    String key = id.replace('-', '.');
    Button button = Nodes.unshrinkable(Nodes.named(new Button(), id));
    button.textProperty().bind(messages.text(key));
    Tooltips.install(button, messages.text(key + ".hint"));
    button.setOnAction(pressed -> action.run());
    return button;
  }

  private void setupBindings() {
    simulation.selectedProperty().subscribe(this::show);
    list.getSelectionModel()
        .selectedItemProperty()
        .addListener(
            (property, before, now) -> {
              if (now != null) {
                simulation.selectedProperty().set(now);
              }
            });
  }

  private DroneCell cell() {
    DroneCell cell = new DroneCell(actions, messages);
    cells.add(cell);
    return cell;
  }

  private void refresh() {
    cells.forEach(DroneCell::refresh);
  }

  /** Shows or folds the list below the buttons. */
  public void unfold(boolean open) {
    Nodes.setShown(list, open);
    fold.setGraphic(new FontIcon(open ? Feather.CHEVRON_UP : Feather.CHEVRON_DOWN));
  }

  private void show(FxDroneModel drone) {
    if (list.getSelectionModel().getSelectedItem() != drone) {
      list.getSelectionModel().select(drone);
      int index = simulation.drones().indexOf(drone);
      list.scrollTo(Math.max(0, index - MOST_ROWS / 2));
    }
  }

  /**
   * Switches all drones on or off. A drone that cannot be switched on does not affect the others.
   */
  private void switchAll(boolean wanted) {
    Predicate<FxDroneModel> other = drone -> drone.onProperty().get() != wanted;
    simulation.drones().stream()
        .filter(other)
        .forEach(drone -> actions.switchPower(drone.number(), wanted));
  }

  private void beat(long nanos) {
    if (lookedNanos == Long.MIN_VALUE || nanos - lookedNanos >= PERIOD_NANOS) {
      lookedNanos = nanos;
      on.set((int) simulation.drones().stream().filter(d -> d.onProperty().get()).count());
      if (isVisible() && list.isVisible()) {
        refresh();
      }
    }
  }

  /** A cell that shows a drone in a list: its number, colour, state, battery, and address. */
  private static final class DroneCell extends ListCell<FxDroneModel> {

    private static final PseudoClass LOW = PseudoClass.getPseudoClass("low");

    private static final double STATE_WIDTH = 96;
    private static final double BATTERY_WIDTH = 42;

    private final SimulatorActions actions;
    private final Messages messages;
    private final Circle color = new Circle(9);
    private final Label number = Nodes.styled(new Label(), "badge");
    private final PhaseLabel state = new PhaseLabel();
    private final Label battery = Nodes.styled(new Label(), "battery");
    private final Label address = Nodes.styled(new Label(), "address");
    private final HBox parts = Nodes.styled(new HBox(), "drone-row");

    DroneCell(SimulatorActions actions, Messages messages) {
      this.actions = actions;
      this.messages = messages;
      state.setMinWidth(STATE_WIDTH);
      battery.setMinWidth(BATTERY_WIDTH);
      Nodes.growing(address);
      parts.getChildren().addAll(new StackPane(color, number), state, battery, address);
      setPrefWidth(0); // never wider than the list
    }

    @Override
    protected void updateItem(FxDroneModel drone, boolean empty) {
      super.updateItem(drone, empty);
      if (empty || drone == null) {
        setGraphic(null);
      } else {
        number.setText(Integer.toString(drone.number()));
        Color own = DroneColors.of(drone);
        color.setFill(own);
        number.setTextFill(DroneColors.inkOn(own));
        setGraphic(parts);
        refresh();
      }
    }

    /** Shows the current state of the drone. */
    void refresh() {
      FxDroneModel drone = getItem();
      if (drone == null) {
        return;
      }
      FlightPhase phase = drone.phaseProperty().get();
      state.setText(messages.now(FlightPanel.keyOf(phase)));
      state.show(phase);
      double percent = Math.rint(drone.batteryPercentProperty().get());
      battery.setText(NumberText.whole(percent) + " %");
      battery.pseudoClassStateChanged(LOW, percent <= 2 * Battery.TOO_LOW_FOR_TAKEOFF);
      address.setText(address(drone.number()));
    }

    private String address(int drone) {
      return AddressList.mostUseful(actions.addresses(drone));
    }
  }
}
