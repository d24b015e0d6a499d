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
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.goal.Score;
import tellosimulator.profile.Behavior;
import tellosimulator.scenario.Description;
import tellosimulator.scenario.LocalizedText;
import tellosimulator.sim.Control;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The panel that shows the lesson and the goals of a scenario. Each goal is listed with the number
 * that marks it in the room, and with the time at which it was reached. The panel also shows the
 * elapsed time and, at the end, the outcome with advice and the next scenario. The panel is
 * invisible if there are neither goals nor a lesson. Confined to the JavaFX thread.
 */
public final class GoalPanel extends VBox {

  /**
   * Width of the panel [px]. Decided: a goal takes at most two lines, and the room stays visible.
   */
  private static final double WIDTH = 292;

  /**
   * Number of lost points that are shown with their reasons. Decided: the latest ones; the report
   * has all.
   */
  private static final int MOST_REASONS = 4;

  private static final PseudoClass REACHED = PseudoClass.getPseudoClass("reached");
  private static final PseudoClass FAILED = PseudoClass.getPseudoClass("failed");

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Language language;
  private final Messages messages;
  private final ObservableValue<Progress> progress;
  private final FxScenario scenario;
  private final List<GoalRow> rows = new ArrayList<>();
  private final Label name = Nodes.named(new Label(), "scenario-name", "name");
  private final Label teaches = Nodes.named(new Label(), "scenario-teaches", "muted");
  private final Label time = Nodes.unshrinkable(Nodes.named(new Label(), "goal-time"));
  private final Label score = Nodes.named(new Label(), "goal-score", "score");
  private final VBox lost = Nodes.named(new VBox(), "goal-lost");
  private final Label banner = Nodes.named(new Label(), "goal-banner", "banner");
  private final Label advice = Nodes.named(new Label(), "goal-advice");
  private final Label rules = Nodes.named(new Label(), "goal-rules", "muted");
  private final Button again;
  private final Button course = Nodes.named(new Button(), "goal-course");
  private final Button next = Nodes.named(new Button(), "goal-next");
  private final Button fold = Nodes.named(new Button(), "goal-fold", "fold");
  private final VBox details = Nodes.named(new VBox(), "goal-details", "details");
  private final VBox goals = Nodes.styled(new VBox(), "goals");

  /** Whether the details are unfolded. */
  private boolean open = true;

  /** Whether the user has folded or unfolded the details since the current attempt started. */
  private boolean chosen;

  /** The parts that are visible only if there are goals. */
  private List<Region> ofGoals = List.of();

  public GoalPanel(ViewContext context) {
    simulation = context.simulation();
    actions = context.actions();
    language = context.language();
    messages = language.messages(GoalPanel.class);
    progress = context.scenario().progressProperty();
    scenario = context.scenario();
    again =
        Nodes.button(
            "goal-again", Feather.ROTATE_CCW, messages.text("again"), messages.text("again.hint"));
    Nodes.named(this, "goal-panel", "goal-panel");
    getStylesheets().add(GoalPanel.class.getResource("goal.css").toExternalForm());
    Nodes.fixWidth(this, WIDTH);
    setMinHeight(USE_PREF_SIZE);
    initializeParts();
    layoutParts();
    setupBindings();
  }

  /** Moves all drones back to their starts; this restarts the attempt. */
  public void again() {
    simulation.drones().forEach(drone -> actions.carryOut(new Control.Reset(drone.number())));
  }

  private void initializeParts() {
    Nodes.wrapping(name);
    Nodes.growing(name);
    Nodes.wrapping(banner);
    banner.setMaxWidth(Double.MAX_VALUE);
    for (Label label : List.of(teaches, advice, rules, score)) {
      Nodes.wrapping(label).managedProperty().bind(label.textProperty().isNotEmpty());
    }
    again.setOnAction(pressed -> again());
    course.setGraphic(new FontIcon(Feather.SHUFFLE));
    course.textProperty().bind(messages.text("course"));
    course.setOnAction(pressed -> scenario.actions().openNextCourse());
    course.setMaxWidth(Double.MAX_VALUE);
    Nodes.setShown(course, scenario.course().isPresent());
    next.setGraphic(new FontIcon(Feather.ARROW_RIGHT));
    next.textProperty().bind(messages.text("next"));
    next.setOnAction(pressed -> scenario.next().ifPresent(scenario.actions()::openKnown));
    fold.setOnAction(pressed -> choose(!details.isVisible()));
    next.setMaxWidth(Double.MAX_VALUE);
  }

  private void layoutParts() {
    HBox head = Nodes.styled(new HBox(name, fold), "head");
    ScrollPane scroll = new ScrollPane(goals);
    scroll.setFitToWidth(true);
    scroll.setMinViewportHeight(1); // otherwise the minimum is 36 px
    scroll.prefViewportHeightProperty().bind(goals.heightProperty()); // includes wrapped lines
    scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
    scroll.setFocusTraversable(false);
    HBox attempt = Nodes.styled(new HBox(time, new Spacer(), Nodes.unshrinkable(again)), "attempt");
    ofGoals = List.of(scroll, attempt);
    details.getChildren().addAll(teaches, scroll, rules);
    getChildren()
        .addAll( // long names need the whole width
            head, attempt, score, lost, banner, advice, course, next, details);
  }

  /**
   * Unfolds or folds the details, unless the user has done so since the current attempt started.
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
    Nodes.setShown(details, open);
    fold.setGraphic(new FontIcon(open ? Feather.CHEVRON_UP : Feather.CHEVRON_DOWN));
  }

  private void setupBindings() {
    name.textProperty().bind(following(description().name()));
    teaches
        .textProperty()
        .bind(
            following(description().teaches())
                .map(what -> what.isEmpty() ? "" : messages.now("learn", what)));
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

  /** Creates a row for each goal. */
  private void showGoals(Challenge challenge) {
    rows.clear();
    for (int i = 0; i < challenge.goals().size(); i++) {
      Goal goal = challenge.goals().get(i);
      rows.add(
          new GoalRow(i, goal, DroneColors.of(goal, simulation.drones()), language, said(goal)));
    }
    goals.getChildren().setAll(rows);
    boolean asked = !rows.isEmpty();
    ofGoals.forEach(part -> Nodes.setShown(part, asked));
    Nodes.setShown(this, asked || !description().teaches().isEmpty());
    show();
  }

  /** Returns a goal's task and place as a text that follows changes to the room. */
  private ObservableValue<String> said(Goal goal) {
    return Bindings.createStringBinding(
        () -> language.say(PlacedGoal.task(goal, simulation.arenaProperty().get())),
        language.localeProperty(),
        simulation.arenaProperty());
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
    scenario.course().ifPresent(seed -> all.add(messages.now("seed", Long.toString(seed))));
    return String.join(" ", all);
  }

  private void show() {
    Progress now = progress.getValue();
    if (rows.size() != now.reached().size()) {
      return; // the rows do not match the new goals yet
    }
    for (int i = 0; i < rows.size(); i++) {
      rows.get(i).show(now.reached().get(i), now.state(i) == GoalState.ACTIVE);
    }
    String elapsed = seconds(now.elapsed());
    time.setText(
        challenge().timeLimit().isPresent()
            ? messages.now("time-of", elapsed, limit(challenge().timeLimit().getAsDouble()))
            : messages.now("time", elapsed));
    showScore(now);
    Status status = now.status();
    banner.pseudoClassStateChanged(REACHED, status == Status.REACHED);
    banner.pseudoClassStateChanged(FAILED, status == Status.FAILED);
    Nodes.setShown(banner, status != Status.RUNNING);
    Nodes.setShown(next, status == Status.REACHED && scenario.next().isPresent());
    banner.setText(
        now.failure()
            .map(reason -> messages.now("failed", language.say(reason)))
            .orElseGet(() -> messages.now("reached", elapsed)));
    advice.setText(advice(now));
  }

  /** Shows the points, and why some were lost. */
  private void showScore(Progress now) {
    score.setText(
        now.score()
            .map(each -> messages.now("score", number(each.points()), number(each.of())))
            .orElse(""));
    List<Score.Entry> reasons = now.penaltiesAndBonus();
    int first = Math.max(0, reasons.size() - MOST_REASONS);
    List<Label> lines = new ArrayList<>();
    if (first > 0) {
      lines.add(new Label(messages.now("score.earlier", first)));
    }
    for (Score.Entry entry : reasons.subList(first, reasons.size())) {
      String points = (entry.points() > 0 ? "+" : "−") + number(Math.abs(entry.points()));
      String second = seconds(entry.second());
      String why = language.say(entry.why());
      Label line = Nodes.wrapping(new Label(messages.now("score.entry", points, second, why)));
      line.pseudoClassStateChanged(REACHED, entry.points() > 0);
      lines.add(line);
    }
    lost.getChildren().setAll(lines);
    Nodes.setShown(lost, !lines.isEmpty());
  }

  private String number(double points) {
    return language.say(Score.number(points));
  }

  /**
   * Returns advice if the attempt has failed, followed by the goal that was narrowly missed, if
   * any.
   */
  private String advice(Progress now) {
    String miss = now.miss().map(what -> messages.now("missed", language.say(what))).orElse("");
    return now.status() == Status.FAILED
        ? (messages.now(adviceAfter(now)) + " " + miss).strip()
        : miss;
  }

  /** Returns the key of the advice after a failure. */
  private static String adviceAfter(Progress failed) {
    double limit = failed.challenge().timeLimit().orElse(Double.POSITIVE_INFINITY);
    return failed.elapsed() >= limit ? "try.faster" : "try.another-way";
  }

  private String seconds(double seconds) {
    return String.format(language.locale(), "%.1f", seconds);
  }

  /** Formats a time limit, with a decimal only if it is not whole. */
  private String limit(double seconds) {
    String format = seconds == Math.rint(seconds) ? "%.0f" : "%.1f";
    return String.format(language.locale(), format, seconds);
  }

  /**
   * A row for a goal. It shows the number of the goal in a square, as in the room; the task; the
   * drone, if only one drone may reach the goal; and the time at which the goal was reached.
   * Confined to the JavaFX thread.
   */
  private static final class GoalRow extends HBox {

    private static final PseudoClass REACHED = PseudoClass.getPseudoClass("reached");
    private static final PseudoClass NEXT = PseudoClass.getPseudoClass("next");

    private final Language language;
    private final String styleWhileNext;
    private final Label mark = Nodes.styled(new Label(), "mark");
    private final Label task = Nodes.styled(new Label(), "task");
    private final Label time = new Label();

    /**
     * @param index the index of the goal, from 0
     * @param color the colour of the only drone that may reach the goal; empty if any drone may
     * @param said the text of the task
     */
    GoalRow(
        int index,
        Goal goal,
        Optional<Color> color,
        Language language,
        ObservableValue<String> said) {
      this.language = language;
      styleWhileNext = color.map(DroneColors::badge).orElse("");
      Nodes.named(this, "goal-" + (index + 1), "goal");
      mark.setText(Integer.toString(index + 1));
      mark.setMinSize(USE_PREF_SIZE, USE_PREF_SIZE);
      time.setGraphic(new FontIcon(Feather.CHECK));
      Nodes.showIf(time, time.textProperty().isNotEmpty());
      task.textProperty().bind(said);
      Nodes.growing(Nodes.wrapping(task));
      Nodes.styled(Nodes.unshrinkable(time), "time");
      getChildren().addAll(mark, task);
      goal.drone().ifPresent(number -> getChildren().add(drone(number, color)));
      if (goal.terms().points() > 0) {
        getChildren().add(points(goal.terms().points()));
      }
      getChildren().add(time);
    }

    /**
     * Returns the label of the drone that must reach the goal. To be distinguishable from the
     * number of a goal, the label is rounded and contains the word for "drone" before the number.
     */
    private Label drone(int number, Optional<Color> color) {
      Label drone = Nodes.unshrinkable(Nodes.styled(new Label(), "drone"));
      drone.textProperty().bind(language.messages(GoalPanel.class).text("drone", number));
      drone.setStyle(color.map(DroneColors::badge).orElse(""));
      return drone;
    }

    /** Returns the label of the points: a number with a short unit, as rows are narrow. */
    private Label points(double points) {
      Label label = Nodes.unshrinkable(Nodes.styled(new Label(), "points"));
      Messages messages = language.messages(GoalPanel.class);
      label
          .textProperty()
          .bind(
              language
                  .localeProperty()
                  .map(now -> messages.now("points", language.say(Score.number(points)))));
      return label;
    }

    /**
     * Shows the state of the goal.
     *
     * @param reached the time at which the goal was reached [s]; empty if it has not been reached
     * @param next whether the goal can be reached now
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
