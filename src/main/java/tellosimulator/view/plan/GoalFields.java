package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import javafx.scene.Node;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.view.controls.NumberField;
import tellosimulator.view.controls.NumberRange;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * What the property panel has for goals beside their numbers: who shall do it, through which gate,
 * on which pad, and what holds for all of them. For the JavaFX thread.
 */
final class GoalFields {

  /** Stands for any drone. */
  private static final int ANY = 0;

  private final PropertyEdits edits;
  private final Messages messages;
  private final ComboBox<Integer> drone = new ComboBox<>();
  private final ComboBox<String> gate = new ComboBox<>();
  private final ComboBox<Direction> direction = new ComboBox<>();
  private final ComboBox<Integer> pad = new ComboBox<>();
  private final CheckBox inOrder = new CheckBox();
  private final CheckBox untouched = new CheckBox();
  private final NumberField limit;
  private final VBox rules = new VBox();

  /** Whether the controls change because they show something. */
  private boolean showing;

  GoalFields(PropertyEdits edits, Language language) {
    this.edits = edits;
    this.messages = language.messages(GoalFields.class);
    this.limit =
        new NumberField("goals-time-limit", new NumberRange(0, Challenge.LONGEST, 10), language);
    initializeParts();
    layoutParts();
    setupEventHandlers();
  }

  private void initializeParts() {
    drone.setId("property-drone");
    gate.setId("property-gate");
    direction.setId("property-direction");
    pad.setId("property-pad");
    direction.getItems().setAll(Direction.values());
    for (ComboBox<?> choice : List.of(drone, gate, direction, pad)) {
      choice.setMaxWidth(Double.MAX_VALUE);
    }
    drone.setCellFactory(list -> new NumberCell());
    drone.setButtonCell(new NumberCell());
    direction.setCellFactory(list -> new DirectionCell());
    direction.setButtonCell(new DirectionCell());
    rules.setId("goal-rules-of-plan");
    rules.getStyleClass().add("goal-rules");
    inOrder.setId("goals-in-order");
    untouched.setId("goals-untouched");
    inOrder.textProperty().bind(messages.text("goals-in-order"));
    untouched.textProperty().bind(messages.text("goals-untouched"));
    inOrder.setWrapText(true);
    untouched.setWrapText(true);
  }

  private void layoutParts() {
    Label title = messages.label("goals-all", "title");
    Label label = messages.label("goals-time-limit");
    label.setLabelFor(limit);
    limit.accessibleTextProperty().bind(label.textProperty());
    HBox row = new HBox(label, limit);
    row.getStyleClass().add("row");
    rules.getChildren().addAll(title, inOrder, untouched, row, limit.error());
  }

  private void setupEventHandlers() {
    chosen(drone, (goal, number) -> goal.forDrone(number == ANY ? none() : OptionalInt.of(number)));
    chosen(gate, (goal, name) -> new Goal.Pass(goal.drone(), name, ((Goal.Pass) goal).direction()));
    chosen(direction, (goal, way) -> new Goal.Pass(goal.drone(), ((Goal.Pass) goal).gate(), way));
    chosen(pad, (goal, id) -> new Goal.LandOn(goal.drone(), id));
    inOrder.setOnAction(pressed -> edits.changeRules(all -> all.withInOrder(inOrder.isSelected())));
    untouched.setOnAction(
        pressed -> edits.changeRules(all -> all.withUntouched(untouched.isSelected())));
    limit.onNumber(
        seconds ->
            edits.changeRules(
                all ->
                    all.withTimeLimit(
                        seconds > 0
                            ? OptionalDouble.of(Math.max(1, seconds))
                            : OptionalDouble.empty())));
  }

  private static OptionalInt none() {
    return OptionalInt.empty();
  }

  private interface GoalChange<T> {
    Goal of(Goal goal, T chosen);
  }

  private <T> void chosen(ComboBox<T> choice, GoalChange<T> change) {
    choice.setOnAction(
        event -> {
          T value = choice.getValue();
          if (!showing && value != null) {
            edits.change(goal -> change.of(goal, value));
          }
        });
  }

  /** The controls that have rows of their own, named by their ids. */
  List<Node> choices() {
    return List.of(gate, direction, pad, drone);
  }

  /** What holds for all goals. */
  Node rules() {
    return rules;
  }

  /**
   * Shows a selected item.
   *
   * @param visibility shows or hides the row of a control
   */
  void show(FloorPlan plan, PlanItem item, BiConsumer<Node, Boolean> visibility) {
    Optional<Goal> goal =
        item instanceof GoalItem selected ? Optional.of(plan.goal(selected)) : Optional.empty();
    showing = true;
    rules.setVisible(goal.isPresent());
    rules.setManaged(goal.isPresent());
    visibility.accept(drone, goal.isPresent());
    visibility.accept(gate, goal.filter(Goal.Pass.class::isInstance).isPresent());
    visibility.accept(direction, goal.filter(Goal.Pass.class::isInstance).isPresent());
    visibility.accept(pad, goal.filter(Goal.LandOn.class::isInstance).isPresent());
    goal.ifPresent(selected -> show(plan, selected));
    showing = false;
  }

  private void show(FloorPlan plan, Goal goal) {
    List<Integer> drones = new ArrayList<>(List.of(ANY));
    drones.addAll(IntStream.rangeClosed(1, plan.drones().size()).boxed().toList());
    offer(drone, drones, goal.drone().orElse(ANY));
    if (goal instanceof Goal.Pass pass) {
      List<ObstacleItem> gates = GoalPlacement.gates(plan);
      offer(gate, gates.stream().map(item -> plan.obstacle(item).name()).toList(), pass.gate());
      direction.setValue(pass.direction());
    } else if (goal instanceof Goal.LandOn land) {
      offer(pad, GoalPlacement.pads(plan).stream().map(Pad::id).toList(), land.pad());
    }
    inOrder.setSelected(plan.challenge().inOrder());
    untouched.setSelected(plan.challenge().untouched());
    limit.show(plan.challenge().timeLimit().orElse(0));
  }

  private static <T> void offer(ComboBox<T> choice, List<T> all, T value) {
    if (!all.equals(choice.getItems())) {
      choice.getItems().setAll(all);
    }
    choice.setValue(value);
  }

  /** The number of a drone, or that it may be any. */
  private final class NumberCell extends ListCell<Integer> {

    @Override
    protected void updateItem(Integer number, boolean empty) {
      super.updateItem(number, empty);
      textProperty().unbind();
      if (empty || number == null) {
        setText("");
      } else if (number == ANY) {
        textProperty().bind(messages.text("any-drone"));
      } else {
        setText(String.valueOf(number));
      }
    }
  }

  /** A way through a gate. */
  private final class DirectionCell extends ListCell<Direction> {

    @Override
    protected void updateItem(Direction way, boolean empty) {
      super.updateItem(way, empty);
      textProperty().unbind();
      if (empty || way == null) {
        setText("");
      } else {
        textProperty().bind(messages.text("direction-" + way.name().toLowerCase(Locale.ROOT)));
      }
    }
  }
}
