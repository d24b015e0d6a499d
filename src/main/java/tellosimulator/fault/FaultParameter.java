package tellosimulator.fault;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The parameters of faults, each with a word and a unit. The comment on each parameter gives the
 * unit of its value; a fault's text can contain another unit.
 */
public enum FaultParameter {
  /** The affected share of all datagrams, or of all moves, from 0 to 1. */
  SHARE(Unit.PERCENT, "part of the datagrams, or of the moves, that is concerned"),
  /** Mean number of consecutive lost datagrams. */
  BURST(Unit.NUMBER, "mean number of datagrams that are lost in a row"),
  /** A duration or delay [s]. */
  TIME(Unit.MILLISECONDS, "how long it takes"),
  /** Spread of the delays [s]: a sixth of them exceeds the median by at least this much. */
  SPREAD(Unit.MILLISECONDS, "what a sixth of the delays is longer than the median by, or more"),
  /** The minimum delay [s]. */
  LEAST(Unit.MILLISECONDS, "shortest delay"),
  /** The maximum delay [s]. */
  MOST(Unit.MILLISECONDS, "longest delay"),
  /** The period of a repeated effect [s]. */
  EVERY(Unit.MILLISECONDS, "time from one to the next"),
  /** The speed at which a drone drifts [m/s]. */
  SPEED(Unit.CENTIMETERS_A_SECOND, "how fast it drifts"),
  /** The height that a drone reaches [m]. */
  HEIGHT(Unit.CENTIMETERS, "how high it gets"),
  /** The error of a reading [m]. */
  STEP(Unit.CENTIMETERS, "what the reading jumps by"),
  /** The rate at which a reading turns [degrees/s]. */
  TURN(Unit.DEGREES_A_SECOND, "how fast the reading turns"),
  /** The remaining charge, from 0 to 1. */
  LEVEL(Unit.PERCENT, "what is left"),
  /** A temperature [°C]. */
  HEAT(Unit.CELSIUS, "how hot it gets"),
  /** A bit rate [bit/s]. */
  RATE(Unit.KILOBITS, "how much goes through");

  /** A unit in a fault's text, with the factor that converts it to the unit of the value. */
  public enum Unit {
    PERCENT("%", 0.01),
    NUMBER("", 1),
    MILLISECONDS("ms", 0.001),
    SECONDS("s", 1),
    KILOBITS("kbit/s", 1000),
    CENTIMETERS("cm", 0.01),
    CENTIMETERS_A_SECOND("cm/s", 0.01),
    DEGREES_A_SECOND("deg/s", 1),
    CELSIUS("C", 1);

    private static final Pattern QUANTITY =
        Pattern.compile("([0-9]{1,9}(?:\\.[0-9]{1,9})?)([a-zC%/]*)");

    /** The units of time, with their lengths [s]. They are interchangeable in a text. */
    private static final Map<String, Double> TIMES = Map.of("ms", 0.001, "s", 1.0, "min", 60.0);

    private final String symbol;
    private final double factor;

    Unit(String symbol, double factor) {
      this.symbol = symbol;
      this.factor = factor;
    }

    String symbol() {
      return symbol;
    }

    /**
     * Parses a quantity, and converts it to the unit of the value. A number without a unit is taken
     * to be in this unit.
     *
     * @return the value; empty if the word is not a quantity
     */
    public Optional<Double> read(String word) {
      Matcher parts = QUANTITY.matcher(word);
      if (!parts.matches()) {
        return Optional.empty();
      }
      BigDecimal number = new BigDecimal(parts.group(1));
      String unit = parts.group(2);
      if (unit.isEmpty() || unit.equals(symbol)) {
        return Optional.of(inSi(number, factor));
      }
      boolean time = TIMES.containsKey(symbol);
      return Optional.ofNullable(time ? TIMES.get(unit) : null).map(of -> inSi(number, of));
    }

    /**
     * Converts a number in decimal arithmetic, so that a formatted quantity is parsed to the same
     * value.
     */
    private static double inSi(BigDecimal number, double factor) {
      return number.multiply(BigDecimal.valueOf(factor)).doubleValue();
    }

    /** Formats a value as a quantity in this unit. */
    String write(double value) {
      BigDecimal number = BigDecimal.valueOf(value);
      if (this == MILLISECONDS || this == SECONDS) {
        boolean seconds = value >= 1 || (this == SECONDS && value == 0);
        return plain(seconds ? number : number.movePointRight(3)) + (seconds ? "s" : "ms");
      }
      return plain(number.multiply(BigDecimal.valueOf(1 / factor))) + symbol;
    }

    private static String plain(BigDecimal number) {
      BigDecimal stripped =
          number.setScale(9, java.math.RoundingMode.HALF_EVEN).stripTrailingZeros();
      return stripped.toPlainString();
    }

    /** Whether a word is a unit. A space may separate it from its number. */
    static boolean known(String word) {
      return TIMES.containsKey(word)
          || java.util.Arrays.stream(values()).anyMatch(unit -> unit.symbol.equals(word));
    }
  }

  private final Unit unit;
  private final String words;

  FaultParameter(Unit unit, String words) {
    this.unit = unit;
    this.words = words;
  }

  public Unit unit() {
    return unit;
  }

  /** Returns the word in a fault's text. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns a description for the documentation. */
  public String words() {
    return words;
  }
}
