package tellosimulator.view.controls;

import atlantafx.base.theme.Styles;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleConsumer;
import java.util.function.DoubleFunction;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;

/**
 * A field for a number. Enter, leaving the field, and the up and down arrow keys commit the number;
 * Escape restores the previous one. An invalid number is not committed; it is marked and explained
 * by a message. Confined to the JavaFX thread.
 */
public final class NumberField extends TextField {

  private final Language language;
  private final MessageLabel error;
  private NumberRange range;
  private DoubleFunction<Optional<Message>> rule = number -> Optional.empty();
  private DoubleConsumer taker = number -> {};
  private double shown = Double.NaN;

  /** Whether the field contains uncommitted text. */
  private boolean edited;

  /** Whether the text is changing because {@link #show} shows a number. */
  private boolean showing;

  public NumberField(String id, NumberRange range, Language language) {
    this.language = language;
    this.range = range;
    Messages messages = language.messages(NumberField.class);
    this.error = new MessageLabel(messages, id + "-error", Styles.DANGER);
    setId(id);
    initializeSelf();
    setupEventHandlers();
    setupBindings();
  }

  private void initializeSelf() {
    getStyleClass().add("number-field");
    setPrefColumnCount(5);
  }

  private void setupEventHandlers() {
    setOnAction(entered -> commit());
    addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
  }

  private void setupBindings() {
    focusedProperty()
        .addListener(
            (property, before, now) -> {
              if (!now) {
                commit();
              }
            });
    textProperty()
        .addListener(
            (property, before, now) -> {
              if (!showing) {
                edited = true;
                recheck();
              }
            });
    language
        .localeProperty()
        .addListener(
            (property, before, now) -> {
              if (!edited) {
                write();
              }
            });
  }

  /** Sets the listener that receives each new number. */
  public void onNumber(DoubleConsumer newTaker) {
    taker = newTaker;
  }

  /**
   * Sets an additional rule that numbers must satisfy. The rule returns the error message for a
   * number; empty if the number is valid.
   */
  void setRule(DoubleFunction<Optional<Message>> newRule) {
    rule = newRule;
  }

  void setRange(NumberRange newRange) {
    if (!newRange.equals(range)) {
      range = newRange;
      recheck();
    }
  }

  /** Returns the label for the error message, to be laid out below the field. */
  public MessageLabel error() {
    return error;
  }

  /** Returns the number that was last shown or committed. */
  double number() {
    return shown;
  }

  /** Shows a number, unless the user is typing. */
  public void show(double number) {
    if (number != shown) {
      shown = number;
      if (!edited) {
        write();
      }
    }
  }

  /** Shows the number again and discards any typed text. */
  void restore() {
    edited = false;
    mark(Optional.empty());
    write();
  }

  private void pressed(KeyEvent event) {
    KeyCode code = event.getCode();
    if (code == KeyCode.ESCAPE && edited) {
      restore();
      selectAll();
      event.consume();
    } else if (code == KeyCode.UP || code == KeyCode.DOWN) {
      step(code == KeyCode.UP ? 1 : -1);
      event.consume();
    }
  }

  private void step(int direction) {
    OptionalDouble typed = NumberText.parse(getText());
    if (isEditable() && typed.isPresent()) {
      handOver(range.next(typed.getAsDouble(), direction));
    }
  }

  private void commit() {
    if (!edited) {
      return;
    }
    Optional<Message> problem = problem();
    mark(problem);
    if (problem.isEmpty()) {
      handOver(NumberText.parse(getText()).orElse(shown));
    }
  }

  private void handOver(double number) {
    boolean isNew = number != shown;
    edited = false;
    shown = number;
    mark(Optional.empty());
    write();
    if (isNew) {
      taker.accept(number);
    }
  }

  /** Removes the error mark as soon as the number is valid. The number is committed later. */
  private void recheck() {
    if (error.isVisible()) {
      mark(problem());
    }
  }

  private Optional<Message> problem() {
    OptionalDouble number = NumberText.parse(getText());
    if (getText().isBlank()) {
      return Optional.of(Message.of("number.missing"));
    }
    if (number.isEmpty()) {
      return Optional.of(Message.of("number.none"));
    }
    if (!range.contains(number.getAsDouble())) {
      return Optional.of(Message.of("number.range", text(range.least()), text(range.most())));
    }
    return rule.apply(number.getAsDouble());
  }

  private void mark(Optional<Message> problem) {
    error.say(problem);
    pseudoClassStateChanged(Styles.STATE_DANGER, problem.isPresent());
  }

  private void write() {
    showing = true;
    setText(text(shown));
    showing = false;
  }

  private String text(double number) {
    return NumberText.of(number, language.locale());
  }
}
