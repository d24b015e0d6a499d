package tellosimulator.scenario;

import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import tellosimulator.math.Frames;
import tellosimulator.words.Phrase;

/**
 * How a number is read that may have decimals, and becomes one in SI. Plain code without regular
 * expressions and lambdas, because big files have many numbers, and are read while it is cold.
 *
 * @param unit in which it is written
 * @param expected what is told of a number that is none, or out of range
 * @param least in the written unit
 * @param most in the written unit
 */
record Measure(Unit unit, Phrase expected, double least, double most) implements Value<Double> {

  /** Of what numbers are written; without those of NaN, of infinity and of Java's own suffixes. */
  private static final String LETTERS = "0123456789.+-eE";

  /** Longest number [characters]. Decided: all digits that a double has, twice. */
  private static final int LONGEST = 40;

  /** Most digits of a number that is read as an {@code int}. */
  private static final int MOST_DIGITS = 9;

  /** What a number means. */
  enum Unit {
    /** Itself. */
    ONE,
    /** A length or a speed, which becomes one of metres. */
    CENTIMETRE,
    /** Degrees counter-clockwise, which become radians within ±π. */
    DEGREE
  }

  @Override
  public Optional<Double> read(Node node, Mistakes mistakes) {
    double value = number(node);
    if (value >= least && value <= most) {
      return Optional.of(inSi(value));
    }
    mistakes.add(node, Phrase.of("expected %s, found %s", expected, Values.found(node)));
    return Optional.empty();
  }

  /** The number that a node is, or NaN. */
  private static double number(Node node) {
    String word = node instanceof ScalarNode scalar && scalar.isPlain() ? scalar.getValue() : "";
    double whole = whole(word);
    if (!Double.isNaN(whole) || word.length() > LONGEST || !allOf(LETTERS, word)) {
      return whole;
    }
    try {
      return Values.rounded(Double.parseDouble(word));
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /** The short whole number that a word is, as most are, or NaN. */
  private static double whole(String word) {
    boolean negative = word.startsWith("-");
    int digits = negative ? word.length() - 1 : word.length();
    if (digits < 1 || digits > MOST_DIGITS) {
      return Double.NaN;
    }
    int number = 0;
    for (int i = word.length() - digits; i < word.length(); i++) {
      int digit = word.charAt(i) - '0';
      if (digit < 0 || digit > 9) {
        return Double.NaN;
      }
      number = 10 * number + digit;
    }
    return negative ? -number : number;
  }

  /** Whether there are only some letters in a word. */
  private static boolean allOf(String letters, String word) {
    for (int i = 0; i < word.length(); i++) {
      if (letters.indexOf(word.charAt(i)) < 0) {
        return false;
      }
    }
    return true;
  }

  private double inSi(double value) {
    if (unit == Unit.CENTIMETRE) {
      return Frames.metres(value);
    }
    return unit == Unit.DEGREE ? StrictMath.toRadians(within180(value)) : value;
  }

  private static double within180(double degrees) {
    double turned = degrees > 180 ? degrees - 360 : degrees;
    return turned <= -180 ? turned + 360 : turned;
  }
}
