package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.common.Anchor;
import org.snakeyaml.engine.v2.events.AliasEvent;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.Event.ID;
import org.snakeyaml.engine.v2.events.MappingStartEvent;
import org.snakeyaml.engine.v2.events.NodeEvent;
import org.snakeyaml.engine.v2.events.ScalarEvent;
import org.snakeyaml.engine.v2.events.SequenceStartEvent;
import org.snakeyaml.engine.v2.exceptions.ComposerException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import org.snakeyaml.engine.v2.parser.Parser;
import tellosimulator.scenario.Mistake.Place;
import tellosimulator.words.Phrase;

/**
 * Makes nodes of what a parser finds in a text, and gives up before they are more, or deeper, than
 * a scenario needs. Does what the library's composer does, but for comments and tags, which nobody
 * asks for here; it looks for them so often that the first file of a program takes a sixth longer.
 */
final class TreeReader {

  /** Most values in a file, which bounds the memory that they take. Decided. */
  private static final int MOST_VALUES = 400_000;

  /**
   * Deepest nesting, which bounds the stack that it takes. Decided: several times what is needed.
   */
  private static final int DEEPEST = 20;

  /** Most aliases of lists and mappings, which bounds the time to read them. Decided. */
  private static final int MOST_ALIASES = 50;

  /**
   * Longest key or value [characters], more than the longest text that means something. Decided.
   */
  private static final int LONGEST = 10_000;

  private final Parser parser;
  private final Map<Anchor, Node> anchors = new HashMap<>();
  private int depth;
  private int values;
  private int aliases;

  TreeReader(Parser parser) {
    this.parser = parser;
  }

  /** There is more than is read, or something that no scenario has. */
  static final class RefusedException extends RuntimeException {

    private static final long serialVersionUID = 1;

    private final transient Place place;
    private final transient Phrase phrase;

    private RefusedException(Event event, Phrase phrase) {
      this(event.getStartMark().map(Mistakes::place).orElse(Place.WHOLE), phrase);
    }

    private RefusedException(Place place, Phrase phrase) {
      super(phrase.english());
      this.place = place;
      this.phrase = phrase;
    }

    Place place() {
      return place;
    }

    Phrase phrase() {
      return phrase;
    }
  }

  /**
   * The only document of the text; empty if it has none.
   *
   * @throws YamlEngineException if it is not YAML
   * @throws RefusedException if it is too large, or has a key that is no text
   */
  Optional<Node> root() {
    next(); // the text starts
    if (next().getEventId() == ID.StreamEnd) {
      return Optional.empty();
    }
    Node root = node(next());
    next(); // the document ends
    Event end = next();
    if (end.getEventId() != ID.StreamEnd) {
      throw new ComposerException(
          "expected a single document in the stream",
          root.getStartMark(),
          "but found another document",
          end.getStartMark());
    }
    return Optional.of(root);
  }

  private Event next() {
    Event event = parser.next();
    ID id = event.getEventId();
    values++;
    if (id == ID.MappingStart || id == ID.SequenceStart) {
      depth++;
    } else if (id == ID.MappingEnd || id == ID.SequenceEnd) {
      depth--;
    }
    if (depth > DEEPEST) {
      throw new RefusedException(
          event, Phrase.of("expected at most %d levels, found more", DEEPEST));
    }
    if (values > MOST_VALUES) {
      throw new RefusedException(
          event, Phrase.of("expected at most %d values, found more", MOST_VALUES));
    }
    return event;
  }

  /** The node that starts with an event. */
  private Node node(Event event) {
    if (event instanceof ScalarEvent scalar) {
      return scalar(scalar);
    }
    if (event instanceof SequenceStartEvent start) {
      return sequence(start);
    }
    if (event instanceof MappingStartEvent start) {
      return mapping(start);
    }
    return meant((AliasEvent) event);
  }

  private Node scalar(ScalarEvent event) {
    if (event.getValue().length() > LONGEST) {
      throw new RefusedException(
          event, Phrase.of("expected at most %d letters, found more", LONGEST));
    }
    ScalarNode node =
        new ScalarNode(
            Tag.STR,
            true,
            event.getValue(),
            event.getScalarStyle(),
            event.getStartMark(),
            event.getEndMark());
    keep(event, node);
    return node;
  }

  private Node sequence(SequenceStartEvent start) {
    List<Node> items = new ArrayList<>();
    SequenceNode node =
        new SequenceNode(
            Tag.SEQ, true, items, start.getFlowStyle(), start.getStartMark(), Optional.empty());
    keep(start, node);
    for (Event event = next(); event.getEventId() != ID.SequenceEnd; event = next()) {
      items.add(node(event));
    }
    return node;
  }

  private Node mapping(MappingStartEvent start) {
    List<NodeTuple> tuples = new ArrayList<>();
    MappingNode node =
        new MappingNode(
            Tag.MAP, true, tuples, start.getFlowStyle(), start.getStartMark(), Optional.empty());
    keep(start, node);
    for (Event event = next(); event.getEventId() != ID.MappingEnd; event = next()) {
      Node key = node(event);
      if (!(key instanceof ScalarNode)) {
        throw new RefusedException(
            Mistakes.place(key), Phrase.of("expected a key, found %s", Values.found(key)));
      }
      tuples.add(new NodeTuple(key, node(next())));
    }
    return node;
  }

  private void keep(NodeEvent event, Node node) {
    if (event.getAnchor().isPresent()) {
      anchors.put(event.getAnchor().get(), node);
    }
  }

  /** The node that an alias stands for. */
  private Node meant(AliasEvent alias) {
    Node node = anchors.get(alias.getAlias());
    if (node == null) {
      throw new ComposerException(
          "found undefined alias " + alias.getAlias(), alias.getStartMark());
    }
    if (!(node instanceof ScalarNode)) {
      aliases++;
      if (aliases > MOST_ALIASES) {
        throw new RefusedException(
            alias, Phrase.of("expected at most %d aliases, found more", MOST_ALIASES));
      }
    }
    return node;
  }
}
