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
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;

/**
 * A control with a few options as adjacent buttons, one of which is selected. Confined to the
 * JavaFX thread.
 */
final class SegmentedButton<T> extends HBox {

  /**
   * An option.
   *
   * @param id the end of the button's id; the control's id and a hyphen precede it
   * @param name the label of the button
   * @param hint the tooltip of the button
   */
  record Option<T>(T value, String id, ObservableValue<String> name, ObservableValue<String> hint) {

    /** Returns an option whose texts have the keys {@code key.id} and {@code key.id.hint}. */
    static <T> Option<T> of(Messages messages, String key, T value, String id) {
      String name = key + "." + id;
      return new Option<>(value, id, messages.text(name), messages.text(name + ".hint"));
    }
  }

  private final ToggleGroup group = new ToggleGroup();
  private final Consumer<T> taker;
  private final List<Option<T>> options;
  private final List<ToggleButton> buttons;
  private Optional<T> shown = Optional.empty();

  /**
   * @param taker receives the option that the user has chosen
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
    ToggleButton button = Nodes.named(new ToggleButton(), id + "-" + option.id());
    button.textProperty().bind(option.name());
    button.setToggleGroup(group);
    Nodes.growing(button);
    Tooltips.install(button, option.hint());
    button.setOnAction(pressed -> button.setSelected(true)); // one of them is always selected
    return button;
  }

  /**
   * Handles a selection by click or arrow key. Arrow keys select a button without firing its
   * action.
   */
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

  /** Selects the button of the current value. */
  void show(T value) {
    shown = Optional.of(value);
    for (int i = 0; i < buttons.size(); i++) {
      if (options.get(i).value().equals(value)) {
        buttons.get(i).setSelected(true);
      }
    }
  }
}
