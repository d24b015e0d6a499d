package tellosimulator.scenario;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import tellosimulator.words.Phrase;

/**
 * A rule by which the value, presence or absence of one key requires or excludes other keys.
 *
 * @param key the key that selects the case
 * @param word the value that the key must have; empty if any value selects the case
 * @param present true if the rule applies when the key is present; false if it applies when the key
 *     is absent
 * @param needed the keys that the rule requires
 * @param excluded the keys that the rule excludes
 */
record Case(
    String key,
    Optional<String> word,
    boolean present,
    List<String> needed,
    List<String> excluded) {

  /** Creates a rule that applies if a key has a certain value. */
  static Case of(String key, String word) {
    return new Case(key, Optional.of(word), true, List.of(), List.of());
  }

  /** Creates a rule that applies if a key is present. */
  static Case with(String key) {
    return new Case(key, Optional.empty(), true, List.of(), List.of());
  }

  /** Creates a rule that applies if a key is absent. */
  static Case without(String key) {
    return new Case(key, Optional.empty(), false, List.of(), List.of());
  }

  Case needs(String... keys) {
    return new Case(key, word, present, List.of(keys), excluded);
  }

  Case excludes(String... keys) {
    return new Case(key, word, present, needed, List.of(keys));
  }

  /**
   * If the rule applies to a mapping, reports required keys that are missing and excluded keys that
   * are present.
   */
  void check(Entries in, Phrase phrase) {
    Node value = in.nodes().get(key);
    boolean applies =
        (value != null) == present
            && word.filter(w -> !(value instanceof ScalarNode s && s.getValue().equals(w)))
                .isEmpty();
    if (!applies) {
      return;
    }
    for (String need : needed) {
      if (!in.nodes().containsKey(need)) {
        in.need(need, phrase);
      }
    }
    for (String other : excluded) {
      if (in.nodes().containsKey(other)) {
        in.diagnostics()
            .add(
                in.nodes().get(other),
                present
                    ? Phrase.of("the key %s does not go with %s", other, word.orElse(key))
                    : Phrase.of("the key %s goes only with %s", other, key));
      }
    }
  }

  /** Returns the rule as a JSON schema. */
  Map<String, Object> schema() {
    Map<String, Object> condition = Codec.object("required", List.of(key));
    word.ifPresent(value -> condition.put("properties", Map.of(key, Codec.object("const", value))));
    Map<String, Object> forbidden = new LinkedHashMap<>();
    excluded.forEach(other -> forbidden.put(other, false));
    return Codec.object(
        "if",
        present ? condition : Codec.object("not", condition),
        "then",
        Codec.object("required", needed, "properties", forbidden));
  }
}
