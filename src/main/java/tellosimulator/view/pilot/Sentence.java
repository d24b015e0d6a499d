package tellosimulator.view.pilot;

import java.util.List;
import java.util.Locale;
import tellosimulator.network.PortTakenException;
import tellosimulator.view.text.Messages;

/**
 * Something to tell a person, in whichever language is chosen when it is shown.
 *
 * @param key of the text in this package's messages
 * @param values for its places
 */
public record Sentence(String key, List<Object> values) {

  /** Nothing to tell. */
  public static final Sentence NONE = new Sentence("", List.of());

  public Sentence {
    values = List.copyOf(values);
  }

  static Sentence of(String key, Object... values) {
    return new Sentence(key, List.of(values));
  }

  /** The drone refused a command. */
  static Sentence refused(String command, String reply) {
    return of("refused", command, reply.strip());
  }

  /** A drone cannot be switched on. */
  static Sentence portTaken(PortTakenException e) {
    String obstacle = e.obstacle().name().toLowerCase(Locale.ROOT).replace('_', '-');
    return of(
        "port-" + obstacle,
        Integer.toString(e.address().getPort()),
        e.address().getAddress().getHostAddress());
  }

  public boolean isNone() {
    return key.isEmpty();
  }

  /** In the present language; empty for {@link #NONE}. */
  public String text(Messages messages) {
    return isNone() ? "" : messages.now(key, values.toArray());
  }
}
