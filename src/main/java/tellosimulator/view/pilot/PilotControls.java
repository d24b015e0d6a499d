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
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.model.FlightPhase;
import tellosimulator.view.controls.PowerSwitch;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.pilot.DemoFlight.Stage;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/**
 * The buttons that fly the selected drone without an operator program. What comes and goes is above
 * them, and the width is fixed: at the lower edge of the scene no button ever moves away under the
 * mouse. For the JavaFX thread; to be closed with the window.
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
  private final Button demoFlight = new Button();
  private final ToggleButton keyboardFlight = new ToggleButton();
  private final Button takeOff = new Button();
  private final Button land = new Button();
  private final Button emergency = new Button();
  private final Label command = new Label();
  private final ProgressBar progress = new ProgressBar();
  private final Label problem = new Label();
  private final KeyLegend keyHint;

  public PilotControls(ViewContext context) {
    this.context = context;
    messages = context.language().messages(PilotControls.class);
    demo = new DemoFlight(context);
    remote = new RemoteControl(context);
    keyboard = new KeyboardSteering(context, remote);
    power = new PowerSwitch(context, "pilot-power");
    keyHint = new KeyLegend(messages, keyboard.pressed());
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  /**
   * Lets the keys of a scene fly, when that is switched on, until the subscription ends; to be
   * called once.
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

  /** Whether there is no room for words on the buttons. */
  public BooleanProperty narrowProperty() {
    return narrow;
  }

  /** Whether the power switch is among the buttons; another part of the window can have it. */
  public BooleanProperty powerShownProperty() {
    return powerShown;
  }

  /** Closes all sockets; a drone in the air is left there. */
  @Override
  public void close() {
    keyboard.activeProperty().set(false);
    demo.close();
    remote.close();
  }

  private void initializeSelf() {
    setId("pilot-controls");
    getStyleClass().add("pilot-controls");
    getStylesheets().add(PilotControls.class.getResource("pilot.css").toExternalForm());
  }

  private void initializeParts() {
    demoFlight.setId("demo-flight");
    keyboardFlight.setId("keyboard-flight");
    keyboardFlight.setGraphic(new FontIcon(Feather.MOVE));
    takeOff.setId("pilot-takeoff");
    takeOff.setGraphic(new FontIcon(Feather.CHEVRONS_UP));
    land.setId("pilot-land");
    land.setGraphic(new FontIcon(Feather.CHEVRONS_DOWN));
    emergency.setId("pilot-emergency");
    emergency.setGraphic(new FontIcon(Feather.ALERT_OCTAGON));
    emergency.getStyleClass().addAll(Styles.DANGER, Styles.BUTTON_OUTLINED);
    command.setId("pilot-command");
    progress.setId("pilot-progress");
    progress.getStyleClass().add(Styles.SMALL);
    problem.setId("pilot-problem");
    problem.setWrapText(true);
    problem.getStyleClass().add("problem");
  }

  private void layoutParts() {
    Region gap = new Region();
    gap.getStyleClass().add("gap");
    HBox buttons = new HBox(power, demoFlight, keyboardFlight, gap, takeOff, land, emergency);
    buttons.getStyleClass().add("buttons");
    shortened(ContentDisplay.LEFT, power, demoFlight, keyboardFlight);
    shortened(ContentDisplay.TEXT_ONLY, takeOff, land, emergency);
    for (ButtonBase button : List.of(power, demoFlight, keyboardFlight, takeOff, land, emergency)) {
      button.setMaxWidth(Double.MAX_VALUE);
      HBox.setHgrow(button, Priority.ALWAYS);
    }
    VBox tour = new VBox(command, progress);
    tour.getStyleClass().add("tour");
    progress.setMaxWidth(Double.MAX_VALUE);
    tour.visibleProperty().bind(demo.runningProperty());
    shownOnlyWhenVisible(tour);
    shownOnlyWhenVisible(problem);
    shownOnlyWhenVisible(keyHint);
    shownOnlyWhenVisible(power);
    getChildren().addAll(keyHint, problem, tour, buttons);
  }

  /** Lets buttons be icons with their words as hints where it is narrow. */
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

  private static void shownOnlyWhenVisible(Node node) {
    node.managedProperty().bind(node.visibleProperty());
  }

  private void setupEventHandlers() {
    demoFlight.setOnAction(pressed -> startOrStop());
    takeOff.setOnAction(pressed -> afresh(remote::takeOff));
    land.setOnAction(pressed -> afresh(() -> remote.ask("land")));
    emergency.setOnAction(pressed -> afresh(() -> remote.tell("emergency")));
    keyboard.activeProperty().subscribe(active -> afresh(() -> {}));
  }

  /** Begins something else: what went wrong before is old news. */
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
    keyboardFlight.textProperty().bind(messages.text("keyboard-flight"));
    keyboardFlight.selectedProperty().bindBidirectional(keyboard.activeProperty());
    keyboardFlight.disableProperty().bind(demo.runningProperty());
    keyHint.visibleProperty().bind(keyboard.activeProperty());
    power.visibleProperty().bind(powerShown);
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
    problem.visibleProperty().bind(sentence.isNotEmpty());
  }

  private void bindDemo() {
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
                this::step,
                demo.aimProperty(),
                demo.stepProperty(),
                demo.stepsProperty(),
                demo.commandProperty(),
                context.language().localeProperty()));
    progress
        .progressProperty()
        .bind(
            Bindings.createDoubleBinding(
                () -> demo.stepProperty().get() / (double) Math.max(1, demo.stepsProperty().get()),
                demo.stepProperty(),
                demo.stepsProperty()));
  }

  private String step() {
    return messages.now(
        "tour-step-" + demo.aimProperty().get().name(),
        demo.stepProperty().get(),
        demo.stepsProperty().get(),
        demo.commandProperty().get());
  }

  private void bindCommands() {
    ObservableValue<FlightPhase> phase =
        context.simulation().selectedProperty().flatMap(FxDroneModel::phaseProperty);
    BooleanBinding flies =
        Bindings.createBooleanBinding(
            () -> phase.getValue() != null && phase.getValue().flying(), phase);
    takeOff.textProperty().bind(messages.text("take-off"));
    land.textProperty().bind(messages.text("land"));
    emergency.textProperty().bind(messages.text("emergency"));
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
