package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.api.DumpSettings;
import org.snakeyaml.engine.v2.api.lowlevel.Present;
import org.snakeyaml.engine.v2.api.lowlevel.Serialize;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.common.ScalarStyle;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;

/** Formats nodes as YAML. Nodes that are marked as defaults are omitted. */
final class Yaml {

  /** The property that marks a node whose value is the default. */
  private static final String USUAL = "usual";

  /**
   * Texts that are written in quotes: words that YAML 1.1, the version that many editors use, does
   * not read as strings, and all texts that do not begin with a letter.
   */
  private static final Pattern NEEDS_QUOTES =
      Pattern.compile("(?i)\\P{L}.*|y|yes|n|no|on|off|true|false|null");

  private Yaml() {}

  /** Returns the given node, after marking it if its value is the default. */
  static Node marked(Node node, boolean usual) {
    if (usual) {
      node.setProperty(USUAL, true);
    }
    return node;
  }

  /** Returns whether a node is marked as the default. */
  static boolean isUsual(Node node) {
    return node.getProperty(USUAL) != null;
  }

  /**
   * Returns a copy of a node without default values. The copy is written in brackets and braces.
   */
  private static Node lean(Node node) {
    if (node instanceof MappingNode mapping) {
      List<NodeTuple> kept = new ArrayList<>();
      for (NodeTuple tuple : mapping.getValue()) {
        if (!isUsual(tuple.getValueNode())) {
          kept.add(new NodeTuple(tuple.getKeyNode(), lean(tuple.getValueNode())));
        }
      }
      return new MappingNode(Tag.MAP, kept, FlowStyle.FLOW);
    }
    if (node instanceof SequenceNode sequence) {
      List<Node> items = sequence.getValue().stream().map(Yaml::lean).toList();
      return new SequenceNode(Tag.SEQ, items, FlowStyle.FLOW);
    }
    return node;
  }

  /** Formats a value on one line. The result is also valid within braces and brackets. */
  static String inline(Node value) {
    Node list = new SequenceNode(Tag.SEQ, List.of(lean(value)), FlowStyle.FLOW);
    DumpSettings settings = DumpSettings.builder().setWidth(Integer.MAX_VALUE).build();
    List<Event> events = new Serialize(settings).serializeOne(list);
    String line = new Present(settings).emitToString(events.iterator()).strip();
    return line.substring(1, line.length() - 1);
  }

  static Node text(String value) {
    boolean quoted = NEEDS_QUOTES.matcher(value).matches();
    return new ScalarNode(Tag.STR, value, quoted ? ScalarStyle.DOUBLE_QUOTED : ScalarStyle.PLAIN);
  }

  static Node number(double value) {
    String written = NumberCodec.plain(value);
    return plain(written.contains(".") ? Tag.FLOAT : Tag.INT, written);
  }

  /** Returns the node of a value other than a string. */
  static Node plain(Tag tag, String value) {
    return new ScalarNode(tag, value, ScalarStyle.PLAIN);
  }
}
