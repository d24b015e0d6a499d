package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import tellosimulator.sim.SimConfig;

/**
 * The random numbers from which a course is drawn: one for each range such as {@code 80..120} in a
 * file. They depend on the seed, on the attempt, and on the text of the list item or section that
 * contains the range, so that a change to one item does not change the others. They are the same on
 * every machine. Immutable.
 */
final class CourseDraw {

  /** The draw of a text without ranges. */
  static final CourseDraw NONE = new CourseDraw(SimConfig.DEFAULT.seed(), 0);

  /** The form of each end of a range: its length is limited, so that its number is exact. */
  private static final String END = "[+-]?[0-9]{1,9}(?:\\.[0-9]{1,6})?";

  /** The form of ranges, which is also valid in a JSON schema. */
  static final String FORM = "^(" + END + ")\\.\\.(" + END + ")$";

  private static final Pattern RANGE = Pattern.compile(FORM);

  /** Maximum number of decimals of a drawn number: as many as files keep. */
  private static final int MOST_DECIMALS = 6;

  /** 2 to the power of -53: the distance between random numbers below 1. */
  private static final double ULP = 0x1p-53;

  /**
   * A range of numbers as they are written.
   *
   * @param decimals the number of decimals of a drawn number
   */
  record Range(double least, double most, int decimals) {

    /** Parses a text; empty if it is no range. The first end may be the greater one. */
    static Optional<Range> of(String text) {
      Matcher ends = RANGE.matcher(text);
      if (!ends.matches()) {
        return Optional.empty();
      }
      int written = Math.max(decimals(ends.group(1)), decimals(ends.group(2)));
      int drawn = written == 0 ? 0 : Math.min(written + 1, MOST_DECIMALS);
      return Optional.of(
          new Range(Double.parseDouble(ends.group(1)), Double.parseDouble(ends.group(2)), drawn));
    }

    private static int decimals(String number) {
      int point = number.indexOf('.');
      return point < 0 ? 0 : number.length() - point - 1;
    }

    /**
     * Returns a number of the range. All numbers with its decimals are equally likely.
     *
     * @param fraction a random number from 0 to less than 1
     */
    double at(double fraction) {
      double scale = Math.rint(StrictMath.pow(10, decimals));
      double first = Math.rint(least * scale);
      double count = Math.rint(most * scale) - first + 1;
      return (first + Math.floor(fraction * count)) / scale;
    }
  }

  private final long seed;
  private final int attempt;
  private final IdentityHashMap<Node, Double> fractions = new IdentityHashMap<>();

  /** All nodes, and whether they contain ranges. */
  private final IdentityHashMap<Node, Boolean> nodes = new IdentityHashMap<>();

  private CourseDraw(long seed, int attempt) {
    this.seed = seed;
    this.attempt = attempt;
  }

  /**
   * Draws the numbers of a file.
   *
   * @param attempt the number of the attempt with this seed, from 0
   */
  static CourseDraw of(Node root, long seed, int attempt) {
    CourseDraw draw = new CourseDraw(seed, attempt);
    Map<String, Integer> equal = new HashMap<>();
    for (Node item : items(root)) {
      StringBuilder text = new StringBuilder();
      List<Node> ranges = new ArrayList<>();
      draw.walk(item, text, ranges);
      if (!ranges.isEmpty()) {
        int copies = equal.merge(text.toString(), 1, Integer::sum);
        SplittableRandom random = random(seed, attempt, text.toString().hashCode(), copies);
        for (Node range : ranges) {
          draw.fractions.put(range, fraction(random));
        }
      }
    }
    return draw;
  }

  /** Draws the numbers of another version of the file, from the same seed and attempt. */
  CourseDraw again(Node root) {
    return of(root, seed, attempt);
  }

  /** Returns the seed in a file, or the default seed if there is no valid one. */
  static long seedIn(Node root) {
    return entries(root).stream()
        .filter(entry -> Scalars.text(entry.getKeyNode()).filter("seed"::equals).isPresent())
        .flatMap(entry -> Scalars.text(entry.getValueNode()).stream())
        .filter(word -> Scalars.DIGITS.matcher(word).matches())
        .map(Long::valueOf)
        .findFirst()
        .orElse(SimConfig.DEFAULT.seed());
  }

  private static List<NodeTuple> entries(Node root) {
    return root instanceof MappingNode mapping ? mapping.getValue() : List.of();
  }

  /** Returns the list items and the sections that are no lists. */
  private static List<Node> items(Node root) {
    List<Node> items = new ArrayList<>();
    for (NodeTuple entry : entries(root)) {
      if (entry.getValueNode() instanceof SequenceNode list) {
        items.addAll(list.getValue());
      } else {
        items.add(entry.getValueNode());
      }
    }
    return items;
  }

  /** Returns a generator whose numbers depend on each of the parts alone. */
  static SplittableRandom random(long... parts) {
    SplittableRandom random = new SplittableRandom(0);
    for (long part : parts) {
      random = new SplittableRandom(random.nextLong() + part);
    }
    return random;
  }

  /** Returns the next random number, from 0 to less than 1. */
  static double fraction(SplittableRandom random) {
    return (random.nextLong() >>> 11) * ULP; // as specified, in every version of Java
  }

  /**
   * Adds the scalars and ranges of a node in the order of the file, except those that an earlier
   * node shares through an alias. Returns whether the node contains ranges.
   */
  private boolean walk(Node node, StringBuilder text, List<Node> ranges) {
    Boolean known = nodes.putIfAbsent(node, false);
    if (known != null) {
      return known;
    }
    boolean varies = false;
    if (node instanceof MappingNode mapping) {
      for (NodeTuple entry : mapping.getValue()) {
        walk(entry.getKeyNode(), text, new ArrayList<>());
        varies |= walk(entry.getValueNode(), text, ranges);
      }
    } else if (node instanceof SequenceNode list) {
      for (Node item : list.getValue()) {
        varies |= walk(item, text, ranges);
      }
    } else if (node instanceof ScalarNode scalar) {
      text.append(scalar.getValue()).append('\n');
      varies = Range.of(scalar.getValue()).isPresent();
      if (varies) {
        ranges.add(node);
      }
    }
    nodes.put(node, varies);
    return varies;
  }

  /** Whether the file contains no ranges. */
  boolean isEmpty() {
    return fractions.isEmpty();
  }

  /** Whether a node contains ranges. */
  boolean varies(Node node) {
    return nodes.getOrDefault(node, false);
  }

  /** Returns the number that was drawn from a range of the file. */
  double number(Range range, Node node) {
    return range.at(fractions.getOrDefault(node, 0.0));
  }

  /** Returns the text of the file, all of whose characters are in Unicode's first plane. */
  String textOf(String ranges) {
    StringBuilder text = new StringBuilder(ranges);
    fractions.keySet().stream()
        .map(ScalarNode.class::cast)
        .sorted(Comparator.comparing(node -> -start(node)))
        .forEach(
            node -> {
              double number = number(Range.of(node.getValue()).orElseThrow(), node);
              int end = start(node) + node.getValue().length();
              text.replace(start(node), end, NumberCodec.plain(number));
            });
    return text.toString();
  }

  private static int start(Node node) {
    return node.getStartMark().orElseThrow().getIndex();
  }
}
