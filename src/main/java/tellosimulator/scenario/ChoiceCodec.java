package tellosimulator.scenario;

import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.snakeyaml.engine.v2.common.FlowStyle;
import tellosimulator.words.Phrase;

/**
 * A mapping with exactly one of several keys, which says what is described.
 *
 * @param <T> what all of them describe
 */
final class ChoiceCodec<T> extends RecordCodec<T> {

  ChoiceCodec(String name, Phrase phrase, String description) {
    super(name, phrase, description);
    made(
        in -> {
          @SuppressWarnings("unchecked") // all keys have values of this type
          T only = (T) in.only();
          return only;
        });
  }

  /**
   * Adds a key.
   *
   * @param chosen the value if this is its key
   */
  <V extends T> ChoiceCodec<T> or(String key, Codec<V> codec, Function<T, Optional<V>> chosen) {
    key(key, "").optional(codec, chosen);
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
