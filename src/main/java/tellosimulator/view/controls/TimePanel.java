package tellosimulator.view.controls;

import java.util.Comparator;
import java.util.stream.DoubleStream;
import javafx.beans.binding.BooleanBinding;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.sim.Control;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** Simulated time: how late it is, how fast it passes, and a pause. For the JavaFX thread. */
final class TimePanel extends Card {

  private static final double[] FACTORS = {0.1, 0.25, 0.5, 1, 2, 5, 10, 20, TimeFactor.MAX.value()};

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Language language;
  private final Messages messages;
  private final Label clock = new Label();
  private final Label lost = new Label();
  private final ComboBox<TimeFactor> factor = new ComboBox<>();
  private final ToggleButton pause = new ToggleButton();
  private final FontIcon pauseIcon = new FontIcon(Feather.PAUSE);

  /** Whether the choice changes because the simulation's factor is shown. */
  private boolean showing;

  TimePanel(ViewContext context) {
    super("time", context.language().messages(TimePanel.class).text("heading.time"));
    simulation = context.simulation();
    actions = context.actions();
    language = context.language();
    messages = language.messages(TimePanel.class);
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
    refresh();
  }

  private void initializeParts() {
    clock.setId("simulated-time");
    clock.getStyleClass().add("number");
    lost.setId("lost-time");
    lost.getStyleClass().addAll("sentence", "muted");
    ObservableList<TimeFactor> offered = FXCollections.observableArrayList();
    DoubleStream.of(FACTORS).mapToObj(TimeFactor::new).forEach(offered::add);
    factor.setId("time-factor");
    factor.setItems(offered);
    factor.setCellFactory(list -> new FactorCell());
    factor.setButtonCell(new FactorCell());
    factor.setMaxWidth(Double.MAX_VALUE);
    pause.setId("pause");
    pause.setGraphic(pauseIcon);
    pause.setMaxWidth(Double.MAX_VALUE);
  }

  private void layoutParts() {
    HBox row = new HBox(8, factor, pause);
    HBox.setHgrow(factor, Priority.ALWAYS);
    HBox.setHgrow(pause, Priority.ALWAYS);
    layoutHead(clock);
    layoutCard(row, lost);
  }

  private void setupEventHandlers() {
    factor
        .valueProperty()
        .addListener(
            (property, before, now) -> {
              if (!showing && now != null) {
                actions.carryOut(new Control.SetTimeFactor(now));
              }
            });
    pause.setOnAction(pressed -> actions.carryOut(new Control.Pause(pause.isSelected())));
  }

  private void setupBindings() {
    BooleanBinding someLost = simulation.lostSecondsProperty().greaterThan(0);
    lost.visibleProperty().bind(someLost);
    lost.managedProperty().bind(someLost);
    lost.textProperty().bind(messages.text("time.lost", simulation.lostSecondsProperty()));
    Tooltips.install(lost, messages.text("time.lost.hint"));
    Tooltips.install(factor, messages.text("time.factor.hint"));
    factor.accessibleTextProperty().bind(messages.text("time.factor.hint"));
    pause
        .textProperty()
        .bind(
            simulation
                .pausedProperty()
                .flatMap(paused -> messages.text(paused ? "time.resume" : "time.pause")));
    openProperty().subscribe(this::refresh);
    simulation.pausedProperty().addListener((property, before, now) -> showPause(now));
    simulation.timeFactorProperty().addListener((property, before, now) -> showFactor(now));
    showPause(simulation.pausedProperty().get());
    showFactor(simulation.timeFactorProperty().get());
  }

  /** Shows how late it is, unless it is folded away. */
  void refresh() {
    if (isOpen()) {
      clock.setText(NumberText.time(simulation.secondsProperty().get()));
    }
  }

  private void showPause(boolean paused) {
    pause.setSelected(paused);
    pauseIcon.setIconCode(paused ? Feather.PLAY : Feather.PAUSE);
  }

  private void showFactor(TimeFactor now) {
    showing = true;
    if (!factor.getItems().contains(now)) {
      factor.getItems().add(now);
      FXCollections.sort(factor.getItems(), Comparator.comparingDouble(TimeFactor::value));
    }
    factor.setValue(now);
    showing = false;
  }

  private final class FactorCell extends ListCell<TimeFactor> {

    @Override
    protected void updateItem(TimeFactor item, boolean empty) {
      super.updateItem(item, empty);
      textProperty().unbind();
      if (empty || item == null) {
        setText("");
      } else if (item.unlimited()) {
        textProperty().bind(messages.text("time.max"));
      } else {
        textProperty()
            .bind(language.localeProperty().map(locale -> NumberText.factor(item.value(), locale)));
      }
    }
  }
}
