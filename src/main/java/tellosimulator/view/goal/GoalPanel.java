package tellosimulator.view.goal;

import atlantafx.base.controls.Spacer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import javafx.beans.binding.Bindings;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.profile.Behavior;
import tellosimulator.scenario.Description;
import tellosimulator.scenario.LocalizedText;
import tellosimulator.sim.Control;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * What the scenario teaches, its goals with their numbers in the room and a time for each that is
 * reached, the time, and how it ended, with what one can try or fly next. Not there if nothing is
 * asked for or said. For the JavaFX thread.
 */
public final class GoalPanel extends VBox {

  /** Width of the panel [px]. Decided: a goal takes two lines at the most, and the room is seen. */
  private static final double WIDTH = 292;

  private static final PseudoClass REACHED = PseudoClass.getPseudoClass("reached");
  private static final PseudoClass FAILED = PseudoClass.getPseudoClass("failed");

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Language language;
  private final Messages messages;
  private final ObservableValue<Progress> progress;
  private final FxScenario scenario;
  private final List<GoalRow> rows = new ArrayList<>();
  private final Label name = new Label();
  private final Label teaches = new Label();
  private final Label time = new Label();
  private final Label banner = new Label();
  private final Label advice = new Label();
  private final Label rules = new Label();
  private final Button again = new Button();
  private final Button next = new Button();
  private final Button fold = new Button();
  private final VBox details = new VBox();
  private final VBox goals = new VBox();

  /** Whether the details are wanted. */
  private boolean open = true;

  /** Whether somebody has folded or unfolded the panel himself since the goals began. */
  private boolean chosen;

  /** What is there only with goals. */
  private List<Region> ofGoals = List.of();

  public GoalPanel(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    language = context.language();
    messages = language.messages(GoalPanel.class);
    progress = context.scenario().progressProperty();
    scenario = context.scenario();
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  /** Puts all drones back to their starts, with which the goals begin anew. */
  public void again() {
    simulation.drones().forEach(drone -> actions.carryOut(new Control.Reset(drone.number())));
  }

  private void initializeSelf() {
    setId("goal-panel");
    getStyleClass().add("goal-panel");
    getStylesheets().add(GoalPanel.class.getResource("goal.css").toExternalForm());
    setMinWidth(WIDTH);
    setPrefWidth(WIDTH);
    setMaxWidth(WIDTH);
    setMinHeight(USE_PREF_SIZE);
  }

  private void initializeParts() {
    name.setId("scenario-name");
    name.getStyleClass().add("name");
    name.setWrapText(true);
    name.setMinHeight(USE_PREF_SIZE);
    name.setMaxWidth(Double.MAX_VALUE);
    HBox.setHgrow(name, Priority.ALWAYS);
    teaches.setId("scenario-teaches");
    teaches.setWrapText(true);
    teaches.getStyleClass().add("muted");
    onlyWithText(teaches);
    time.setId("goal-time");
    time.setMinWidth(USE_PREF_SIZE);
    banner.setId("goal-banner");
    banner.setWrapText(true);
    banner.setMaxWidth(Double.MAX_VALUE);
    banner.setMinHeight(USE_PREF_SIZE);
    banner.getStyleClass().add("banner");
    advice.setId("goal-advice");
    advice.setWrapText(true);
    onlyWithText(advice);
    rules.setId("goal-rules");
    rules.setWrapText(true);
    rules.getStyleClass().add("muted");
    onlyWithText(rules);
    again.setId("goal-again");
    again.setGraphic(new FontIcon(Feather.ROTATE_CCW));
    again.setMinWidth(USE_PREF_SIZE);
    next.setId("goal-next");
    next.setGraphic(new FontIcon(Feather.ARROW_RIGHT));
    next.setMaxWidth(Double.MAX_VALUE);
    fold.setId("goal-fold");
    fold.getStyleClass().add("fold");
    goals.getStyleClass().add("goals");
    details.setId("goal-details");
    details.getStyleClass().add("details");
  }

  private void layoutParts() {
    HBox head = new HBox(name, fold);
    head.getStyleClass().add("head");
    ScrollPane scroll = new ScrollPane(goals);
    scroll.setFitToWidth(true);
    scroll.setMinViewportHeight(1); // else it is never lower than 36 px
    scroll.prefViewportHeightProperty().bind(goals.heightProperty()); // with wrapped lines
    scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
    scroll.setFocusTraversable(false);
    HBox attempt = new HBox(time, new Spacer(), again);
    attempt.getStyleClass().add("attempt");
    ofGoals = List.of(scroll, attempt);
    details.getChildren().addAll(teaches, scroll, rules);
    getChildren()
        .addAll(head, attempt, banner, advice, next, details); // long names need the whole width
  }

  private void setupEventHandlers() {
    again.setOnAction(pressed -> again());
    next.setOnAction(pressed -> scenario.next().ifPresent(scenario.actions()::openKnown));
    fold.setOnAction(pressed -> choose(!details.isVisible()));
  }

  /**
   * Shows what is below the name, or folds it away, unless somebody has chosen himself since the
   * goals began.
   */
  public void unfold(boolean wanted) {
    if (!chosen) {
      open = wanted;
      showDetails();
    }
  }

  private void follow(Progress now) {
    if (now.equals(Progress.start(now.challenge()))) {
      chosen = false;
    }
    show();
  }

  private void choose(boolean wanted) {
    open = wanted;
    chosen = true;
    showDetails();
  }

  private void showDetails() {
    setShown(details, open);
    fold.setGraphic(new FontIcon(open ? Feather.CHEVRON_UP : Feather.CHEVRON_DOWN));
  }

  private void setupBindings() {
    name.textProperty().bind(following(description().name()));
    teaches
        .textProperty()
        .bind(
            following(description().teaches())
                .map(what -> what.isEmpty() ? "" : messages.now("learn", what)));
    again.textProperty().bind(messages.text("again"));
    next.textProperty().bind(messages.text("next"));
    Tooltips.install(again, messages.text("again.hint"));
    Tooltips.install(time, messages.text("time.hint"));
    time.accessibleHelpProperty().bind(messages.text("time.hint"));
    fold.accessibleTextProperty().bind(messages.text("fold"));
    rules
        .textProperty()
        .bind(
            Bindings.createStringBinding(
                this::rules,
                language.localeProperty(),
                scenario.challengeProperty(),
                simulation.selectedProperty()));
    scenario.challengeProperty().subscribe(this::showGoals);
    progress.addListener((property, before, now) -> follow(now));
    showDetails();
    language.localeProperty().addListener((property, before, now) -> show());
    show();
  }

  private ObservableValue<String> following(LocalizedText text) {
    return language.localeProperty().map(text::in);
  }

  private Challenge challenge() {
    return scenario.challenge();
  }

  private Description description() {
    return scenario.scenario().description();
  }

  /** Another row for each goal. */
  private void showGoals(Challenge challenge) {
    rows.clear();
    for (int i = 0; i < challenge.goals().size(); i++) {
      Goal goal = challenge.goals().get(i);
      rows.add(
          new GoalRow(i, goal, DroneColors.of(goal, simulation.drones()), language, said(goal)));
    }
    goals.getChildren().setAll(rows);
    boolean asked = !rows.isEmpty();
    ofGoals.forEach(part -> setShown(part, asked));
    setShown(this, asked || !description().teaches().isEmpty());
    show();
  }

  /** What to do and where, as the room is now. */
  private ObservableValue<String> said(Goal goal) {
    return Bindings.createStringBinding(
        () -> language.say(GoalMark.task(goal, simulation.arenaProperty().get())),
        language.localeProperty(),
        simulation.arenaProperty());
  }

  private static void setShown(Region part, boolean shown) {
    part.setVisible(shown);
    part.setManaged(shown);
  }

  private String rules() {
    List<String> all = new ArrayList<>();
    if (challenge().inOrder() && challenge().goals().size() > 1) {
      all.add(messages.now("in-order"));
    }
    if (challenge().untouched()) {
      all.add(messages.now("untouched"));
    }
    if (!challenge().goals().isEmpty()) {
      Behavior behavior = simulation.selected().snapshotProperty().get().product().behavior();
      all.add(messages.now("takeoff", Math.round(behavior.takeoffHeight() * 100)));
      all.add(messages.now("plan"));
    }
    return String.join(" ", all);
  }

  private void show() {
    Progress now = progress.getValue();
    if (rows.size() != now.reached().size()) {
      return; // the rows of other goals follow
    }
    for (int i = 0; i < rows.size(); i++) {
      rows.get(i).show(now.reached().get(i), now.state(i) == GoalState.ACTIVE);
    }
    String elapsed = seconds(now.elapsed());
    time.setText(
        challenge().timeLimit().isPresent()
            ? messages.now("time-of", elapsed, limit(challenge().timeLimit().getAsDouble()))
            : messages.now("time", elapsed));
    Status status = now.status();
    banner.pseudoClassStateChanged(REACHED, status == Status.REACHED);
    banner.pseudoClassStateChanged(FAILED, status == Status.FAILED);
    banner.setVisible(status != Status.RUNNING);
    banner.setManaged(status != Status.RUNNING);
    setShown(next, status == Status.REACHED && scenario.next().isPresent());
    banner.setText(
        now.failure()
            .map(reason -> messages.now("failed", language.say(reason)))
            .orElseGet(() -> messages.now("reached", elapsed)));
    advice.setText(advice(now));
  }

  /** After a failure what one can try, and what was nearly reached. */
  private String advice(Progress now) {
    String miss = now.miss().map(what -> messages.now("missed", language.say(what))).orElse("");
    return now.status() == Status.FAILED
        ? (messages.now(adviceAfter(now)) + " " + miss).strip()
        : miss;
  }

  /** The key of what one can try after a failure. */
  private static String adviceAfter(Progress failed) {
    double limit = failed.challenge().timeLimit().orElse(Double.POSITIVE_INFINITY);
    return failed.elapsed() >= limit ? "try.faster" : "try.another-way";
  }

  private String seconds(double seconds) {
    return String.format(language.locale(), "%.1f", seconds);
  }

  /** Without a decimal where it is whole, as it mostly is. */
  private String limit(double seconds) {
    String format = seconds == Math.rint(seconds) ? "%.0f" : "%.1f";
    return String.format(language.locale(), format, seconds);
  }

  private static void onlyWithText(Label label) {
    label.managedProperty().bind(label.textProperty().isNotEmpty());
    label.setMinHeight(USE_PREF_SIZE);
  }

  /**
   * A goal: a square with its number in the room, the task, the drone that must reach it if that is
   * one, and when it was reached. For the JavaFX thread.
   */
  private static final class GoalRow extends HBox {

    private static final PseudoClass REACHED = PseudoClass.getPseudoClass("reached");
    private static final PseudoClass NEXT = PseudoClass.getPseudoClass("next");

    private final Language language;
    private final String styleWhileNext;
    private final Label mark = new Label();
    private final Label task = new Label();
    private final Label time = new Label();

    /**
     * @param index of the goal, from 0
     * @param color of the only drone that may reach it
     * @param said what to do
     */
    GoalRow(
        int index,
        Goal goal,
        Optional<Color> color,
        Language language,
        ObservableValue<String> said) {
      this.language = language;
      styleWhileNext = color.map(DroneColors::badge).orElse("");
      setId("goal-" + (index + 1));
      getStyleClass().add("goal");
      mark.setText(Integer.toString(index + 1));
      mark.getStyleClass().add("mark");
      mark.setMinSize(USE_PREF_SIZE, USE_PREF_SIZE);
      time.setGraphic(new FontIcon(Feather.CHECK));
      time.visibleProperty().bind(time.textProperty().isNotEmpty());
      time.managedProperty().bind(time.visibleProperty());
      task.textProperty().bind(said);
      task.getStyleClass().add("task");
      task.setWrapText(true);
      task.setMaxWidth(Double.MAX_VALUE);
      task.setMinHeight(USE_PREF_SIZE);
      time.setMinWidth(USE_PREF_SIZE);
      time.getStyleClass().add("time");
      HBox.setHgrow(task, Priority.ALWAYS);
      getChildren().addAll(mark, task);
      goal.drone().ifPresent(number -> getChildren().add(drone(number, color)));
      getChildren().add(time);
    }

    /** In full and round, as drones have it in the room, so that it is no goal's number. */
    private Label drone(int number, Optional<Color> color) {
      Label drone = new Label();
      drone.textProperty().bind(language.messages(GoalPanel.class).text("drone", number));
      drone.getStyleClass().add("drone");
      drone.setMinWidth(USE_PREF_SIZE);
      drone.setStyle(color.map(DroneColors::badge).orElse(""));
      return drone;
    }

    /**
     * Shows how it stands.
     *
     * @param reached after how many seconds it was reached; empty if it was not
     * @param next whether it can be reached now
     */
    void show(OptionalDouble reached, boolean next) {
      boolean done = reached.isPresent();
      time.setText(done ? String.format(language.locale(), "%.1f s", reached.getAsDouble()) : "");
      pseudoClassStateChanged(REACHED, done);
      pseudoClassStateChanged(NEXT, next);
      mark.setStyle(next ? styleWhileNext : "");
    }
  }
}
