package tellosimulator.view.controls;

import java.util.List;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.math.Frames;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Rules;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.StartSettings;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/**
 * What holds only from the next beginning on: the seed, what counts as a crash, and the optics of
 * the cameras. A button begins anew with them. For the JavaFX thread.
 */
final class StartPanel extends VBox {

  /** Seeds that can be typed here. Decided: nobody types more digits. */
  private static final NumberRange SEED = new NumberRange(-999_999_999, 999_999_999, 1);

  /** [cm/s] */
  private static final NumberRange CRASH =
      new NumberRange(0, Frames.centimeters(Rules.FASTEST_TOUCH), 5);

  /** [degrees] */
  private static final NumberRange FIELD_OF_VIEW =
      new NumberRange(DroneOptics.NARROWEST_DEG, DroneOptics.WIDEST_DEG, 1);

  private static final NumberRange TILT =
      new NumberRange(-DroneOptics.STEEPEST_DEG, DroneOptics.STEEPEST_DEG, 1);

  private final StartSettings present;
  private final ScenarioActions actions;
  private final Messages messages;
  private final NumberField seed;
  private final NumberField crash;
  private final NumberField fieldOfView;
  private final NumberField tilt;
  private final Button begin = new Button("", new FontIcon(Feather.ROTATE_CCW));

  StartPanel(ViewContext context) {
    SimConfig config = context.scenario().scenario().config();
    present =
        new StartSettings(config.seed(), config.rules().crashSpeed(), context.video().optics());
    actions = context.scenario().actions();
    messages = context.language().messages(StartPanel.class);
    seed = new NumberField("start-seed", SEED, context.language());
    crash = new NumberField("start-crash-speed", CRASH, context.language());
    fieldOfView = new NumberField("start-field-of-view", FIELD_OF_VIEW, context.language());
    tilt = new NumberField("start-tilt", TILT, context.language());
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
    crash.show(Frames.centimeters(present.crashSpeed()));
    fieldOfView.show(Math.toDegrees(present.optics().fieldOfView()));
    tilt.show(Math.toDegrees(present.optics().tilt()));
    begin.setId("begin-anew");
    begin.setMaxWidth(Double.MAX_VALUE);
    begin.textProperty().bind(messages.text("begin-anew"));
    Tooltips.install(begin, messages.text("begin-anew.hint"));
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
    Label name = messages.label(key, "caption");
    name.setMaxWidth(Double.MAX_VALUE);
    name.setLabelFor(field);
    HBox.setHgrow(name, Priority.ALWAYS);
    field.accessibleTextProperty().bind(name.textProperty());
    HBox row = new HBox(name, field);
    row.getStyleClass().add("row");
    Tooltips.install(row, messages.text(key + ".hint"));
    getChildren().addAll(row, field.error());
  }

  private void setupEventHandlers() {
    List.of(seed, crash, fieldOfView, tilt).forEach(field -> field.onNumber(set -> refresh()));
    begin.setOnAction(pressed -> actions.beginAnew(wanted()));
  }

  private void refresh() {
    begin.setDisable(wanted().equals(present));
  }

  /** What nobody touched is exactly as it was, whatever a field shows of it. */
  private StartSettings wanted() {
    DroneOptics optics = present.optics();
    return new StartSettings(
        seed.number() == (double) present.seed() ? present.seed() : Math.round(seed.number()),
        kept(crash, Frames.centimeters(present.crashSpeed()))
            ? present.crashSpeed()
            : Frames.meters(crash.number()),
        new DroneOptics(
            kept(fieldOfView, Math.toDegrees(optics.fieldOfView()))
                ? optics.fieldOfView()
                : Math.toRadians(fieldOfView.number()),
            kept(tilt, Math.toDegrees(optics.tilt()))
                ? optics.tilt()
                : Math.toRadians(tilt.number())));
  }

  private static boolean kept(NumberField field, double before) {
    return field.number() == before;
  }
}
