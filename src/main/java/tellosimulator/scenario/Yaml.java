package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
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

/** Makes YAML of nodes. What is as usual is marked, and left out of a text. */
final class Yaml {

  private static final int WIDTH = 100;

  /** The property of a node whose value is as usual. */
  private static final String USUAL = "usual";

  /** Texts that are more than text in YAML 1.1, which many editors read, or look like it. */
  private static final Pattern NEEDS_QUOTES =
      Pattern.compile("(?i)\\P{L}.*|y|yes|n|no|on|off|true|false|null");

  private Yaml() {}

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

  /** The text of a whole file, with an empty line before each list and mapping but the first. */
  static String text(Node file) {
    MappingNode root = (MappingNode) lean(file, Optional.empty());
    for (NodeTuple tuple : root.getValue().stream().skip(1).toList()) {
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

  static Node text(String value) {
    boolean quoted = NEEDS_QUOTES.matcher(value).matches();
    return new ScalarNode(Tag.STR, value, quoted ? ScalarStyle.DOUBLE_QUOTED : ScalarStyle.PLAIN);
  }

  static Node number(double value) {
    String written = NumberCodec.plain(value);
    return plain(written.contains(".") ? Tag.FLOAT : Tag.INT, written);
  }

  /** A value that is no text, as it is written. */
  static Node plain(Tag tag, String value) {
    return new ScalarNode(tag, value, ScalarStyle.PLAIN);
  }
}
