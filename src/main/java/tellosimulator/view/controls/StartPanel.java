package tellosimulator.view.controls;

import java.util.List;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.scenario.Quantity;
import tellosimulator.scenario.Quantity.Unit;
import tellosimulator.sim.SimConfig;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.StartSettings;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/**
 * The settings that take effect only in a new run: the seed, the crash speed, and the cameras'
 * optics. A button begins a new run with them. Confined to the JavaFX thread.
 */
final class StartPanel extends VBox {

  /** The range of seeds that can be typed. Decided: users do not need more digits. */
  private static final NumberRange SEED = new NumberRange(-999_999_999, 999_999_999, 1);

  /** The range of the impact speed above which a contact is a crash [cm/s]. */
  private static final NumberRange CRASH = new NumberRange(Quantity.CRASH_SPEED, 5);

  private static final Quantity FIELD_OF_VIEW =
      new Quantity(Unit.DEGREE, DroneOptics.NARROWEST_DEG, DroneOptics.WIDEST_DEG);

  private static final Quantity TILT =
      new Quantity(Unit.DEGREE, -DroneOptics.STEEPEST_DEG, DroneOptics.STEEPEST_DEG);

  private final StartSettings present;
  private final ScenarioActions actions;
  private final Messages messages;
  private final NumberField seed;
  private final NumberField crash;
  private final NumberField fieldOfView;
  private final NumberField tilt;
  private final Button begin =
      Nodes.named(new Button("", new FontIcon(Feather.ROTATE_CCW)), "restart");

  StartPanel(ViewContext context) {
    SimConfig config = context.scenario().scenario().config();
    present =
        new StartSettings(config.seed(), config.rules().crashSpeed(), context.video().optics());
    actions = context.scenario().actions();
    messages = context.language().messages(StartPanel.class);
    seed = new NumberField("start-seed", SEED, context.language());
    crash = new NumberField("start-crash-speed", CRASH, context.language());
    fieldOfView =
        new NumberField(
            "start-field-of-view", new NumberRange(FIELD_OF_VIEW, 1), context.language());
    tilt = new NumberField("start-tilt", new NumberRange(TILT, 1), context.language());
    initializeParts();
    layoutParts();
    setupEventHandlers();
    refresh();
  }

  private void initializeParts() {
    getStyleClass().add("start-panel");
    seed.setRule(
        number ->
            number == Math.rint(number) ? Optional.empty() : Optional.of(Message.of("seed.whole")));
    seed.show((double) present.seed());
    crash.show(Quantity.CRASH_SPEED.written(present.crashSpeed()));
    fieldOfView.show(FIELD_OF_VIEW.written(present.optics().fieldOfView()));
    tilt.show(TILT.written(present.optics().tilt()));
    begin.setMaxWidth(Double.MAX_VALUE);
    begin.textProperty().bind(messages.text("restart"));
    Tooltips.install(begin, messages.text("restart.hint"));
  }

  private void layoutParts() {
    getChildren().add(messages.label("start.heading", "heading"));
    add("start-seed", seed);
    add("start-crash-speed", crash);
    add("start-field-of-view", fieldOfView);
    add("start-tilt", tilt);
    getChildren().add(begin);
  }

  private void add(String key, NumberField field) {
    getChildren().addAll(new FormRow(messages, key, field), field.error());
  }

  private void setupEventHandlers() {
    List.of(seed, crash, fieldOfView, tilt).forEach(field -> field.onNumber(set -> refresh()));
    begin.setOnAction(pressed -> actions.restart(wanted()));
  }

  private void refresh() {
    begin.setDisable(wanted().equals(present));
  }

  /**
   * Returns the requested settings. Values that were not edited remain exactly as they were,
   * regardless of the precision that their fields show.
   */
  private StartSettings wanted() {
    DroneOptics optics = present.optics();
    return new StartSettings(
        seed.number() == (double) present.seed() ? present.seed() : Math.round(seed.number()),
        wanted(crash, Quantity.CRASH_SPEED, present.crashSpeed()),
        new DroneOptics(
            wanted(fieldOfView, FIELD_OF_VIEW, optics.fieldOfView()),
            wanted(tilt, TILT, optics.tilt()),
            optics.photoWidth()));
  }

  private static double wanted(NumberField field, Quantity quantity, double before) {
    boolean kept = field.number() == quantity.written(before);
    return kept ? before : quantity.inSi(field.number());
  }
}
