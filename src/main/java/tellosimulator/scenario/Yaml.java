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

/** A mapping of a scenario file while it is written. */
final class Yaml {

  private static final int WIDTH = 100;

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

  /** Only what is not as usual is written. */
  Yaml put(String key, double value, double usual) {
    return Values.rounded(value) == Values.rounded(usual) ? this : put(key, value);
  }

  /** Only what is not as usual is written. */
  Yaml put(String key, String value, String usual) {
    return value.equals(usual) ? this : put(key, value);
  }

  /** A value that is no text, as it is written. */
  Yaml plain(String key, Tag tag, String value) {
    return put(key, new ScalarNode(tag, value, ScalarStyle.PLAIN));
  }

  /** A list below its key; an empty one is not written. */
  Yaml list(String key, List<Yaml> items) {
    return items.isEmpty()
        ? this
        : put(
            key,
            new SequenceNode(Tag.SEQ, items.stream().map(Yaml::node).toList(), FlowStyle.BLOCK));
  }

  Node node() {
    return new MappingNode(Tag.MAP, tuples, style);
  }

  boolean isEmpty() {
    return tuples.isEmpty();
  }

  /** Numbers in one line. */
  static Node numbers(double... values) {
    List<Node> nodes = new ArrayList<>();
    DoubleStream.of(values).forEach(value -> nodes.add(number(value)));
    return new SequenceNode(Tag.SEQ, nodes, FlowStyle.FLOW);
  }

  /** The whole file, with an empty line before each list and mapping. */
  String text() {
    for (NodeTuple tuple : tuples) {
      if (!(tuple.getValueNode() instanceof ScalarNode)) {
        tuple
            .getKeyNode()
            .setBlockComments(
                List.of(
                    new CommentLine(
                        Optional.empty(), Optional.empty(), "", CommentType.BLANK_LINE)));
      }
    }
    DumpSettings settings =
        DumpSettings.builder()
            .setIndent(2)
            .setIndicatorIndent(2)
            .setIndentWithIndicator(true)
            .setWidth(WIDTH)
            .setDumpComments(true)
            .build();
    StringBuilder text = new StringBuilder();
    new Dump(settings)
        .dumpNode(
            node(),
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
