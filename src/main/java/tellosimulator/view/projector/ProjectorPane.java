package tellosimulator.view.projector;

import atlantafx.base.controls.Spacer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.view.model.LastCommand.Outcome;
import tellosimulator.view.model.LastCommand.Shown;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Goals with their state, the clock, the drones, and the last command with its outcome, in type
 * that is read from ten metres. Takes no mouse. For the JavaFX thread.
 */
public final class ProjectorPane extends BorderPane {

  /**
   * Size of the type as a part of the height. Decided: 8 cm of a picture that is 1.6 m high, whose
   * capitals of 5 cm are read at 10 m (a 200th of the distance).
   */
  private static final double TYPE = 0.05;

  /** Smallest type [px]. Decided: larger than that of panels. */
  private static final double SMALLEST = 18;

  /** With more drones, each says less. Decided: what fits below each other into two rows. */
  private static final int FEW = 4;

  private static final PseudoClass REACHED = PseudoClass.getPseudoClass("reached");
  private static final PseudoClass NEXT = PseudoClass.getPseudoClass("next");
  private static final PseudoClass FAILED = PseudoClass.getPseudoClass("failed");

  private final ViewContext context;
  private final Language language;
  private final Messages messages;
  private final List<Label> marks = new ArrayList<>();
  private final List<DroneChip> drones;
  private final HBox goalRow = new HBox();
  private final Label task = new Label();
  private final VBox goals = new VBox(goalRow, task);
  private final Label clock = new Label();
  private final FlowPane droneRow = new FlowPane();
  private final Label command = new Label();
  private final Label outcome = new Label();
  private final HBox commandRow = new HBox(command, outcome);
  private final VBox bottom = new VBox(droneRow, commandRow);
  private double begun;

  public ProjectorPane(ViewContext context) {
    this.context = context;
    language = context.language();
    messages = language.messages(ProjectorPane.class);
    boolean few = context.simulation().drones().size() <= FEW;
    drones =
        context.simulation().drones().stream()
            .map(drone -> new DroneChip(drone, messages, few))
            .toList();
    initializeSelf();
    initializeParts();
    layoutParts();
    setupBindings();
    context.pulse().onBeat(nanos -> advance());
  }

  /** What lies over the scene. */
  public List<Region> boxes() {
    return List.of(goals, clock, bottom);
  }

  /** Begins anew: the clock at 0, and no command yet. */
  public void restart() {
    begun = context.simulation().secondsProperty().get();
    context.lastCommand().clear();
  }

  private void initializeSelf() {
    setId("projector");
    getStyleClass().add("projector");
    getStylesheets().add(ProjectorPane.class.getResource("projector.css").toExternalForm());
    setMouseTransparent(true);
    setMinSize(0, 0);
  }

  private void initializeParts() {
    goalRow.getStyleClass().add("row");
    task.setId("projector-task");
    task.setWrapText(true);
    clock.setId("projector-clock");
    clock.getStyleClass().add("clock");
    clock.setMinWidth(USE_PREF_SIZE);
    droneRow.getStyleClass().add("row");
    command.setId("projector-command");
    command.getStyleClass().add("command");
    outcome.setId("projector-outcome");
    outcome.getStyleClass().add("outcome");
    outcome.setMinWidth(USE_PREF_SIZE);
    commandRow.setId("projector-command-row");
    commandRow.getStyleClass().add("row");
    commandRow.setMaxWidth(USE_PREF_SIZE);
    goals.setMaxHeight(USE_PREF_SIZE);
    List.of(goals, clock, droneRow, commandRow).forEach(box -> box.getStyleClass().add("box"));
    for (int i = 0; i < challenge().goals().size(); i++) {
      Label mark = new Label(String.valueOf(i + 1));
      mark.setId("projector-goal-" + (i + 1));
      mark.getStyleClass().add("mark");
      marks.add(mark);
    }
  }

  private void layoutParts() {
    goalRow.getChildren().setAll(marks);
    goals.setVisible(!marks.isEmpty());
    droneRow.getChildren().setAll(drones);
    HBox top = new HBox(goals, new Spacer(), clock);
    top.getStyleClass().add("edge");
    bottom.getStyleClass().add("edge");
    setTop(top);
    setBottom(bottom);
  }

  private void setupBindings() {
    heightProperty()
        .subscribe(
            height ->
                setStyle(
                    String.format(
                        Locale.ROOT,
                        "-fx-font-size: %.0fpx",
                        Math.max(SMALLEST, TYPE * height.doubleValue()))));
    visibleProperty().subscribe(this::advance);
    language.localeProperty().subscribe(this::advance);
  }

  private void advance() {
    if (isVisible()) {
      Progress progress = context.scenario().progressProperty().getValue();
      showGoals(progress);
      clock.setText(clock(progress));
      drones.forEach(DroneChip::refresh);
      showCommand(context.lastCommand().newest());
    }
  }

  private void showGoals(Progress progress) {
    int first = -1;
    for (int i = 0; i < marks.size(); i++) {
      boolean reached = progress.reached().get(i).isPresent();
      first = first < 0 && !reached ? i : first;
      boolean next = !reached && (first == i || !challenge().inOrder());
      marks.get(i).pseudoClassStateChanged(REACHED, reached);
      marks.get(i).pseudoClassStateChanged(NEXT, next && progress.status() == Status.RUNNING);
    }
    task.pseudoClassStateChanged(REACHED, progress.status() == Status.REACHED);
    task.pseudoClassStateChanged(FAILED, progress.status() == Status.FAILED);
    task.setText(
        switch (progress.status()) {
          case REACHED -> messages.now("reached");
          case FAILED -> progress.failure().map(language::say).orElse("");
          case RUNNING -> first < 0 ? "" : language.say(challenge().goals().get(first).phrase());
        });
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

  private void showCommand(Optional<Shown> newest) {
    commandRow.setVisible(newest.isPresent());
    newest.ifPresent(
        shown -> {
          String who = drones.size() > 1 ? messages.now("drone", shown.drone()) + "  " : "";
          command.setText(who + shown.text());
          outcome.setText(outcome(shown));
          outcome.pseudoClassStateChanged(REACHED, shown.outcome() == Outcome.DONE);
          outcome.pseudoClassStateChanged(FAILED, shown.outcome() == Outcome.FAILED);
        });
  }

  private String outcome(Shown shown) {
    return switch (shown.outcome()) {
      case RUNNING -> "…";
      case DONE -> shown.reply();
      case FAILED -> shown.reply().isEmpty() ? messages.now("no-answer") : shown.reply();
    };
  }

  private Challenge challenge() {
    return context.scenario().scenario().challenge();
  }
}
