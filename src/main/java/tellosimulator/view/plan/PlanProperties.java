package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import javafx.scene.Node;
import javafx.scene.control.ColorPicker;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import tellosimulator.view.controls.NumberField;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Obstacle;

/**
 * The property panel of the plan: name, place, size, colour and number of the item that was
 * selected last. It takes no room while nothing is selected. For the JavaFX thread.
 */
final class PlanProperties extends VBox {

  private final PlanEditor editor;
  private final Messages messages;
  private final TextField name = new TextField();
  private final ComboBox<Integer> padId = new ComboBox<>();
  private final ColorPicker color = new ColorPicker();
  private final Map<ItemProperty, NumberField> numbers = new EnumMap<>(ItemProperty.class);
  private final Map<Node, List<Node>> rows = new LinkedHashMap<>();
  private final GridPane grid = new GridPane();

  /** Whether the controls change because they show something. */
  private boolean showing;

  PlanProperties(PlanEditor editor, Language language) {
    this.editor = editor;
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
    padId.setId("property-pad");
    color.setId("property-color");
    padId.setMaxWidth(Double.MAX_VALUE);
    color.setMaxWidth(Double.MAX_VALUE);
  }

  private void layoutParts() {
    addRow(name);
    addRow(padId);
    numbers.values().forEach(this::addRow);
    addRow(color);
    getChildren().add(grid);
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
    padId.setOnAction(
        chosen -> {
          if (!showing && padId.getValue() != null) {
            editor.renumber(padId.getValue());
            show();
          }
        });
    color.setOnAction(
        chosen -> {
          if (!showing) {
            editor.paint(rgb(color.getValue()));
          }
        });
    numbers.forEach(
        (property, field) ->
            field.onNumber(
                value -> {
                  editor.change(property, value);
                  show(); // what it has become, or still is
                }));
  }

  private void setupBindings() {
    visibleProperty().bind(editor.selectionProperty().map(items -> !items.isEmpty()));
    managedProperty().bind(visibleProperty());
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
      editor.rename(wanted);
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
    setShown(padId, item instanceof Pad);
    if (item instanceof Pad pad) {
      List<Integer> ids = new ArrayList<>(plan.freePadIds());
      ids.add(pad.id());
      ids.sort(null);
      padId.getItems().setAll(ids);
      padId.setValue(pad.id());
    }
    showing = false;
  }

  private void showObstacle(Optional<Obstacle> obstacle) {
    setShown(name, obstacle.isPresent());
    setShown(color, obstacle.isPresent());
    obstacle.ifPresent(
        shown -> {
          if (!name.getText().equals(shown.name())) {
            name.setText(shown.name());
          }
          int rgb = shown.cover().rgb();
          color.setValue(Color.rgb(rgb >> 16 & 0xff, rgb >> 8 & 0xff, rgb & 0xff));
        });
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
