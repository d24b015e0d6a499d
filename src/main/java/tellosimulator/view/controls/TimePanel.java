package tellosimulator.view.controls;

import java.util.Comparator;
import java.util.stream.DoubleStream;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.sim.Control;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Shows the simulated time, sets its speed, and pauses and resumes it. Confined to the JavaFX
 * thread.
 */
final class TimePanel extends Card {

  private static final double[] FACTORS = {0.1, 0.25, 0.5, 1, 2, 5, 10, 20, TimeFactor.MAX.value()};

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Language language;
  private final Messages messages;
  private final Label clock = Nodes.named(new Label(), "simulated-time", "number");
  private final Label lost = Nodes.named(new Label(), "lost-time", "sentence", "muted");
  private final ComboBox<TimeFactor> factor = Nodes.named(new ComboBox<>(), "time-factor");
  private final ToggleButton pause = Nodes.named(new ToggleButton(), "pause");
  private final FontIcon pauseIcon = new FontIcon(Feather.PAUSE);

  /** Whether the program, not the user, is changing the value of the combo box. */
  private boolean showing;

  TimePanel(ViewContext context) {
    super("time", context.language().messages(TimePanel.class).text("heading.time"));
    simulation = context.simulation();
    actions = context.actions();
    language = context.language();
    messages = language.messages(TimePanel.class);
    initializeParts();
    layoutHead(clock);
    layoutCard(new HBox(8, Nodes.growing(factor), Nodes.growing(pause)), lost);
    setupEventHandlers();
    setupBindings();
    refresh();
  }

  private void initializeParts() {
    ObservableList<TimeFactor> offered = FXCollections.observableArrayList();
    DoubleStream.of(FACTORS).mapToObj(TimeFactor::new).forEach(offered::add);
    factor.setItems(offered);
    factor.setCellFactory(list -> new FactorCell());
    factor.setButtonCell(new FactorCell());
    pause.setGraphic(pauseIcon);
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
    Nodes.showIf(lost, simulation.lostSecondsProperty().greaterThan(0));
    lost.textProperty().bind(messages.text("time.lost", simulation.lostSecondsProperty()));
    Tooltips.install(lost, messages.text("time.lost.hint"));
    Nodes.described(factor, messages.text("time.factor.hint"));
    pause
        .textProperty()
        .bind(
            simulation
                .pausedProperty()
                .flatMap(paused -> messages.text(paused ? "time.resume" : "time.pause")));
    openProperty().subscribe(this::refresh);
    simulation.pausedProperty().subscribe(this::showPause);
    simulation.timeFactorProperty().subscribe(this::showFactor);
  }

  /** Updates the time, unless the card is folded. */
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
