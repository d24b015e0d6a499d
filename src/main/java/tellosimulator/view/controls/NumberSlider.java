package tellosimulator.view.controls;

import javafx.beans.value.ObservableValue;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.view.text.Language;

/**
 * A number that is set with a slider or typed: name with unit, slider, and field. The field's id is
 * the slider's with {@code -value}, and that of the sentence about a wrong number with {@code
 * -value-error}.
 *
 * <p>It collects what a person does until its owner asks, at {@link #onChange} or once a pulse:
 * {@link #takeChange} says whether there is something new, {@link #value} is it, and at later
 * pulses {@link #show} puts what the simulation made of it. So a fast drag sends one message a
 * pulse, and what comes back never pulls the thumb away from the mouse. For the JavaFX thread.
 */
final class NumberSlider extends VBox {

  private final Label name = new Label();
  private final Slider slider = new Slider();
  private final NumberField field;
  private NumberRange sliderRange;
  private double value = Double.NaN;
  private boolean changed;

  /** Is called when a person has set another number. */
  private Runnable changeListener = () -> {};

  /** Whether the slider moves because {@link #show} moves it. */
  private boolean showing;

  /**
   * @param id of the slider
   * @param range what the slider reaches, and at first what the field takes
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

  /** Lets the slider reach another range, of which the field takes every number. */
  void setRange(NumberRange range) {
    setSliderRange(range);
    field.setRange(range);
  }

  /** Lets the field take more than the slider reaches. */
  void setFieldRange(NumberRange range) {
    field.setRange(range);
  }

  /** What a person set, or what was shown last. */
  double value() {
    return value;
  }

  /** Says at once that a person has set another number; the owner need not wait for a pulse. */
  void onChange(Runnable listener) {
    changeListener = listener;
  }

  /** Whether a person set a number since this was asked last. */
  boolean takeChange() {
    boolean was = changed;
    changed = false;
    return was;
  }

  /** Shows what holds now. */
  void show(double number) {
    if (number != value) {
      value = number;
      field.show(number);
      moveTo(number);
    }
  }

  /** Drops what is typed and was not handed over. */
  void forgetTyped() {
    changed = false;
    field.restore();
  }

  private void setSliderRange(NumberRange range) {
    if (!range.equals(sliderRange)) {
      sliderRange = range;
      adopt(range);
    }
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
