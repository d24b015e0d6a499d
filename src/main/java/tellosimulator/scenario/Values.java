package tellosimulator.scenario;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import org.snakeyaml.engine.v2.resolver.JsonScalarResolver;
import org.snakeyaml.engine.v2.resolver.ScalarResolver;
import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.Measure.Unit;
import tellosimulator.words.Phrase;
import tellosimulator.words.Spelling;

/**
 * How single values are read, and what is said if they cannot be. What is read of each obstacle is
 * in records rather than lambdas, because a program that has just started makes these more slowly.
 */
final class Values {

  /** What YAML's usual schema takes a text for. */
  private static final ScalarResolver MEANING = new JsonScalarResolver();

  private static final Pattern WHOLE_NUMBER = Pattern.compile("-?[0-9]{1,18}");

  private static final Pattern ADDRESS =
      Pattern.compile("((25[0-5]|2[0-4][0-9]|1?[0-9]?[0-9])(\\.(?!$)|$)){4}");

  private static final Pattern COLOUR = Pattern.compile("#[0-9a-fA-F]{6}");

  /** Longest text [characters]. Decided: a line or two. */
  private static final int LONGEST_TEXT = 200;

  /** Longest piece of a file that is repeated in a sentence [characters]. */
  private static final int LONGEST_SHOWN = 40;

  /** Numbers are read to the millionth, so that they are the same after they were written. */
  private static final double PRECISION = 1e6;

  private Values() {}

  /** A number that may have decimals. */
  static Value<Double> number(Phrase expected, double least, double most) {
    return new Measure(Unit.ONE, expected, least, most);
  }

  /** A length in centimetres, as metres. */
  static Value<Double> length(double leastCm, double mostCm) {
    Phrase expected = Phrase.of("a length in cm from %s to %s", plain(leastCm), plain(mostCm));
    return new Measure(Unit.CENTIMETRE, expected, leastCm, mostCm);
  }

  /** A speed in centimetres a second, as metres a second. */
  static Value<Double> speed(double mostCm) {
    Phrase expected = Phrase.of("a speed in cm/s from 0 to %s", plain(mostCm));
    return new Measure(Unit.CENTIMETRE, expected, 0, mostCm);
  }

  /** Degrees counter-clockwise, as radians within ±π. */
  static Value<Double> angle() {
    return new Measure(Unit.DEGREE, Phrase.of("an angle in degrees from -360 to 360"), -360, 360);
  }

  /** A whole number. */
  static Value<Long> whole(Phrase expected, long least, long most) {
    return (node, mistakes) -> {
      Optional<Long> number =
          plain(node)
              .filter(word -> WHOLE_NUMBER.matcher(word).matches())
              .map(Long::valueOf)
              .filter(value -> value >= least && value <= most);
      return orMistake(number, expected, node, mistakes);
    };
  }

  /** A small whole number. */
  static Value<Integer> count(Phrase expected, int least, int most) {
    return map(whole(expected, least, most), Math::toIntExact);
  }

  static Value<Integer> port() {
    return count(Phrase.of("a port from 1 to 65535"), 1, 65_535);
  }

  /** A line of text that is not empty. */
  static Value<String> text() {
    return Values::line;
  }

  private static Optional<String> line(Node node, Mistakes mistakes) {
    if (node instanceof ScalarNode scalar && isText(scalar)) {
      String text = scalar.getValue().strip();
      if (oneLine(text)) {
        return Optional.of(text);
      }
    }
    return orMistake(
        Optional.empty(),
        Phrase.of("a line of text of at most %d letters", LONGEST_TEXT),
        node,
        mistakes);
  }

  /** Whether it is in quotation marks, or would not be a number or the like to other programs. */
  private static boolean isText(ScalarNode scalar) {
    return !scalar.isPlain() || MEANING.resolve(scalar.getValue(), true).equals(Tag.STR);
  }

  private static boolean oneLine(String text) {
    if (text.isEmpty() || text.length() > LONGEST_TEXT) {
      return false;
    }
    for (int i = 0; i < text.length(); i++) {
      if (Character.isISOControl(text.charAt(i))) {
        return false;
      }
    }
    return true;
  }

  /** One of some words. */
  static <T> Value<T> word(Map<String, T> words) {
    return new Word<>(words);
  }

  private record Word<T>(Map<String, T> words) implements Value<T> {

    @Override
    public Optional<T> read(Node node, Mistakes mistakes) {
      Optional<String> written = scalar(node);
      Optional<T> meant = written.map(words::get);
      if (meant.isPresent()) {
        return meant;
      }
      String known = String.join(", ", new TreeMap<>(words).keySet());
      Optional<String> guess = written.flatMap(word -> Spelling.meant(word, words.keySet()));
      mistakes.add(
          node,
          guess.isPresent()
              ? Phrase.of(
                  "expected one of %s, found %s, did you mean %s?", known, found(node), guess.get())
              : Phrase.of("expected one of %s, found %s", known, found(node)));
      return Optional.empty();
    }
  }

  static Value<Boolean> yesOrNo() {
    return word(Map.of("true", true, "false", false));
  }

  /** A colour as #rrggbb or by its name. */
  static Value<Integer> colour() {
    return (node, mistakes) ->
        scalar(node).filter(word -> COLOUR.matcher(word).matches()).isPresent()
            ? scalar(node).map(word -> Integer.parseInt(word.substring(1), 16))
            : orMistake(
                scalar(node).map(Colours.BY_NAME::get),
                Phrase.of(
                    "a colour such as \"#d9772b\", or one of %s",
                    String.join(", ", new TreeMap<>(Colours.BY_NAME).keySet())),
                node,
                mistakes);
  }

  /** An IPv4 address. */
  static Value<InetAddress> address() {
    return (node, mistakes) ->
        orMistake(
            scalar(node)
                .filter(word -> ADDRESS.matcher(word).matches())
                .map(Values::inet)
                .filter(AddressPlan::isOfOneHost),
            Phrase.of("an address of this machine such as 127.0.0.2"),
            node,
            mistakes);
  }

  private static InetAddress inet(String word) {
    try {
      return InetAddress.getByName(word);
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException(word + " is no address", e);
    }
  }

  /** As many numbers as there are names, such as {@code [x, y]}. */
  static Value<List<Double>> lengths(String names, double leastCm, double mostCm) {
    int size = names.split(",", -1).length;
    Phrase expected =
        Phrase.of("%s in cm, each from %s to %s", "[" + names + "]", plain(leastCm), plain(mostCm));
    return new Lengths(size, expected, length(leastCm, mostCm));
  }

  private record Lengths(int size, Phrase expected, Value<Double> length)
      implements Value<List<Double>> {

    @Override
    public Optional<List<Double>> read(Node node, Mistakes mistakes) {
      if (!(node instanceof SequenceNode sequence) || sequence.getValue().size() != size) {
        return orMistake(Optional.empty(), expected, node, mistakes);
      }
      List<Double> lengths = new ArrayList<>();
      for (Node item : sequence.getValue()) {
        Optional<Double> read = length.read(item, mistakes);
        if (read.isPresent()) {
          lengths.add(read.get());
        }
      }
      return lengths.size() == size ? Optional.of(List.copyOf(lengths)) : Optional.empty();
    }
  }

  /** What a value becomes. */
  static <S, T> Value<T> map(Value<S> value, Function<S, T> change) {
    return new Changed<>(value, change);
  }

  private record Changed<S, T>(Value<S> value, Function<S, T> change) implements Value<T> {

    @Override
    public Optional<T> read(Node node, Mistakes mistakes) {
      return value.read(node, mistakes).map(change);
    }
  }

  /** What is in a node, for people: {@code "abc"}. */
  static Object found(Node node) {
    if (node instanceof MappingNode) {
      return Phrase.of("a mapping");
    }
    if (node instanceof SequenceNode sequence) {
      return Phrase.of("a list of %d", sequence.getValue().size());
    }
    ScalarNode scalar = (ScalarNode) node;
    return scalar.isPlain() && scalar.getValue().isEmpty()
        ? Phrase.of("nothing")
        : shown(scalar.getValue());
  }

  /** A piece of a file in quotation marks. */
  static String shown(String text) {
    String clean =
        text.codePoints()
            .map(c -> Character.isISOControl(c) ? ' ' : c)
            .limit(LONGEST_SHOWN)
            .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
            .toString();
    return "\"" + clean + (clean.length() < text.length() ? "…" : "") + "\"";
  }

  /** To the millionth. */
  static double rounded(double value) {
    double scaled = value * PRECISION;
    return Math.abs(scaled) < 1L << 53 ? Math.rint(scaled) / PRECISION + 0.0 : value;
  }

  /** Without decimals that say nothing. */
  static String plain(double value) {
    return new java.math.BigDecimal(Double.toString(rounded(value)))
        .stripTrailingZeros()
        .toPlainString();
  }

  /** What is written without quotation marks. */
  private static Optional<String> plain(Node node) {
    return node instanceof ScalarNode scalar && scalar.isPlain()
        ? Optional.of(scalar.getValue())
        : Optional.empty();
  }

  private static Optional<String> scalar(Node node) {
    return node instanceof ScalarNode scalar ? Optional.of(scalar.getValue()) : Optional.empty();
  }

  private static <T> Optional<T> orMistake(
      Optional<T> value, Phrase expected, Node node, Mistakes mistakes) {
    if (value.isEmpty()) {
      mistakes.add(node, Phrase.of("expected %s, found %s", expected, found(node)));
    }
    return value;
  }
}
