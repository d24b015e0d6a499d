package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.Tag;
import tellosimulator.words.Phrase;

/** Codec of a text: a single line, or a mapping of language codes to lines. */
record LocalizedTextCodec() implements Codec<LocalizedText> {

  /**
   * The form of language codes. Documented: ISO 639-1 and 639-2. All languages are allowed, not
   * only those into which the program is translated.
   */
  private static final Pattern LANGUAGE = Pattern.compile("[a-z]{2,3}");

  @Override
  public Optional<LocalizedText> read(Node node, Context context) {
    return node instanceof MappingNode mapping
        ? lines(mapping, context).map(LocalizedText::new)
        : Scalars.LINE.read(node, context).map(LocalizedText::of);
  }

  private static Optional<Map<String, String>> lines(MappingNode mapping, Context context) {
    Diagnostics diagnostics = context.diagnostics();
    int before = diagnostics.count();
    Map<String, String> lines = new LinkedHashMap<>();
    for (NodeTuple tuple : mapping.getValue()) {
      Optional<String> language = language(tuple.getKeyNode(), diagnostics);
      Optional<String> line = Scalars.LINE.read(tuple.getValueNode(), context);
      if (language.isPresent() && lines.put(language.get(), line.orElse("")) != null) {
        diagnostics.add(tuple.getKeyNode(), Phrase.of("the key %s is there twice", language.get()));
      }
    }
    if (mapping.getValue().isEmpty()) {
      diagnostics.add(mapping, Phrase.of("expected a text in at least one language, found none"));
    }
    return diagnostics.count() == before ? Optional.of(lines) : Optional.empty();
  }

  private static Optional<String> language(Node key, Diagnostics diagnostics) {
    Optional<String> language = Scalars.text(key).filter(LANGUAGE.asMatchPredicate());
    return language.isPresent()
        ? language
        : diagnostics.expected(Phrase.of("a language such as en or de"), key);
  }

  @Override
  public Node write(LocalizedText text, Path folder) {
    Optional<String> only = text.only();
    if (only.isPresent()) {
      return Scalars.LINE.write(only.get(), folder);
    }
    List<NodeTuple> tuples = new ArrayList<>();
    text.lines()
        .forEach(
            (language, line) ->
                tuples.add(new NodeTuple(Yaml.text(language), Scalars.LINE.write(line, folder))));
    return new MappingNode(Tag.MAP, tuples, FlowStyle.FLOW);
  }

  @Override
  public Map<String, Object> schema(Map<String, Object> definitions) {
    Map<String, Object> line = Scalars.LINE.schema(definitions);
    Map<String, Object> lines =
        Codec.object(
            "type",
            "object",
            "minProperties",
            1,
            "propertyNames",
            Codec.object("pattern", "^" + LANGUAGE.pattern() + "$"),
            "additionalProperties",
            line);
    String description = "A line, or one for each of several languages: {en: …, de: …}.";
    definitions.put(
        "text", Codec.object("description", description, "anyOf", List.of(line, lines)));
    return Codec.object("$ref", "#/$defs/text");
  }
}
