package tellosimulator.view.projector;

import atlantafx.base.controls.Spacer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javafx.application.Platform;
import javafx.css.PseudoClass;
import javafx.geometry.Insets;
import javafx.geometry.Orientation;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.layout.Background;
import javafx.scene.layout.BackgroundFill;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.CornerRadii;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.goal.Score;
import tellosimulator.model.FlightPhase;
import tellosimulator.view.controls.LastCommandRow;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.words.Phrase;

/**
 * Shows the goals with their states, the clock, the drones, and the last command with its outcome,
 * in type large enough to read from 10 m. Ignores the mouse. Confined to the JavaFX thread.
 */
public final class ProjectorPane extends BorderPane {

  /**
   * Font size as a fraction of the height. Decided: 8 cm on an image that is 1.6 m high. Capitals
   * are then 5 cm high and readable at 10 m (a 200th of the distance).
   */
  private static final double TYPE = 0.05;

  /** Minimum font size [px]. Decided: larger than in panels. */
  private static final double SMALLEST = 18;

  /** Maximum number of drones at which the scene is visible between the drones' chips. Decided. */
  private static final int FEW = 4;

  private static final PseudoClass REACHED = PseudoClass.getPseudoClass("reached");
  private static final PseudoClass NEXT = PseudoClass.getPseudoClass("next");
  private static final PseudoClass FAILED = PseudoClass.getPseudoClass("failed");

  private final ViewContext context;
  private final Language language;
  private final Messages messages;
  private final List<Label> marks = new ArrayList<>();
  private final List<DroneChip> drones;
  private final HBox goalRow = Nodes.styled(new HBox(), "row");
  private final Label task = Nodes.named(new Label(), "projector-task");
  private final Label score = Nodes.named(new Label(), "projector-score");
  private final Label lost = Nodes.named(new Label(), "projector-lost");
  private final VBox goals = new VBox(goalRow, task, score, lost);
  private final Label clock = Nodes.named(new Label(), "projector-clock", "clock");
  private final FlowPane droneRow = Nodes.styled(new FlowPane(), "row");
  private final LastCommandRow command;
  private final VBox bottom = Nodes.styled(new VBox(), "edge");
  private double begun;

  public ProjectorPane(ViewContext context) {
    this.context = context;
    language = context.language();
    messages = language.messages(ProjectorPane.class);
    command = new LastCommandRow(context, "projector-command", Orientation.VERTICAL);
    int count = context.simulation().drones().size();
    drones =
        context.simulation().drones().stream()
            .map(drone -> new DroneChip(drone, messages, count))
            .toList();
    Nodes.named(this, "projector", "projector");
    getStylesheets().add(ProjectorPane.class.getResource("projector.css").toExternalForm());
    setMouseTransparent(true);
    setMinSize(0, 0);
    initializeParts();
    layoutParts();
    setupBindings();
    context.ticker().onTick(nanos -> advance());
  }

  /**
   * Returns the areas that cover the scene: the individual boxes, or the whole bottom row if there
   * are many drones.
   */
  public List<Region> boxes() {
    List<Region> boxes = new ArrayList<>(List.of(goals, clock));
    if (drones.size() <= FEW) {
      boxes.addAll(drones);
      boxes.add(command);
    } else {
      boxes.add(bottom);
    }
    return boxes;
  }

  /** Restarts the clock at 0 and clears the last command. */
  public void restart() {
    begun = context.simulation().secondsProperty().get();
    context.lastCommand().clear();
  }

  private void initializeParts() {
    task.setWrapText(true);
    clock.setMinWidth(USE_PREF_SIZE);
    for (Label optional : List.of(lost, score)) {
      Nodes.wrapping(optional).managedProperty().bind(optional.textProperty().isNotEmpty());
    }
    command.getStyleClass().add("row");
    command.setMaxWidth(USE_PREF_SIZE);
    goals.setMaxHeight(USE_PREF_SIZE);
    List.of(goals, clock, command).forEach(box -> box.getStyleClass().add("box"));
    drones.forEach(chip -> chip.getStyleClass().add("box"));
  }

  private void layoutParts() {
    HBox top = Nodes.styled(new HBox(goals, new Spacer(), clock), "edge");
    droneRow.getChildren().setAll(drones);
    droneRow.getChildren().add(command); // in the same row, to cover less of the scene
    bottom.getChildren().setAll(droneRow);
    setTop(top);
    setBottom(bottom);
  }

  /** Creates a mark for each goal. */
  private void showMarks(Challenge challenge) {
    marks.clear();
    for (int i = 1; i <= challenge.goals().size(); i++) {
      Label mark = Nodes.named(new Label(String.valueOf(i)), "projector-goal-" + i, "mark");
      mark.setContentDisplay(ContentDisplay.RIGHT);
      marks.add(mark);
    }
    goalRow.getChildren().setAll(marks);
    goals.setVisible(!marks.isEmpty());
  }

  private void setupBindings() {
    context.scenario().challengeProperty().subscribe(this::showMarks);
    heightProperty()
        .subscribe(
            height ->
                setStyle(
                    String.format(
                        Locale.ROOT,
                        "-fx-font-size: %.0fpx",
                        Math.max(SMALLEST, TYPE * height.doubleValue()))));
    Stream.concat(Stream.of(goals, clock, command), drones.stream()).forEach(this::keepLargest);
    visibleProperty().subscribe(this::advance);
    language.localeProperty().subscribe(this::advance);
  }

  /**
   * Prevents a box from shrinking until the view is resized. Otherwise the camera would move,
   * because it is fitted to the free space.
   */
  private void keepLargest(Region box) {
    double narrowest = box.getMinWidth();
    double lowest = box.getMinHeight();
    box.widthProperty()
        .subscribe(width -> box.setMinWidth(Math.max(box.getMinWidth(), width.doubleValue())));
    box.heightProperty()
        .subscribe(height -> box.setMinHeight(Math.max(box.getMinHeight(), height.doubleValue())));
    Runnable letGo =
        () -> {
          box.setMinWidth(narrowest);
          box.setMinHeight(lowest);
        };
    Stream.of(widthProperty(), heightProperty())
        .forEach(
            size ->
                size.subscribe(
                    () -> {
                      letGo.run();
                      Platform.runLater(letGo); // once more after the font has changed
                    }));
  }

  private void advance() {
    if (isVisible()) {
      Progress progress = context.scenario().progressProperty().getValue();
      showGoals(progress);
      clock.setText(clock(progress));
      drones.forEach(DroneChip::refresh);
    }
  }

  private void showGoals(Progress progress) {
    int first = -1;
    for (int i = 0; i < marks.size(); i++) {
      boolean reached = progress.reached().get(i).isPresent();
      first = first < 0 && !reached ? i : first;
      boolean next = !reached && (first == i || !challenge().inOrder());
      showMark(i, reached, next && progress.status() == Status.RUNNING);
    }
    task.pseudoClassStateChanged(REACHED, progress.status() == Status.REACHED);
    task.pseudoClassStateChanged(FAILED, progress.status() == Status.FAILED);
    task.setText(
        switch (progress.status()) {
          case REACHED -> messages.now("reached");
          case FAILED -> progress.failure().map(language::say).orElse("");
          case RUNNING -> first < 0 ? "" : said(challenge().goals().get(first));
        });
    showScore(progress);
  }

  /** Shows the points, and why points were last lost. */
  private void showScore(Progress progress) {
    score.setText(
        progress
            .score()
            .map(each -> messages.now("score", number(each.points()), number(each.of())))
            .orElse(""));
    String reason = "";
    for (Score.Entry entry : progress.penaltiesAndBonus()) {
      if (entry.points() < 0) {
        reason = messages.now("lost", number(-entry.points()), language.say(entry.why()));
      }
    }
    lost.setText(reason);
  }

  private String number(double points) {
    return language.say(Score.number(points));
  }

  /** Returns the task of a goal, with its place and drone. */
  private String said(Goal goal) {
    Phrase task = PlacedGoal.task(goal, context.simulation().arenaProperty().get());
    return language.say(goal.said(task));
  }

  /**
   * Updates a mark. A reached goal has a tick beside its number, as in the goal panel. A goal that
   * can be reached next has the colour of its drone, as in the room, if it is assigned to a
   * specific drone.
   */
  private void showMark(int index, boolean reached, boolean next) {
    Label mark = marks.get(index);
    mark.pseudoClassStateChanged(REACHED, reached);
    if (reached != (mark.getGraphic() != null)) {
      mark.setGraphic(reached ? new FontIcon(Feather.CHECK) : null);
    }
    mark.pseudoClassStateChanged(NEXT, next);
    mark.setStyle(
        next
            ? DroneColors.of(challenge().goals().get(index), context.simulation().drones())
                .map(DroneColors::badge)
                .orElse("")
            : "");
  }

  private String clock(Progress progress) {
    if (marks.isEmpty()) {
      return minutes(context.simulation().secondsProperty().get() - begun);
    }
    String elapsed = minutes(progress.elapsed());
    return challenge().timeLimit().isPresent()
        ? messages.now("time-of", elapsed, minutes(challenge().timeLimit().getAsDouble()))
        : elapsed;
  }

  private static String minutes(double seconds) {
    long whole = (long) Math.max(0, seconds);
    return String.format(Locale.ROOT, "%d:%02d", whole / 60, whole % 60);
  }

  private Challenge challenge() {
    return context.scenario().challenge();
  }

  /**
   * Shows a drone in large type: its number on a badge in its colour, its flight phase, and its
   * battery.
   */
  private static final class DroneChip extends HBox {

    private static final PseudoClass IN_TROUBLE = PseudoClass.getPseudoClass("in-trouble");
    private static final PseudoClass LOW = PseudoClass.getPseudoClass("low");

    /**
     * Level below which the battery counts as low [%]. Decided: the drone still has time to land.
     */
    private static final double LOW_PERCENT = 20;

    /**
     * Minimum number of drones at which chips hide a battery that is not low. Decided: numbers
     * alone fit into two rows.
     */
    private static final int MANY = 8;

    private final FxDroneModel drone;
    private final Messages messages;
    private final int drones;
    private final Label state = new Label();
    private final Label battery = new Label();

    /**
     * Creates a chip.
     *
     * @param drones the number of chips. A single chip always shows the flight phase; one of
     *     several shows it only during a fall and after a crash. If there are many, a chip shows
     *     the battery only while it is low.
     */
    DroneChip(FxDroneModel drone, Messages messages, int drones) {
      this.drone = drone;
      this.messages = messages;
      this.drones = drones;
      Nodes.collapsible(state);
      Nodes.collapsible(battery);
      Color color = DroneColors.of(drone);
      Label number = Nodes.styled(new Label(String.valueOf(drone.number())), "badge");
      number.setTextFill(DroneColors.inkOn(color));
      number.setBackground(
          new Background(new BackgroundFill(color, new CornerRadii(50, true), Insets.EMPTY)));
      Nodes.named(this, "projector-drone-" + drone.number(), "chip");
      setMinWidth(USE_PREF_SIZE);
      getChildren().addAll(number, state, battery);
    }

    /** Updates the chip from the drone's state. */
    void refresh() {
      FlightPhase phase = drone.phaseProperty().get();
      state.setText(messages.now("phase." + phase.name().toLowerCase(Locale.ROOT)));
      boolean inTrouble = phase == FlightPhase.FALLING || phase == FlightPhase.CRASHED;
      pseudoClassStateChanged(IN_TROUBLE, inTrouble);
      state.setVisible(drones == 1 || inTrouble);
      double percent = drone.batteryPercentProperty().get();
      battery.setText(messages.now("battery", percent));
      battery.pseudoClassStateChanged(LOW, percent < LOW_PERCENT);
      battery.setVisible(drones < MANY || percent < LOW_PERCENT);
    }
  }
}
