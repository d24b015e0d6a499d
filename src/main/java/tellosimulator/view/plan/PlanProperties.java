package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import javafx.beans.binding.Bindings;
import javafx.scene.control.ColorPicker;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Control;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.TextField;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import tellosimulator.goal.Goal.Direction;
import tellosimulator.goal.Goal.Target;
import tellosimulator.view.controls.NumberField;
import tellosimulator.view.plan.ItemProperty.Choice;
import tellosimulator.view.plan.ItemProperty.Measure;
import tellosimulator.view.plan.ItemProperty.Name;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The property panel of the plan, with a row for each property of the item that was selected last.
 * It takes no space while nothing is selected. Confined to the JavaFX thread.
 */
final class PlanProperties extends VBox {

  private final PlanEditor editor;
  private final Language language;
  private final Messages messages;
  private final IntFunction<Color> colors;
  private final GridPane grid = new GridPane();
  private final GoalRules rules;

  /** The rows by the keys of their properties, created when they are first shown. */
  private final Map<String, Row<?>> rows = new HashMap<>();

  private List<Row<?>> shown = List.of();

  /** Whether the program is updating the controls, so that their changes are not user input. */
  private boolean showing;

  /**
   * Creates a panel.
   *
   * @param colors returns the colour of a drone, given its number
   */
  PlanProperties(PlanEditor editor, Language language, IntFunction<Color> colors) {
    this.editor = editor;
    this.language = language;
    this.messages = language.messages(PlanProperties.class);
    this.colors = colors;
    this.rules = new GoalRules(editor, language);
    setId("plan-properties");
    getStyleClass().add("plan-properties");
    grid.getStyleClass().add("rows");
    getChildren().addAll(grid, rules);
    setupBindings();
    show();
  }

  private void setupBindings() {
    visibleProperty().bind(editor.selectionProperty().map(items -> !items.isEmpty()));
    rules.managedProperty().bind(rules.visibleProperty());
    editor.selectionProperty().addListener((property, before, now) -> show());
    editor.planProperty().addListener((property, before, now) -> show());
  }

  /** Moves the keyboard focus to the first field. */
  void edit() {
    shown.stream().findFirst().ifPresent(row -> row.control.requestFocus());
  }

  private void show() {
    editor.selected().filter(editor.plan()::has).ifPresent(this::show);
  }

  private void show(PlanItem item) {
    showing = true;
    List<Row<?>> wanted = new ArrayList<>();
    for (ItemProperty<?> property : ItemProperties.of(editor.plan(), item, colors)) {
      Row<?> row = rows.computeIfAbsent(property.key(), key -> row(property));
      row.show(property);
      wanted.add(row);
    }
    if (!wanted.equals(shown)) {
      shown = wanted;
      layoutRows();
    }
    rules.setVisible(item instanceof GoalItem);
    rules.show(editor.plan().challenge());
    showing = false;
  }

  private void layoutRows() {
    grid.getChildren().clear();
    for (Row<?> row : shown) {
      int line = grid.getRowCount();
      grid.addRow(line, row.label, row.control);
      if (row.control instanceof NumberField number) {
        grid.add(number.error(), 0, line + 1, 2, 1);
      }
    }
  }

  /** A row of the panel: a label, and a control that edits a property. */
  private final class Row<V> {

    private final Control control;
    private final Consumer<ItemProperty<V>> shower;
    private final Label label;
    private ItemProperty<V> property;

    Row(String key, Control control, Consumer<ItemProperty<V>> shower) {
      this.control = control;
      this.shower = shower;
      this.label = messages.label("property-" + key);
      control.setId("property-" + key);
      control.accessibleTextProperty().bind(label.textProperty());
      label.setLabelFor(control);
    }

    @SuppressWarnings("unchecked") // all values of a key have the same type
    void show(ItemProperty<?> newest) {
      property = (ItemProperty<V>) newest;
      shower.accept(property);
    }

    /**
     * Requests a change of the item, then shows the item's actual value, which is the old one if
     * the change was refused.
     */
    void change(V value) {
      if (showing) {
        return;
      }
      PlanChange change = property.with().apply(value);
      if (property instanceof Measure) {
        editor.tryOut(change.plan());
      } else {
        editor.change(change);
      }
      PlanProperties.this.show();
    }
  }

  private Row<?> row(ItemProperty<?> property) {
    if (property instanceof Measure measure) {
      return measure(measure);
    } else if (property instanceof Choice<?> choice) {
      return choice(choice);
    }
    return property instanceof Name ? name(property.key()) : paint(property.key());
  }

  private Row<Double> measure(Measure first) {
    NumberField field = new NumberField("property-" + first.key(), first.range(), language);
    Row<Double> row = new Row<>(first.key(), field, property -> field.show(property.value()));
    field.onNumber(row::change);
    return row;
  }

  private <V> Row<V> choice(Choice<V> first) {
    ComboBox<V> choice = new ComboBox<>();
    choice.setMaxWidth(Double.MAX_VALUE);
    choice.setCellFactory(list -> new ChoiceCell<>());
    choice.setButtonCell(new ChoiceCell<>());
    Row<V> row =
        new Row<>(
            first.key(),
            choice,
            property -> {
              List<V> options = ((Choice<V>) property).options();
              if (!options.equals(choice.getItems())) {
                choice.getItems().setAll(options);
              }
              choice.setValue(property.value());
            });
    choice.setOnAction(
        chosen -> {
          if (choice.getValue() != null) {
            row.change(choice.getValue());
          }
        });
    return row;
  }

  private Row<String> name(String key) {
    TextField field = new TextField();
    Row<String> row =
        new Row<>(
            key,
            field,
            property -> {
              if (!field.getText().equals(property.value())) {
                field.setText(property.value());
              }
            });
    Runnable rename =
        () -> {
          String typed = field.getText().strip();
          row.change(typed.isEmpty() ? row.property.value() : typed);
        };
    field.setOnAction(entered -> rename.run());
    field
        .focusedProperty()
        .addListener(
            (property, before, focused) -> {
              if (!focused) {
                rename.run();
              }
            });
    return row;
  }

  private Row<Color> paint(String key) {
    ColorPicker picker = new ColorPicker();
    picker.setMaxWidth(Double.MAX_VALUE);
    Row<Color> row = new Row<>(key, picker, property -> picker.setValue(property.value()));
    picker.setOnAction(chosen -> row.change(picker.getValue()));
    return row;
  }

  /** A list cell that shows a name, a number, a direction through a gate, or a target. */
  private final class ChoiceCell<V> extends ListCell<V> {

    @Override
    protected void updateItem(V value, boolean empty) {
      super.updateItem(value, empty);
      textProperty().unbind();
      if (empty || value == null) {
        setText("");
      } else {
        textProperty()
            .bind(Bindings.createStringBinding(() -> text(value), language.localeProperty()));
      }
    }
  }

  private String text(Object value) {
    if (value instanceof Direction way) {
      return messages.now("direction-" + way.name().toLowerCase(Locale.ROOT));
    } else if (value instanceof Target target) {
      return language.say(target.phrase());
    }
    return value.equals(ItemProperties.ANY_DRONE) ? messages.now("any-drone") : value.toString();
  }
}
