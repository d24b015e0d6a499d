package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.words.Phrase;
import tellosimulator.words.Spelling;

/** Codec of a value that is written as one of several words. */
record WordCodec<T>(NavigableMap<String, T> words) implements Codec<T> {

  WordCodec(Map<String, T> words) {
    this(new TreeMap<>(words));
  }

  /** Returns a codec of an enum, whose values are written as their names in lower case. */
  @SafeVarargs
  static <E extends Enum<E>> WordCodec<E> of(E... values) {
    NavigableMap<String, E> words = new TreeMap<>();
    for (E value : values) {
      words.put(value.name().toLowerCase(Locale.ROOT), value);
    }
    return new WordCodec<>(words);
  }

  @Override
  public Optional<T> read(Node node, Context context) {
    Optional<String> written = Scalars.text(node);
    Optional<T> meant = written.map(words::get);
    if (meant.isPresent()) {
      return meant;
    }
    String known = String.join(", ", words.keySet());
    Object found = Diagnostics.found(node);
    Phrase wrong =
        written
            .flatMap(word -> Spelling.meant(word, words.keySet()))
            .map(
                guess ->
                    Phrase.of(
                        "expected one of %s, found %s, did you mean %s?", known, found, guess))
            .orElseGet(() -> Phrase.of("expected one of %s, found %s", known, found));
    return context.diagnostics().add(node, wrong);
  }

  /** Returns the word for a value. */
  String word(T value) {
    for (Map.Entry<String, T> entry : words.entrySet()) {
      if (entry.getValue().equals(value)) {
        return entry.getKey();
      }
    }
    throw new IllegalArgumentException("there is no word for " + value);
  }

  @Override
  public Node write(T value, Path folder) {
    return Yaml.text(word(value));
  }

  @Override
  public Map<String, Object> schema(Map<String, Object> definitions) {
    return Codec.object("enum", List.copyOf(words.keySet()));
  }
}
