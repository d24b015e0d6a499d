package tellosimulator.scenario;

import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.snakeyaml.engine.v2.common.FlowStyle;
import tellosimulator.words.Phrase;

/**
 * Codec of a mapping that contains exactly one of several keys. The key determines the kind of its
 * value.
 *
 * @param <T> the common type of all values
 */
final class ChoiceCodec<T> extends RecordCodec<T> {

  private Function<T, Field<T, ?>> chosen;

  ChoiceCodec(String name, Phrase phrase, String description) {
    super(name, phrase, description);
    made(
        in -> {
          @SuppressWarnings("unchecked") // all keys have values of this type
          T only = (T) in.only();
          return only;
        });
  }

  /** Adds an alternative: a key and the codec of its value. */
  <V extends T> Field<T, V> or(String key, Codec<V> codec) {
    @SuppressWarnings("unchecked") // the chosen key has values of this type
    Function<T, Optional<V>> getter =
        value -> chosen.apply(value).key().equals(key) ? Optional.of((V) value) : Optional.empty();
    return key(key, "").optional(codec, getter);
  }

  /**
   * Sets the function that returns the key under which a value is written. Must be called after the
   * last alternative has been added.
   */
  ChoiceCodec<T> choosing(Function<T, Field<T, ?>> newChosen) {
    chosen = newChosen;
    return this;
  }

  @Override
  boolean checkKeys(Entries in) {
    int found = in.nodes().size();
    if (found != 1 && in.sound()) {
      in.diagnostics()
          .add(
              in.node(),
              Phrase.of("expected one of %s, found %d of them", String.join(", ", keys()), found));
    }
    return found == 1;
  }

  @Override
  FlowStyle style() {
    return FlowStyle.BLOCK;
  }

  @Override
  Map<String, Object> definition(Map<String, Object> definitions) {
    Map<String, Object> definition = super.definition(definitions);
    definition.put("minProperties", 1);
    definition.put("maxProperties", 1);
    return definition;
  }
}
