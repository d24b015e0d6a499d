package tellosimulator.view.controls;

import atlantafx.base.controls.Spacer;
import java.util.List;
import java.util.function.Predicate;
import javafx.beans.property.IntegerProperty;
import javafx.beans.property.SimpleIntegerProperty;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/**
 * All drones in a list: number, state, battery and address of each. A click chooses the one that
 * panels and cameras show. Only the rows that are seen cost anything, some times a second. For the
 * JavaFX thread.
 */
public final class DroneList extends VBox {

  /** Width of the list [px]. Decided: the longest address. */
  private static final double WIDTH = 336;

  private static final double ROW_HEIGHT = 24;

  /** Rows that are seen at once. Decided: the room has the rest of a common screen. */
  private static final int MOST_ROWS = 5;

  /** Time between two looks at the drones [ns]. Decided: four a second. */
  private static final long PERIOD_NANOS = 250_000_000;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final DroneCell.Rows rows;
  private final Label heading = new Label();
  private final Button allOn = new Button();
  private final Button allOff = new Button();
  private final Button allBack = new Button();
  private final Button fold = new Button();
  private final ListView<FxDroneModel> list = new ListView<>();
  private final IntegerProperty on = new SimpleIntegerProperty(this, "on");
  private long lookedNanos = Long.MIN_VALUE;

  public DroneList(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(DroneList.class);
    rows = new DroneCell.Rows(context, messages);
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
    context.pulse().onBeat(this::beat);
  }

  private void initializeSelf() {
    setId("drone-list");
    getStyleClass().add("drone-list");
    getStylesheets().add(DroneList.class.getResource("controls.css").toExternalForm());
    setMinWidth(WIDTH);
    setPrefWidth(WIDTH);
    setMaxWidth(WIDTH);
  }

  private void initializeParts() {
    int count = simulation.drones().size();
    heading.getStyleClass().add("heading");
    heading.setId("drones-heading");
    heading.setMinWidth(USE_PREF_SIZE);
    allOn.setId("drones-on");
    allOff.setId("drones-off");
    allBack.setId("drones-reset");
    for (Button button : List.of(allOn, allOff, allBack)) {
      button.setMinWidth(USE_PREF_SIZE);
    }
    fold.setId("drones-fold");
    fold.getStyleClass().add("fold");
    fold.accessibleTextProperty().bind(messages.text("drones.fold"));
    list.setId("drones");
    list.setItems(simulation.drones());
    list.setFixedCellSize(ROW_HEIGHT);
    list.setCellFactory(view -> rows.row());
    list.setPrefHeight(Math.min(count, MOST_ROWS) * ROW_HEIGHT + 2);
    list.setMinHeight(ROW_HEIGHT);
    list.accessibleTextProperty().bind(messages.text("drones.accessible"));
  }

  private void layoutParts() {
    HBox head = new HBox(heading, new Spacer(), allOn, allOff, allBack, fold);
    head.getStyleClass().add("head");
    getChildren().addAll(head, list);
    unfold(true);
  }

  private void setupEventHandlers() {
    allOn.setOnAction(pressed -> switchAll(true));
    allOff.setOnAction(pressed -> switchAll(false));
    fold.setOnAction(pressed -> unfold(!list.isVisible()));
    allBack.setOnAction(
        pressed ->
            simulation.drones().forEach(d -> actions.carryOut(new Control.Reset(d.number()))));
  }

  private void setupBindings() {
    heading.textProperty().bind(messages.text("drones.heading", simulation.drones().size(), on));
    List.of(allOn, allOff, allBack)
        .forEach(
            button -> {
              String key = button.getId().replace('-', '.');
              button.textProperty().bind(messages.text(key));
              Tooltips.install(button, messages.text(key + ".hint"));
            });
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

  /** Shows the drones below the buttons, or folds them away. */
  public void unfold(boolean open) {
    list.setVisible(open);
    list.setManaged(open);
    fold.setGraphic(new FontIcon(open ? Feather.CHEVRON_UP : Feather.CHEVRON_DOWN));
  }

  private void show(FxDroneModel drone) {
    if (list.getSelectionModel().getSelectedItem() != drone) {
      list.getSelectionModel().select(drone);
      int index = simulation.drones().indexOf(drone);
      list.scrollTo(Math.max(0, index - MOST_ROWS / 2));
    }
  }

  /** One that cannot be switched on says so itself; the others are tried all the same. */
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
        rows.refresh();
      }
    }
  }
}
