package tellosimulator.view.text;

import java.util.List;
import javafx.beans.binding.StringBinding;

/**
 * A text of a package's messages with its values: what is wrong with a number that was typed, or
 * why a flight ended. Equal messages say the same. Immutable; for any thread.
 *
 * @param key of the text
 * @param values for its {@code %s}; numbers are texts already, so that ports and the like have no
 *     thousands separator
 */
public record Message(String key, List<String> values) {

  /** Nothing to say. */
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

  /** The text, which follows the language. */
  public StringBinding text(Messages messages) {
    return messages.text(key, values.toArray());
  }

  /** The text in the present language; empty for {@link #NONE}. */
  public String now(Messages messages) {
    return isNone() ? "" : messages.now(key, values.toArray());
  }
}
