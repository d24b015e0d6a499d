package tellosimulator.view.text;

import java.util.List;
import javafx.beans.binding.StringBinding;

/**
 * A text from a package's messages, with values to insert into the text. For example, it explains
 * an error in a typed number, or why a flight ended. Equal messages have the same text. Immutable.
 *
 * @param key the key of the text
 * @param values the values for each {@code %s}; numbers are already formatted, so that ports, for
 *     example, have no thousands separator
 */
public record Message(String key, List<String> values) {

  /** The empty message. */
  public static final Message NONE = of("");

  public Message {
    values = List.copyOf(values);
  }

  public static Message of(String key, String... values) {
    return new Message(key, List.of(values));
  }

  public boolean isNone() {
    return key.isEmpty();
  }

  /** Returns the text as a binding that follows the language. */
  public StringBinding text(Messages messages) {
    return messages.text(key, values.toArray());
  }

  /** Returns the text in the current language; empty for {@link #NONE}. */
  public String now(Messages messages) {
    return isNone() ? "" : messages.now(key, values.toArray());
  }
}
