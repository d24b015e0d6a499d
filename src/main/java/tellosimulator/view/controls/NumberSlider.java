package tellosimulator.view.controls;

import java.util.function.Supplier;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.sim.Control;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.text.Language;

/**
 * A slider and a text field that set the same number, with its name and unit above them. The id of
 * the field is the id of the slider followed by {@code -value}; the id of the error message ends
 * with {@code -value-error}.
 *
 * <p>The owner calls {@link #advance} once per pulse, and may also call it when notified by {@link
 * #onChange}. If the user has changed the number since the last call, the new {@link #value} is
 * sent to the simulation; otherwise, the value that the simulation has adopted is shown. During a
 * fast drag, this sends at most one message per pulse, and the simulation's value never pulls the
 * thumb away from the mouse. Confined to the JavaFX thread.
 */
final class NumberSlider extends VBox {

  private final Label name = new Label();
  private final Slider slider = new Slider();
  private final NumberField field;
  private NumberRange sliderRange;
  private double value = Double.NaN;
  private boolean changed;

  /** Called when the user has set another number. */
  private Runnable changeListener = () -> {};

  /** Whether the slider is moving because of {@link #show}. */
  private boolean showing;

  /**
   * @param id the id of the slider
   * @param range the range of the slider, and initially also of the field
   */
  NumberSlider(String id, ObservableValue<String> caption, NumberRange range, Language language) {
    this.field = new NumberField(id + "-value", range, language);
    this.sliderRange = range;
    slider.setId(id);
    name.textProperty().bind(caption);
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
  }

  private void initializeSelf() {
    getStyleClass().add("number-slider");
  }

  private void initializeParts() {
    name.setLabelFor(slider);
    name.getStyleClass().add("caption");
    name.setMinWidth(USE_PREF_SIZE);
    slider.accessibleTextProperty().bind(name.textProperty());
    field.accessibleTextProperty().bind(name.textProperty());
    adopt(sliderRange);
  }

  private void layoutParts() {
    HBox.setHgrow(slider, Priority.ALWAYS);
    slider.setMinWidth(40);
    slider.setPrefWidth(80);
    HBox row = new HBox(name, slider, field);
    row.getStyleClass().add("row");
    getChildren().addAll(row, field.error());
  }

  private void setupEventHandlers() {
    slider
        .valueProperty()
        .addListener(
            (property, before, now) -> {
              if (!showing) {
                field.restore();
                take(sliderRange.snapped(now.doubleValue()));
              }
            });
    slider
        .valueChangingProperty()
        .addListener(
            (property, before, now) -> {
              if (!now) {
                moveTo(value);
              }
            });
    field.onNumber(this::take);
  }

  /** Sets the range of both slider and field. */
  void setRange(NumberRange range) {
    field.setRange(range);
    if (!range.equals(sliderRange)) {
      sliderRange = range;
      adopt(range);
    }
  }

  /** Sets the range of the field only. The field's range may exceed the slider's. */
  void setFieldRange(NumberRange range) {
    field.setRange(range);
  }

  /**
   * Returns the number that the user has set or that {@link #show} has shown, whichever was later.
   */
  double value() {
    return value;
  }

  /**
   * Sets a listener that is notified immediately when the user has set another number. The owner
   * then need not wait for the next pulse.
   */
  void onChange(Runnable listener) {
    changeListener = listener;
  }

  /**
   * Sends a control if the user has changed any of the sliders since the last call, and otherwise
   * shows the current values. The display is not updated while actions are pending, because the
   * values are then outdated.
   *
   * @param change creates the control
   * @param show shows the current values of the simulation
   */
  static void advance(
      SimulatorActions actions, Supplier<Control> change, Runnable show, NumberSlider... sliders) {
    boolean changed = false;
    for (NumberSlider slider : sliders) {
      changed |= slider.changed;
      slider.changed = false;
    }
    if (changed) {
      actions.carryOut(change.get());
    } else if (!actions.pending()) {
      show.run();
    }
  }

  /** Shows the current value. */
  void show(double number) {
    if (number != value) {
      value = number;
      field.show(number);
      moveTo(number);
    }
  }

  /** Discards typed text that has not been committed, and a change that has not been sent. */
  void forgetTyped() {
    changed = false;
    field.restore();
  }

  private void adopt(NumberRange range) {
    showing = true;
    slider.setMin(Math.min(range.least(), slider.getMax()));
    slider.setMax(range.most());
    slider.setMin(range.least());
    slider.setBlockIncrement(range.step());
    showing = false;
    if (!Double.isNaN(value)) {
      moveTo(value);
    }
  }

  private void take(double number) {
    if (number != value) {
      value = number;
      changed = true;
      field.show(number);
      moveTo(number);
      changeListener.run();
    }
  }

  private void moveTo(double number) {
    if (!slider.isValueChanging()) {
      showing = true;
      slider.setValue(sliderRange.nearest(number));
      showing = false;
    }
  }
}
