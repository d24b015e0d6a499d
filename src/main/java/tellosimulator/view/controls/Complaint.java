package tellosimulator.view.controls;

import java.util.List;
import javafx.beans.binding.StringBinding;
import tellosimulator.view.text.Messages;

/**
 * Why something that was typed is wrong, as the key of a sentence and the values in it. Numbers
 * must be texts already, because a port has no thousands separator.
 */
record Complaint(String key, List<String> values) {

  Complaint(String key, String... values) {
    this(key, List.of(values));
  }

  /** The sentence; it follows the language. */
  StringBinding sentence(Messages messages) {
    return messages.text(key, values.toArray());
  }
}
