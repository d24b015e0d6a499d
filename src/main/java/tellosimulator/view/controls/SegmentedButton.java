package tellosimulator.view.controls;

import atlantafx.base.theme.Styles;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Toggle;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import tellosimulator.view.fx.Tooltips;

/**
 * A choice of a few things as buttons beside each other, of which one is pressed. For the JavaFX
 * thread.
 */
final class SegmentedButton<T> extends HBox {

  /**
   * One of the things.
   *
   * @param id of its button, behind the choice's id and a hyphen
   * @param name what stands on the button
   * @param hint what the button says about itself
   */
  record Option<T>(
      T value, String id, ObservableValue<String> name, ObservableValue<String> hint) {}

  private final ToggleGroup group = new ToggleGroup();
  private final Consumer<T> taker;
  private final List<Option<T>> options;
  private final List<ToggleButton> buttons;
  private Optional<T> shown = Optional.empty();

  /**
   * @param taker gets what a person chooses
   */
  SegmentedButton(String id, List<Option<T>> options, Consumer<T> taker) {
    this.options = List.copyOf(options);
    this.taker = taker;
    this.buttons = this.options.stream().map(option -> button(id, option)).toList();
    setId(id);
    layoutParts();
    group.selectedToggleProperty().addListener((property, before, now) -> take(now));
  }

  private void layoutParts() {
    getStyleClass().add("segments");
    buttons.get(0).getStyleClass().add(Styles.LEFT_PILL);
    buttons.get(buttons.size() - 1).getStyleClass().add(Styles.RIGHT_PILL);
    buttons
        .subList(1, buttons.size() - 1)
        .forEach(button -> button.getStyleClass().add(Styles.CENTER_PILL));
    getChildren().addAll(buttons);
  }

  private ToggleButton button(String id, Option<T> option) {
    ToggleButton button = new ToggleButton();
    button.setId(id + "-" + option.id());
    button.textProperty().bind(option.name());
    button.setToggleGroup(group);
    button.setMaxWidth(Double.MAX_VALUE);
    HBox.setHgrow(button, Priority.ALWAYS);
    Tooltips.install(button, option.hint());
    button.setOnAction(pressed -> button.setSelected(true)); // one of them is always pressed
    return button;
  }

  /** By click or by arrow key, which fires no action. */
  private void take(Toggle pressed) {
    int index = buttons.indexOf(pressed);
    if (index >= 0) {
      T value = options.get(index).value();
      if (!shown.equals(Optional.of(value))) {
        shown = Optional.of(value);
        taker.accept(value);
      }
    }
  }

  /** Presses the button of what holds now. */
  void show(T value) {
    shown = Optional.of(value);
    for (int i = 0; i < buttons.size(); i++) {
      if (options.get(i).value().equals(value)) {
        buttons.get(i).setSelected(true);
      }
    }
  }
}
