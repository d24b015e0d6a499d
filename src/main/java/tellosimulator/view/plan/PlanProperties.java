package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import javafx.scene.Node;
import javafx.scene.control.ColorPicker;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import tellosimulator.view.controls.NumberField;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Obstacle;

/**
 * The property panel of the plan: name, place, size, colour and number of the item that was
 * selected last. It takes no room while nothing is selected. For the JavaFX thread.
 */
final class PlanProperties extends VBox {

  private final PlanEditor editor;
  private final PropertyEdits edits;
  private final Messages messages;
  private final TextField name = new TextField();
  private final ComboBox<Integer> number = new ComboBox<>();
  private final ColorPicker color = new ColorPicker();
  private final Map<ItemProperty, NumberField> numbers = new EnumMap<>(ItemProperty.class);
  private final Map<Node, List<Node>> rows = new LinkedHashMap<>();
  private final GridPane grid = new GridPane();
  private final GoalFields goal;
  private final IntFunction<Color> colors;

  /** Whether the controls change because they show something. */
  private boolean showing;

  /**
   * @param colors gives that of the drone of a number
   */
  PlanProperties(PlanEditor editor, Language language, IntFunction<Color> colors) {
    this.colors = colors;
    this.editor = editor;
    this.edits = new PropertyEdits(editor);
    this.goal = new GoalFields(edits, language);
    this.messages = language.messages(PlanProperties.class);
    for (ItemProperty property : ItemProperty.values()) {
      numbers.put(property, new NumberField(id(property), property.range(), language));
    }
    initializeSelf();
    layoutParts();
    setupEventHandlers();
    setupBindings();
    show();
  }

  private void initializeSelf() {
    setId("plan-properties");
    getStyleClass().add("plan-properties");
    grid.getStyleClass().add("rows");
    name.setId("property-name");
    number.setId("property-number");
    color.setId("property-color");
    number.setMaxWidth(Double.MAX_VALUE);
    color.setMaxWidth(Double.MAX_VALUE);
  }

  private void layoutParts() {
    addRow(name);
    addRow(number);
    goal.choices().forEach(this::addRow);
    numbers.values().forEach(this::addRow);
    addRow(color);
    getChildren().addAll(grid, goal.rules());
  }

  private void addRow(Node control) {
    Label label = new Label();
    label.textProperty().bind(messages.text(control.getId()));
    label.setLabelFor(control);
    control.accessibleTextProperty().bind(label.textProperty());
    int row = 2 * rows.size();
    grid.addRow(row, label, control);
    List<Node> parts = new ArrayList<>(List.of(label, control));
    if (control instanceof NumberField number) {
      grid.add(number.error(), 0, row + 1, 2, 1);
    }
    rows.put(control, parts);
  }

  private void setupEventHandlers() {
    name.setOnAction(entered -> rename());
    name.focusedProperty()
        .addListener(
            (property, before, focused) -> {
              if (!focused) {
                rename();
              }
            });
    number.setOnAction(
        chosen -> {
          if (!showing && number.getValue() != null) {
            edits.renumber(number.getValue());
            show();
          }
        });
    color.setOnAction(
        chosen -> {
          if (!showing) {
            edits.paint(rgb(color.getValue()));
          }
        });
    numbers.forEach(
        (property, field) ->
            field.onNumber(
                value -> {
                  edits.change(property, value);
                  show(); // what it has become, or still is
                }));
  }

  private void setupBindings() {
    visibleProperty().bind(editor.selectionProperty().map(items -> !items.isEmpty()));
    editor.selectionProperty().addListener((property, before, now) -> show());
    editor.planProperty().addListener((property, before, now) -> show());
  }

  /** Puts the keys into the first field. */
  void edit() {
    rows.keySet().stream().filter(Node::isVisible).findFirst().ifPresent(Node::requestFocus);
  }

  private void rename() {
    String wanted = name.getText().strip();
    if (!wanted.isEmpty() && !showing) {
      edits.rename(wanted);
    }
    show();
  }

  private void show() {
    Optional<PlanItem> selected = editor.selected().filter(editor.plan()::has);
    if (selected.isEmpty()) {
      return;
    }
    FloorPlan plan = editor.plan();
    PlanItem item = selected.get();
    showing = true;
    numbers.forEach(
        (property, field) -> {
          OptionalDouble number = property.of(plan, item);
          setShown(field, number.isPresent());
          number.ifPresent(field::show);
        });
    showObstacle(
        item instanceof ObstacleItem body ? Optional.of(plan.obstacle(body)) : Optional.empty());
    showNumber(plan, item);
    showColor(plan, item);
    goal.show(plan, item, this::setShown);
    showing = false;
  }

  private void showObstacle(Optional<Obstacle> obstacle) {
    setShown(name, obstacle.isPresent());
    obstacle
        .filter(shown -> !name.getText().equals(shown.name()))
        .ifPresent(shown -> name.setText(shown.name()));
  }

  private void showNumber(FloorPlan plan, PlanItem item) {
    List<Integer> all = new ArrayList<>();
    int now = 0;
    if (item instanceof Pad pad) {
      now = pad.id();
      all.addAll(plan.freePadIds());
      all.add(now);
      all.sort(null);
    } else if (item instanceof GoalItem numbered) {
      now = numbered.index() + 1;
      all.addAll(IntStream.rangeClosed(1, plan.goals().size()).boxed().toList());
    } else if (item instanceof Start start) {
      now = start.drone();
      all.addAll(IntStream.rangeClosed(1, plan.drones().size()).boxed().toList());
    }
    setShown(number, !all.isEmpty());
    if (!all.equals(number.getItems())) {
      number.getItems().setAll(all);
    }
    number.setValue(now);
  }

  private void showColor(FloorPlan plan, PlanItem item) {
    setShown(color, item instanceof ObstacleItem || item instanceof Start);
    if (item instanceof ObstacleItem body) {
      int rgb = plan.obstacle(body).appearance().rgb();
      color.setValue(Color.rgb(rgb >> 16 & 0xff, rgb >> 8 & 0xff, rgb & 0xff));
    } else if (item instanceof Start start) {
      color.setValue(colors.apply(start.drone()));
    }
  }

  private void setShown(Node control, boolean shown) {
    for (Node part : rows.get(control)) {
      part.setVisible(shown);
      part.setManaged(shown);
    }
  }

  private static int rgb(Color color) {
    return (int) Math.round(255 * color.getRed()) << 16
        | (int) Math.round(255 * color.getGreen()) << 8
        | (int) Math.round(255 * color.getBlue());
  }

  private static String id(ItemProperty property) {
    return "property-" + property.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
