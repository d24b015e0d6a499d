package tellosimulator.fault;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** How much of a fault there is; each has a word and a unit. */
public enum FaultParameter {
  /** The part of all datagrams, or of all moves, that is concerned. */
  SHARE(Unit.PERCENT, "part of the datagrams, or of the moves, that is concerned"),
  /** Mean number of datagrams that are lost in a row. */
  BURST(Unit.NUMBER, "mean number of datagrams that are lost in a row"),
  /** How long it takes. */
  TIME(Unit.MILLISECONDS, "how long it takes"),
  /** What a sixth of all delays exceeds the median by. */
  SPREAD(Unit.MILLISECONDS, "what a sixth of the delays is longer than the median by, or more"),
  /** The shortest delay. */
  LEAST(Unit.MILLISECONDS, "shortest delay"),
  /** The longest delay. */
  MOST(Unit.MILLISECONDS, "longest delay"),
  /** Time from one to the next. */
  EVERY(Unit.MILLISECONDS, "time from one to the next"),
  /** How fast a drone drifts. */
  SPEED(Unit.CENTIMETERS_A_SECOND, "how fast it drifts"),
  /** How high a drone gets. */
  HEIGHT(Unit.CENTIMETERS, "how high it gets"),
  /** What a reading is wrong by. */
  STEP(Unit.CENTIMETERS, "what the reading jumps by"),
  /** How fast a reading turns. */
  TURN(Unit.DEGREES_A_SECOND, "how fast the reading turns"),
  /** What is left. */
  LEVEL(Unit.PERCENT, "what is left"),
  /** How hot something is. */
  HEAT(Unit.CELSIUS, "how hot it gets"),
  /** Bits a second. */
  RATE(Unit.KILOBITS, "how much goes through");

  /** A unit, as people write it. */
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

    /** Units of time, each of which can stand for the others [s]. */
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

    /** A quantity in SI; empty if it is none. Without a unit, this one is meant. */
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

    /** To the billionth, so that what was written is read as the same. */
    private static double inSi(BigDecimal number, double factor) {
      return number.multiply(BigDecimal.valueOf(factor)).doubleValue();
    }

    /** A quantity of SI, as it is read. */
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

    /** Whether a word is a unit that can stand apart from its number. */
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

  /** The word in a fault's text. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What it is, for the documentation. */
  public String words() {
    return words;
  }
}
