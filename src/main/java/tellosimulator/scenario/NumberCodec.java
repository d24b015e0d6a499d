package tellosimulator.scenario;

import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import tellosimulator.fault.FaultParameter;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;

/**
 * A number that may have decimals, in SI in the program.
 *
 * @param unit in which it is written
 * @param expected what is told of a number that is none, or out of range
 * @param least in the written unit
 * @param most in the written unit
 */
record NumberCodec(Unit unit, Phrase expected, double least, double most) implements Codec<Double> {

  /** Not all that Java's numbers can be, and short enough to be no burden. */
  private static final Pattern FORM =
      Pattern.compile("(?=.{1,40}$)[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?");

  /** A time with its unit. */
  private static final String TIME = "^[0-9]{1,9}(\\.[0-9]{1,9})?(ms|s|min)$";

  /** Numbers are read to the millionth, so that they are the same after they were written. */
  private static final double PRECISION = 1e6;

  /** What a number means. */
  enum Unit {
    /** Itself. */
    ONE,
    /** A length or a speed, which becomes one of metres. */
    CENTIMETER,
    /** Degrees counter-clockwise, which become radians within ±π. */
    DEGREE,
    /** A time, which may also be written with its unit, such as 90s. */
    SECOND
  }

  /** Degrees counter-clockwise, as radians within ±π. */
  static final NumberCodec ANGLE =
      new NumberCodec(Unit.DEGREE, Phrase.of("an angle in degrees from -360 to 360"), -360, 360);

  /** A number as it is. */
  static NumberCodec of(Phrase expected, double least, double most) {
    return new NumberCodec(Unit.ONE, expected, least, most);
  }

  /** A time in seconds. */
  static NumberCodec seconds(double least, double most) {
    Phrase expected = Phrase.of("seconds from %s to %s", plain(least), plain(most));
    return new NumberCodec(Unit.SECOND, expected, least, most);
  }

  /** A length in centimetres, as metres. */
  static NumberCodec length(double leastCm, double mostCm) {
    Phrase expected = Phrase.of("a length in cm from %s to %s", plain(leastCm), plain(mostCm));
    return new NumberCodec(Unit.CENTIMETER, expected, leastCm, mostCm);
  }

  /** A speed in centimetres a second, as metres a second. */
  static NumberCodec speed(double mostCm) {
    Phrase expected = Phrase.of("a speed in cm/s from 0 to %s", plain(mostCm));
    return new NumberCodec(Unit.CENTIMETER, expected, 0, mostCm);
  }

  @Override
  public Optional<Double> read(Node node, Context context) {
    double value = number(node);
    if (value >= least && value <= most) {
      return Optional.of(inSi(value));
    }
    return context.diagnostics().expected(expected, node);
  }

  @Override
  public Node write(Double value, Path folder) {
    return switch (unit) {
      case ONE, SECOND -> Yaml.number(value);
      case CENTIMETER -> Yaml.number(value * 100);
      case DEGREE -> Yaml.number(degrees(value));
    };
  }

  @Override
  public Map<String, Object> schema(Map<String, Object> definitions) {
    Map<String, Object> schema = Codec.object("type", "number");
    schema.put("minimum", new BigDecimal(plain(least)));
    schema.put("maximum", new BigDecimal(plain(most)));
    return unit == Unit.SECOND
        ? Codec.object("anyOf", List.of(schema, Codec.object("type", "string", "pattern", TIME)))
        : schema;
  }

  /** The number that a node is, or NaN. */
  private double number(Node node) {
    String word = node instanceof ScalarNode scalar && scalar.isPlain() ? scalar.getValue() : "";
    double number = FORM.matcher(word).matches() ? Double.parseDouble(word) : Double.NaN;
    boolean time = unit == Unit.SECOND && word.matches(TIME);
    return rounded(time ? FaultParameter.Unit.SECONDS.read(word).orElse(number) : number);
  }

  private double inSi(double value) {
    if (unit == Unit.CENTIMETER) {
      return Frames.meters(value);
    }
    return unit == Unit.DEGREE ? StrictMath.toRadians(within180(value)) : value;
  }

  /** Above -180 and up to 180, as they are read. */
  private static double degrees(double radians) {
    return within180(rounded(StrictMath.toDegrees(Frames.wrapped(radians))));
  }

  private static double within180(double degrees) {
    double turned = degrees > 180 ? degrees - 360 : degrees;
    return turned <= -180 ? turned + 360 : turned;
  }

  /** To the millionth. */
  static double rounded(double value) {
    double scaled = value * PRECISION;
    return Math.abs(scaled) < 1L << 53 ? Math.rint(scaled) / PRECISION + 0.0 : value;
  }

  /** Without decimals that say nothing. */
  static String plain(double value) {
    return new BigDecimal(Double.toString(rounded(value))).stripTrailingZeros().toPlainString();
  }

  /**
   * A vector of lengths: {@code [x, y]}, whose z is 0, or {@code [x, y, z]}.
   *
   * @param size 2 or 3
   */
  record Vector(int size, NumberCodec length) implements Codec<Vec3> {

    @Override
    public Optional<Vec3> read(Node node, Context context) {
      if (!(node instanceof SequenceNode sequence) || sequence.getValue().size() != size) {
        String names = size == 2 ? "[x, y]" : "[x, y, z]";
        return context
            .diagnostics()
            .expected(
                Phrase.of(
                    "%s in cm, each from %s to %s",
                    names, NumberCodec.plain(length.least()), NumberCodec.plain(length.most())),
                node);
      }
      double[] lengths = new double[3];
      boolean sound = true;
      for (int i = 0; i < size; i++) {
        Optional<Double> read = length.read(sequence.getValue().get(i), context);
        sound &= read.isPresent();
        lengths[i] = read.orElse(0.0);
      }
      return sound ? Optional.of(new Vec3(lengths[0], lengths[1], lengths[2])) : Optional.empty();
    }

    @Override
    public Node write(Vec3 value, Path folder) {
      List<Node> lengths = new ArrayList<>();
      lengths.add(length.write(value.x(), folder));
      lengths.add(length.write(value.y(), folder));
      if (size == 3) {
        lengths.add(length.write(value.z(), folder));
      }
      return new SequenceNode(Tag.SEQ, lengths, FlowStyle.FLOW);
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return Codec.object(
          "type", "array", "minItems", size, "maxItems", size, "items", length.schema(definitions));
    }
  }
}
