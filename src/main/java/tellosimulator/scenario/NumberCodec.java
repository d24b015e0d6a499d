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
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Quantity.Unit;
import tellosimulator.words.Phrase;

/**
 * Codec of a number that may have decimals, or of a range from which it is drawn. The program uses
 * the number in SI units.
 *
 * @param expected a noun phrase for a valid number, for error messages
 */
record NumberCodec(Quantity quantity, Phrase expected) implements Codec<Double> {

  /** The form of numbers: a subset of the forms that Java accepts, with limited length. */
  private static final Pattern FORM =
      Pattern.compile("(?=.{1,40}$)[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?");

  /** The form of a time with its unit. */
  private static final String TIME = "^[0-9]{1,9}(\\.[0-9]{1,9})?(ms|s|min)$";

  /**
   * Number of rounding steps in one unit. Numbers are rounded to a millionth of their unit when
   * they are read, so that a number that is written and read again does not change.
   */
  private static final double PRECISION = 1e6;

  /** Codec of an angle in degrees counter-clockwise, converted to radians within ±π. */
  static final NumberCodec ANGLE =
      new NumberCodec(Quantity.ANGLE, Phrase.of("an angle in degrees from -360 to 360"));

  /** Codec of points that are won or lost. */
  static final NumberCodec POINTS =
      new NumberCodec(
          Quantity.POINTS, Phrase.of("points from 0 to %s", plain(Quantity.POINTS.most())));

  /** Returns a codec for a time in seconds. */
  static NumberCodec seconds(Quantity time) {
    return new NumberCodec(
        time, Phrase.of("seconds from %s to %s", plain(time.least()), plain(time.most())));
  }

  /** Returns a codec for a percentage. */
  static NumberCodec percent(Quantity share) {
    return new NumberCodec(
        share, Phrase.of("percent from %s to %s", plain(share.least()), plain(share.most())));
  }

  /** Returns a codec for a length in centimetres, converted to metres. */
  static NumberCodec length(Quantity length) {
    return new NumberCodec(
        length,
        Phrase.of("a length in cm from %s to %s", plain(length.least()), plain(length.most())));
  }

  /** Returns a codec for a speed in centimetres per second, converted to metres per second. */
  static NumberCodec speed(Quantity speed) {
    return new NumberCodec(speed, Phrase.of("a speed in cm/s from 0 to %s", plain(speed.most())));
  }

  @Override
  public Optional<Double> read(Node node, Context context) {
    Optional<String> word = Scalars.text(node).filter(text -> text.contains(".."));
    if (word.isPresent()) {
      return drawn(word.get(), node, context);
    }
    double value = number(node);
    return quantity.contains(value)
        ? Optional.of(quantity.inSi(value))
        : context.diagnostics().expected(expected, node);
  }

  /** Reads a number that is drawn from a range. */
  private Optional<Double> drawn(String word, Node node, Context context) {
    Optional<CourseDraw.Range> range =
        CourseDraw.Range.of(word)
            .filter(ends -> quantity.contains(ends.least()) && quantity.contains(ends.most()));
    if (range.isPresent() && !context.draw().varies(node)) {
      return context.diagnostics().expected(expected, node); // only courses are drawn
    }
    if (range.isEmpty()) {
      Phrase wanted = Phrase.of("%s, or a range of them such as 80..120", expected);
      return context.diagnostics().expected(wanted, node);
    }
    CourseDraw.Range ends = range.get();
    if (ends.least() > ends.most()) {
      Phrase wanted =
          Phrase.of(
              "the smaller number first, as in %s..%s", plain(ends.most()), plain(ends.least()));
      return context.diagnostics().expected(wanted, node);
    }
    return Optional.of(quantity.inSi(context.draw().number(ends, node)));
  }

  @Override
  public Node write(Double value, Path folder) {
    return Yaml.number(quantity.written(value));
  }

  @Override
  public Map<String, Object> schema(Map<String, Object> definitions) {
    Map<String, Object> schema = Codec.object("type", "number");
    schema.put("minimum", new BigDecimal(plain(quantity.least())));
    schema.put("maximum", new BigDecimal(plain(quantity.most())));
    definitions.put(
        "range",
        Codec.object(
            "description",
            "A range, from which the number is drawn by the seed, such as 80..120.",
            "type",
            "string",
            "pattern",
            CourseDraw.FORM));
    List<Object> forms = new ArrayList<>(List.of(schema, Codec.object("$ref", "#/$defs/range")));
    if (quantity.unit() == Unit.SECOND) {
      forms.add(Codec.object("type", "string", "pattern", TIME));
    }
    return Codec.object("anyOf", forms);
  }

  /** Returns the number in a node; NaN if there is none. */
  private double number(Node node) {
    String word = node instanceof ScalarNode scalar && scalar.isPlain() ? scalar.getValue() : "";
    double number = FORM.matcher(word).matches() ? Double.parseDouble(word) : Double.NaN;
    boolean time = quantity.unit() == Unit.SECOND && word.matches(TIME);
    return rounded(time ? FaultParameter.Unit.SECONDS.read(word).orElse(number) : number);
  }

  /** Rounds to a millionth. Returns numbers that are too large for this unchanged. */
  static double rounded(double value) {
    double scaled = value * PRECISION;
    return Math.abs(scaled) < 1L << 53 ? Math.rint(scaled) / PRECISION + 0.0 : value;
  }

  /** Formats a number without trailing zeros. */
  static String plain(double value) {
    return new BigDecimal(Double.toString(rounded(value))).stripTrailingZeros().toPlainString();
  }

  /**
   * Codec of a vector of lengths: {@code [x, y]}, with z = 0, or {@code [x, y, z]}.
   *
   * @param size the number of components, 2 or 3
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
                    names,
                    NumberCodec.plain(length.quantity().least()),
                    NumberCodec.plain(length.quantity().most())),
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
