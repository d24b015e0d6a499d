package tellosimulator.view.projector;

import atlantafx.base.controls.Spacer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javafx.application.Platform;
import javafx.css.PseudoClass;
import javafx.geometry.Orientation;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.view.controls.LastCommandRow;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.words.Phrase;

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

  /** So many drones leave room beside them. Decided. */
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
  private final LastCommandRow command;
  private final VBox bottom = new VBox();
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
    initializeSelf();
    initializeParts();
    layoutParts();
    setupBindings();
    context.pulse().onBeat(nanos -> advance());
  }

  /** What lies over the scene: each box for itself, if they do not fill rows. */
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
    command.getStyleClass().add("row");
    command.setMaxWidth(USE_PREF_SIZE);
    goals.setMaxHeight(USE_PREF_SIZE);
    List.of(goals, clock, command).forEach(box -> box.getStyleClass().add("box"));
    drones.forEach(chip -> chip.getStyleClass().add("box"));
  }

  private void layoutParts() {
    HBox top = new HBox(goals, new Spacer(), clock);
    top.getStyleClass().add("edge");
    droneRow.getChildren().setAll(drones);
    droneRow.getChildren().add(command); // in the same row, which leaves more of the picture free
    bottom.getChildren().setAll(droneRow);
    bottom.getStyleClass().add("edge");
    setTop(top);
    setBottom(bottom);
  }

  /** A mark for each goal. */
  private void showMarks(Challenge challenge) {
    marks.clear();
    for (int i = 1; i <= challenge.goals().size(); i++) {
      Label mark = new Label(String.valueOf(i));
      mark.setId("projector-goal-" + i);
      mark.getStyleClass().add("mark");
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
   * A box only grows until the view changes its size, or the camera, fitted beside it, would move.
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
                      Platform.runLater(letGo); // once more, when the type has its new size
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
  }

  /** What to do and where, and which drone. */
  private String said(Goal goal) {
    Phrase task = GoalMark.task(goal, context.simulation().arenaProperty().get());
    return language.say(goal.said(task));
  }

  /**
   * One that is reached has a tick beside its number, as in the goal panel. A goal of one drone has
   * its colour while it is next, as in the room.
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
}
