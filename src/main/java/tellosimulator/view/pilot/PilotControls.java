package tellosimulator.view.pilot;

import atlantafx.base.theme.Styles;
import java.util.List;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.binding.StringBinding;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.model.FlightPhase;
import tellosimulator.view.controls.PowerSwitch;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.pilot.DemoFlight.Stage;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/**
 * The buttons that fly the selected drone without an operator program. Temporary messages appear
 * above the buttons, and the width is fixed, so that no button moves away from under the mouse.
 * Confined to the JavaFX thread; must be closed with the window.
 */
public final class PilotControls extends VBox implements AutoCloseable {

  private static final PseudoClass NARROW = PseudoClass.getPseudoClass("narrow");
  private static final PseudoClass WITH_POWER = PseudoClass.getPseudoClass("with-power");

  private final BooleanProperty narrow = new SimpleBooleanProperty(this, "narrow");
  private final BooleanProperty powerShown = new SimpleBooleanProperty(this, "powerShown");
  private final Messages messages;
  private final ViewContext context;
  private final DemoFlight demo;
  private final RemoteControl remote;
  private final KeyboardSteering keyboard;

  private final PowerSwitch power;
  private final Button demoFlight = Nodes.named(new Button(), "demo-flight");
  private final ToggleButton keyboardFlight = Nodes.named(new ToggleButton(), "keyboard-flight");
  private final Button takeOff;
  private final Button land;
  private final Button emergency;
  private final Label command = Nodes.named(new Label(), "pilot-command");
  private final ProgressBar progress =
      Nodes.named(new ProgressBar(), "pilot-progress", Styles.SMALL);
  private final Label problem = Nodes.named(new Label(), "pilot-problem", "problem");
  private final KeyLegend keyHint;

  public PilotControls(ViewContext context) {
    this.context = context;
    messages = context.language().messages(PilotControls.class);
    demo = new DemoFlight(context);
    remote = new RemoteControl(context);
    keyboard = new KeyboardSteering(context, remote);
    power = new PowerSwitch(context, "pilot-power");
    keyHint = new KeyLegend(messages, keyboard.pressed());
    takeOff = button("pilot-takeoff", Feather.CHEVRONS_UP, "take-off", remote::takeOff);
    land = button("pilot-land", Feather.CHEVRONS_DOWN, "land", () -> remote.ask("land"));
    emergency =
        button(
            "pilot-emergency", Feather.ALERT_OCTAGON, "emergency", () -> remote.tell("emergency"));
    Nodes.styled(emergency, Styles.DANGER, Styles.BUTTON_OUTLINED);
    Nodes.named(this, "pilot-controls", "pilot-controls");
    getStylesheets().add(PilotControls.class.getResource("pilot.css").toExternalForm());
    layoutParts();
    setupBindings();
  }

  /**
   * Handles the keys of a scene while keyboard flight is on, until the subscription ends. Must be
   * called only once.
   */
  public Subscription install(Scene scene) {
    return keyboard.install(scene);
  }

  public DemoFlight demo() {
    return demo;
  }

  public KeyboardSteering keyboard() {
    return keyboard;
  }

  /** Whether the buttons show icons only, for lack of space. */
  public BooleanProperty narrowProperty() {
    return narrow;
  }

  /** Whether the power switch is shown here rather than elsewhere in the window. */
  public BooleanProperty powerShownProperty() {
    return powerShown;
  }

  /** Closes all sockets, without landing the drone. */
  @Override
  public void close() {
    keyboard.activeProperty().set(false);
    demo.close();
    remote.close();
  }

  private Button button(String id, Feather icon, String key, Runnable action) {
    Button button = Nodes.named(new Button("", new FontIcon(icon)), id);
    button.textProperty().bind(messages.text(key));
    button.setOnAction(pressed -> afresh(action));
    return button;
  }

  private void layoutParts() {
    Region gap = Nodes.styled(new Region(), "gap");
    HBox buttons =
        Nodes.styled(
            new HBox(power, demoFlight, keyboardFlight, gap, takeOff, land, emergency), "buttons");
    shortened(ContentDisplay.LEFT, power, demoFlight, keyboardFlight);
    shortened(ContentDisplay.TEXT_ONLY, takeOff, land, emergency);
    List.of(power, demoFlight, keyboardFlight, takeOff, land, emergency).forEach(Nodes::growing);
    VBox tour = Nodes.styled(new VBox(command, progress), "tour");
    progress.setMaxWidth(Double.MAX_VALUE);
    problem.setWrapText(true);
    Nodes.showIf(tour, demo.runningProperty());
    Nodes.showIf(keyHint, keyboard.activeProperty());
    Nodes.showIf(power, powerShown);
    getChildren().addAll(keyHint, problem, tour, buttons);
  }

  /** Reduces buttons to icons with tooltips while the row of buttons is narrow. */
  private void shortened(ContentDisplay wide, ButtonBase... buttons) {
    for (ButtonBase button : buttons) {
      button
          .contentDisplayProperty()
          .bind(narrow.map(is -> is ? ContentDisplay.GRAPHIC_ONLY : wide));
      Tooltips.install(button, button.textProperty());
      Tooltip hint = button.getTooltip();
      button.tooltipProperty().bind(narrow.map(is -> is ? hint : null));
    }
  }

  /** Clears the displayed problem, then runs an action. */
  private void afresh(Runnable action) {
    demo.forgetProblem();
    remote.forgetProblem();
    power.forgetProblem();
    action.run();
  }

  private void startOrStop() {
    if (demo.runningProperty().get()) {
      demo.stop();
    } else {
      keyboardFlight.setSelected(false);
      afresh(demo::switchOnAndStart);
    }
  }

  private void setupBindings() {
    bindDemo();
    bindCommands();
    keyboardFlight.setGraphic(new FontIcon(Feather.MOVE));
    keyboardFlight.textProperty().bind(messages.text("keyboard-flight"));
    keyboardFlight.selectedProperty().bindBidirectional(keyboard.activeProperty());
    keyboardFlight.disableProperty().bind(demo.runningProperty());
    keyboard.activeProperty().subscribe(active -> afresh(() -> {}));
    powerShown.subscribe(shown -> pseudoClassStateChanged(WITH_POWER, shown));
    narrow.subscribe(
        now -> {
          pseudoClassStateChanged(NARROW, now);
          keyHint.showWords(!now);
        });
    StringBinding sentence =
        Bindings.createStringBinding(
            this::sentence,
            demo.problemProperty(),
            remote.problemProperty(),
            power.problemProperty(),
            context.language().localeProperty());
    problem.textProperty().bind(sentence);
    Nodes.showIf(problem, sentence.isNotEmpty());
  }

  private void bindDemo() {
    demoFlight.setOnAction(pressed -> startOrStop());
    demoFlight
        .textProperty()
        .bind(
            Bindings.createStringBinding(
                () -> messages.now("demo-" + demo.stageProperty().get().name()),
                demo.stageProperty(),
                context.language().localeProperty()));
    demoFlight
        .graphicProperty()
        .bind(
            demo.runningProperty().map(runs -> new FontIcon(runs ? Feather.SQUARE : Feather.PLAY)));
    demoFlight.disableProperty().bind(demo.stageProperty().isEqualTo(Stage.LANDING));
    command
        .textProperty()
        .bind(
            Bindings.createStringBinding(
                () -> step(demo.stepProperty().get()),
                demo.stepProperty(),
                context.language().localeProperty()));
    progress
        .progressProperty()
        .bind(demo.stepProperty().map(step -> step.number() / (double) Math.max(1, step.count())));
  }

  private String step(DemoFlight.Step step) {
    return messages.now(
        "tour-step-" + step.aim().name(), step.number(), step.count(), step.command());
  }

  private void bindCommands() {
    ObservableValue<FlightPhase> phase = context.simulation().selected(FxDroneModel::phaseProperty);
    BooleanBinding flies =
        Bindings.createBooleanBinding(
            () -> phase.getValue() != null && phase.getValue().flying(), phase);
    takeOff.disableProperty().bind(flies.or(demo.runningProperty()));
    land.disableProperty().bind(flies.not().or(demo.runningProperty()));
    emergency.disableProperty().bind(flies.not());
  }

  private String sentence() {
    Message ofTour = demo.problemProperty().get();
    Message ofPilot = ofTour.isNone() ? remote.problemProperty().get() : ofTour;
    return ofPilot.isNone() ? power.problemProperty().get() : ofPilot.now(messages);
  }
}
