package tellosimulator.scenario;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import org.snakeyaml.engine.v2.resolver.JsonScalarResolver;
import org.snakeyaml.engine.v2.resolver.ScalarResolver;
import tellosimulator.math.Frames;
import tellosimulator.words.Phrase;

/** How single values are read, and what is said if they cannot be. */
final class Values {

  /** Of what numbers are written; without those of NaN, of infinity and of Java's own suffixes. */
  private static final String NUMBER_LETTERS = "0123456789.+-eE";

  /** What YAML's usual schema takes a text for. */
  private static final ScalarResolver MEANING = new JsonScalarResolver();

  private static final Pattern WHOLE_NUMBER = Pattern.compile("-?[0-9]{1,18}");

  private static final Pattern ADDRESS =
      Pattern.compile("((25[0-5]|2[0-4][0-9]|1?[0-9]?[0-9])(\\.(?!$)|$)){4}");

  private static final Pattern COLOUR = Pattern.compile("#[0-9a-fA-F]{6}");

  /** Longest number [characters]. Decided: all digits that a double has, twice. */
  private static final int LONGEST_NUMBER = 40;

  /** Longest text [characters]. Decided: a line or two. */
  private static final int LONGEST_TEXT = 200;

  /** Longest piece of a file that is repeated in a sentence [characters]. */
  private static final int LONGEST_SHOWN = 40;

  /** Numbers are read to the millionth, so that they are the same after they were written. */
  private static final double PRECISION = 1e6;

  private Values() {}

  /** A number that may have decimals. */
  static Value<Double> number(Phrase expected, double least, double most) {
    return (node, mistakes) -> {
      double value = number(node);
      Optional<Double> number =
          value >= least && value <= most ? Optional.of(value) : Optional.empty();
      return orMistake(number, expected, node, mistakes);
    };
  }

  /** The number that a node is, or NaN. */
  private static double number(Node node) {
    String word = node instanceof ScalarNode scalar && scalar.isPlain() ? scalar.getValue() : "";
    if (word.length() > LONGEST_NUMBER || !allOf(NUMBER_LETTERS, word)) {
      return Double.NaN;
    }
    try {
      return rounded(Double.parseDouble(word));
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /** Whether there are only some letters in a word. A loop, because big files have many numbers. */
  private static boolean allOf(String letters, String word) {
    for (int i = 0; i < word.length(); i++) {
      if (letters.indexOf(word.charAt(i)) < 0) {
        return false;
      }
    }
    return true;
  }

  /** A length in centimetres, as metres. */
  static Value<Double> length(double leastCm, double mostCm) {
    Phrase expected = Phrase.of("a length in cm from %s to %s", plain(leastCm), plain(mostCm));
    return map(number(expected, leastCm, mostCm), Frames::metres);
  }

  /** A speed in centimetres a second, as metres a second. */
  static Value<Double> speed(double mostCm) {
    return map(
        number(Phrase.of("a speed in cm/s from 0 to %s", plain(mostCm)), 0, mostCm),
        Frames::metres);
  }

  /** Degrees counter-clockwise, as radians within ±π. */
  static Value<Double> angle() {
    return map(
        number(Phrase.of("an angle in degrees from -360 to 360"), -360, 360),
        degrees -> StrictMath.toRadians(within180(degrees)));
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
    return (node, mistakes) -> {
      Optional<String> text =
          node instanceof ScalarNode scalar && isText(scalar)
              ? Optional.of(scalar.getValue().strip()).filter(Values::oneLine)
              : Optional.empty();
      return orMistake(
          text, Phrase.of("a line of text of at most %d letters", LONGEST_TEXT), node, mistakes);
    };
  }

  /** Whether it is in quotation marks, or would not be a number or the like to other programs. */
  private static boolean isText(ScalarNode scalar) {
    return !scalar.isPlain() || MEANING.resolve(scalar.getValue(), true).equals(Tag.STR);
  }

  private static boolean oneLine(String text) {
    return !text.isEmpty()
        && text.length() <= LONGEST_TEXT
        && text.chars().noneMatch(Character::isISOControl);
  }

  /** One of some words. */
  static <T> Value<T> word(Map<String, T> words) {
    Map<String, T> sorted = new TreeMap<>(words);
    return (node, mistakes) -> {
      Optional<String> written = scalar(node);
      Optional<T> meant = written.map(words::get);
      if (meant.isPresent()) {
        return meant;
      }
      String known = String.join(", ", sorted.keySet());
      Optional<String> guess = written.flatMap(word -> Spelling.meant(word, words.keySet()));
      mistakes.add(
          node,
          guess.isPresent()
              ? Phrase.of(
                  "expected one of %s, found %s, did you mean %s?", known, found(node), guess.get())
              : Phrase.of("expected one of %s, found %s", known, found(node)));
      return Optional.empty();
    };
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
            scalar(node).filter(word -> ADDRESS.matcher(word).matches()).map(Values::inet),
            Phrase.of("an address such as 127.0.0.2"),
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
    Value<Double> length = length(leastCm, mostCm);
    return (node, mistakes) -> {
      if (!(node instanceof SequenceNode sequence) || sequence.getValue().size() != size) {
        return orMistake(Optional.empty(), expected, node, mistakes);
      }
      List<Double> lengths = new ArrayList<>();
      for (Node item : sequence.getValue()) {
        length.read(item, mistakes).ifPresent(lengths::add);
      }
      return lengths.size() == size ? Optional.of(List.copyOf(lengths)) : Optional.empty();
    };
  }

  static <S, T> Value<T> map(Value<S> value, java.util.function.Function<S, T> change) {
    return (node, mistakes) -> value.read(node, mistakes).map(change);
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

  private static double within180(double degrees) {
    double turned = degrees > 180 ? degrees - 360 : degrees;
    return turned <= -180 ? turned + 360 : turned;
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
