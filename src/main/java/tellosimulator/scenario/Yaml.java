package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import org.snakeyaml.engine.v2.api.Dump;
import org.snakeyaml.engine.v2.api.DumpSettings;
import org.snakeyaml.engine.v2.api.StreamDataWriter;
import org.snakeyaml.engine.v2.comments.CommentLine;
import org.snakeyaml.engine.v2.comments.CommentType;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.common.ScalarStyle;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;

/**
 * A mapping of a scenario file while it is written. Its {@link #node} holds all keys; what is as
 * usual is marked, and left out of a text.
 */
final class Yaml {

  private static final int WIDTH = 100;

  /** The property of a node whose value is as usual. */
  private static final String USUAL = "usual";

  /** Texts that are more than text in YAML 1.1, which many editors read, or look like it. */
  private static final Pattern NEEDS_QUOTES =
      Pattern.compile("(?i)\\P{L}.*|y|yes|n|no|on|off|true|false|null");

  private final List<NodeTuple> tuples = new ArrayList<>();
  private final FlowStyle style;

  private Yaml(FlowStyle style) {
    this.style = style;
  }

  /** A key on each line. */
  static Yaml block() {
    return new Yaml(FlowStyle.BLOCK);
  }

  /** All in one line. */
  static Yaml line() {
    return new Yaml(FlowStyle.FLOW);
  }

  Yaml put(String key, Node value) {
    tuples.add(new NodeTuple(text(key), value));
    return this;
  }

  Yaml put(String key, Yaml value) {
    return put(key, value.node());
  }

  Yaml put(String key, String value) {
    return put(key, text(value));
  }

  Yaml put(String key, double value) {
    return put(key, number(value));
  }

  Yaml put(String key, double value, double usual) {
    return put(key, marked(number(value), Values.rounded(value) == Values.rounded(usual)));
  }

  Yaml put(String key, String value, String usual) {
    return put(key, marked(text(value), value.equals(usual)));
  }

  /** A value that is no text, as it is written. */
  Yaml plain(String key, Tag tag, String value, String usual) {
    return put(key, marked(new ScalarNode(tag, value, ScalarStyle.PLAIN), value.equals(usual)));
  }

  /** A list below its key; an empty one is as usual. */
  Yaml list(String key, List<Yaml> items) {
    Node list = new SequenceNode(Tag.SEQ, items.stream().map(Yaml::node).toList(), FlowStyle.BLOCK);
    return put(key, marked(list, items.isEmpty()));
  }

  Node node() {
    return new MappingNode(Tag.MAP, tuples, style);
  }

  boolean isEmpty() {
    return tuples.isEmpty();
  }

  /** The same node, marked if its value is as usual. */
  static Node marked(Node node, boolean usual) {
    if (usual) {
      node.setProperty(USUAL, true);
    }
    return node;
  }

  /** Whether a value is what it would be without its key. */
  static boolean isUsual(Node node) {
    return node.getProperty(USUAL) != null;
  }

  /** The same without what is as usual. */
  private static Node lean(Node node, Optional<FlowStyle> style) {
    if (node instanceof MappingNode mapping) {
      List<NodeTuple> kept = new ArrayList<>();
      for (NodeTuple tuple : mapping.getValue()) {
        if (!isUsual(tuple.getValueNode())) {
          kept.add(new NodeTuple(tuple.getKeyNode(), lean(tuple.getValueNode(), style)));
        }
      }
      return new MappingNode(Tag.MAP, kept, style.orElse(mapping.getFlowStyle()));
    }
    if (node instanceof SequenceNode sequence) {
      List<Node> items = sequence.getValue().stream().map(item -> lean(item, style)).toList();
      return new SequenceNode(Tag.SEQ, items, style.orElse(sequence.getFlowStyle()));
    }
    return node;
  }

  /** Numbers in one line. */
  static Node numbers(double... values) {
    List<Node> nodes = new ArrayList<>();
    DoubleStream.of(values).forEach(value -> nodes.add(number(value)));
    return new SequenceNode(Tag.SEQ, nodes, FlowStyle.FLOW);
  }

  /** The text of a whole file, with an empty line before each list and mapping. */
  static String text(Node file) {
    MappingNode root = (MappingNode) lean(file, Optional.empty());
    for (NodeTuple tuple : root.getValue()) {
      if (!(tuple.getValueNode() instanceof ScalarNode)) {
        tuple
            .getKeyNode()
            .setBlockComments(
                List.of(
                    new CommentLine(
                        Optional.empty(), Optional.empty(), "", CommentType.BLANK_LINE)));
      }
    }
    return dumped(root, WIDTH);
  }

  /** A value in one line, good within braces and brackets, too. */
  static String inline(Node value) {
    Node flow = lean(value, Optional.of(FlowStyle.FLOW));
    Node list = new SequenceNode(Tag.SEQ, List.of(flow), FlowStyle.FLOW);
    String text = dumped(list, Integer.MAX_VALUE).strip();
    return text.substring(1, text.length() - 1);
  }

  private static String dumped(Node node, int width) {
    DumpSettings settings =
        DumpSettings.builder()
            .setIndent(2)
            .setIndicatorIndent(2)
            .setIndentWithIndicator(true)
            .setWidth(width)
            .setDumpComments(true)
            .build();
    StringBuilder text = new StringBuilder();
    new Dump(settings)
        .dumpNode(
            node,
            new StreamDataWriter() {
              @Override
              public void write(String piece) {
                text.append(piece);
              }

              @Override
              public void write(String piece, int offset, int length) {
                text.append(piece, offset, offset + length);
              }
            });
    return text.toString();
  }

  private static Node text(String value) {
    boolean quoted = NEEDS_QUOTES.matcher(value).matches();
    return new ScalarNode(Tag.STR, value, quoted ? ScalarStyle.DOUBLE_QUOTED : ScalarStyle.PLAIN);
  }

  private static Node number(double value) {
    String written = Values.plain(value);
    return new ScalarNode(written.contains(".") ? Tag.FLOAT : Tag.INT, written, ScalarStyle.PLAIN);
  }
}
