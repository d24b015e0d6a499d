package tellosimulator.fault;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.fault.Fault.AfterCommand;
import tellosimulator.fault.Fault.AfterTakeoff;
import tellosimulator.fault.Fault.AtOnce;
import tellosimulator.fault.Fault.Begin;
import tellosimulator.fault.Fault.Span;
import tellosimulator.fault.Fault.Target;
import tellosimulator.fault.FaultKind.Range;
import tellosimulator.fault.FaultParameter.Unit;
import tellosimulator.words.Phrase;
import tellosimulator.words.Printable;
import tellosimulator.words.Spelling;

/**
 * Parses a fault from one line of text, and formats it as such a line. The line begins with the
 * fault's word. The rest can be in any order: directions, parameters, {@code drone N}, {@code at
 * TIME}, {@code after [2nd] "COMMAND"}, {@code for TIME}. The static methods are thread-safe.
 */
public final class FaultText {

  /** Maximum drone number in a text. */
  private static final int MOST_DRONES = 1000;

  /** Maximum time in a text [s]: one day. */
  public static final double LONGEST = 86_400;

  /** Maximum length of the beginning of a command [characters]. */
  public static final int LONGEST_COMMAND = 100;

  /** Maximum ordinal of a command that triggers a fault. */
  public static final int HIGHEST_NTH = 1000;

  private static final String DRONE = "drone";
  private static final String AT = "at";
  private static final String AFTER = "after";
  private static final String FOR = "for";

  private static final Pattern TOKEN = Pattern.compile("\"([^\"]*)\"|[^\\s\"]+");
  private static final Pattern ORDINAL = Pattern.compile("([0-9]{1,4})(st|nd|rd|th|\\.)");
  private static final Pattern NUMBER = Pattern.compile("[0-9]{1,9}(\\.[0-9]{1,9})?");

  /** A word, or a text in quotation marks. */
  private record Token(String text, boolean quoted) {}

  private final FaultKind kind;
  private final List<Token> tokens;
  private int next = 1;
  private final Set<String> said = new HashSet<>();
  private final Set<LinkDirection> directions = EnumSet.noneOf(LinkDirection.class);
  private final Map<FaultParameter, Double> values = new EnumMap<>(FaultParameter.class);
  private OptionalInt drone = OptionalInt.empty();
  private Begin begin = new AtOnce();
  private OptionalDouble seconds = OptionalDouble.empty();

  private FaultText(List<Token> tokens) {
    this.tokens = tokens;
    this.kind = kind(tokens.get(0).text());
  }

  /**
   * Parses a fault.
   *
   * @throws FaultTextException if the text is not a valid fault; the message is one sentence
   */
  public static Fault read(String text) {
    List<Token> tokens = tokens(text);
    if (tokens.isEmpty()) {
      throw new FaultTextException(
          Phrase.of("expected a fault such as %s, found nothing", "loss state 20%"));
    }
    return new FaultText(tokens).read();
  }

  /**
   * Returns the kind that a word names.
   *
   * @throws FaultTextException if there is no such kind; the message suggests the nearest word
   */
  static FaultKind kind(String word) {
    FaultKind known = FaultKind.byWord().get(word);
    if (known == null) {
      throw unknown(word, FaultKind.byWord().keySet());
    }
    return known;
  }

  /** Creates the exception for an unknown word. */
  static FaultTextException unknown(String word, Collection<String> known) {
    return new FaultTextException(
        Spelling.meant(word, known)
            .map(
                meant ->
                    Phrase.of("there is no %s, did you mean %s?", Printable.quoted(word), meant))
            .orElseGet(
                () ->
                    Phrase.of(
                        "expected one of %s, found %s",
                        String.join(", ", known), Printable.quoted(word))));
  }

  private static List<Token> tokens(String text) {
    List<Token> tokens = new ArrayList<>();
    Matcher matcher = TOKEN.matcher(text.strip());
    while (matcher.find()) {
      boolean quoted = matcher.group(1) != null;
      String word = quoted ? matcher.group(1) : matcher.group();
      Token last = tokens.isEmpty() ? null : tokens.get(tokens.size() - 1);
      if (!quoted && last != null && Unit.known(word) && NUMBER.matcher(last.text()).matches()) {
        tokens.set(tokens.size() - 1, new Token(last.text() + word, false));
      } else {
        tokens.add(new Token(word, quoted));
      }
    }
    return tokens;
  }

  private Fault read() {
    while (next < tokens.size()) {
      take(tokens.get(next++));
    }
    return new Fault(kind, new Target(drone, directions), values, new Span(begin, seconds));
  }

  private void take(Token token) {
    String word = token.text();
    Optional<LinkDirection> direction =
        kind.directions().stream().filter(each -> each.word().equals(word)).findFirst();
    Optional<Range> range =
        kind.ranges().stream().filter(each -> each.parameter().word().equals(word)).findFirst();
    if (token.quoted()) {
      throw unknown(token);
    } else if (direction.isPresent()) {
      once(word);
      directions.add(direction.get());
    } else if (range.isPresent()) {
      value(range.get().parameter(), following(word, example(range.get())));
    } else if (NUMBER.matcher(word.replaceFirst("[a-zC%/]+$", "")).matches()) {
      value(first(word), word);
    } else {
      clause(token);
    }
  }

  private void clause(Token token) {
    String word = token.text();
    switch (word) {
      case DRONE -> {
        once(word);
        drone = OptionalInt.of(count(following(word, "1"), word, MOST_DRONES));
      }
      case AT -> {
        onceOf(word, AFTER);
        begin = new AfterTakeoff(time(following(word, "5s"), word));
      }
      case AFTER -> {
        onceOf(word, AT);
        begin = command();
      }
      case FOR -> {
        once(word);
        seconds = OptionalDouble.of(time(following(word, "10s"), word));
      }
      default -> throw unknown(token);
    }
  }

  private AfterCommand command() {
    String word = following(AFTER, "\"forward\"");
    int nth = 1;
    Matcher ordinal = ORDINAL.matcher(word);
    if (!tokens.get(next - 1).quoted() && ordinal.matches()) {
      nth = count(ordinal.group(1), AFTER, HIGHEST_NTH);
      word = following(AFTER, "2nd \"forward\"");
    }
    return command(word, nth);
  }

  /**
   * Creates a trigger that begins a fault when a command arrives.
   *
   * @throws FaultTextException if the text is empty or too long
   */
  static AfterCommand command(String text, int nth) {
    if (text.isBlank() || text.length() > LONGEST_COMMAND) {
      throw new FaultTextException(
          Phrase.of(
              "after needs what a command begins with, of at most %d letters", LONGEST_COMMAND));
    }
    return new AfterCommand(text, nth);
  }

  private FaultParameter first(String word) {
    if (kind.ranges().isEmpty()) {
      throw new FaultTextException(
          Phrase.of("%s has no value, but %s was found", kind.word(), Printable.quoted(word)));
    }
    return kind.ranges().get(0).parameter();
  }

  private void value(FaultParameter parameter, String word) {
    once(parameter.word());
    values.put(parameter, quantity(parameter, word));
  }

  /**
   * Parses a quantity, and converts it to the unit given at {@link FaultParameter}.
   *
   * @throws FaultTextException if the word is not a quantity
   */
  public static double quantity(FaultParameter parameter, String word) {
    return parameter
        .unit()
        .read(word)
        .orElseThrow(
            () ->
                new FaultTextException(
                    Phrase.of(
                        "%s is a number in %s, but %s was found",
                        parameter.word(), unit(parameter.unit()), Printable.quoted(word))));
  }

  private static Object unit(Unit unit) {
    return unit.symbol().isEmpty() ? Phrase.of("times") : unit.symbol();
  }

  private static String example(Range range) {
    return range.parameter().unit().write(range.usual());
  }

  /**
   * Parses a time, and converts it to seconds.
   *
   * @param clause the word before the time: {@code at} or {@code for}
   * @throws FaultTextException if the word is not a time, or the time is out of range
   */
  public static double time(String word, String clause) {
    return Unit.SECONDS
        .read(word)
        .filter(time -> time <= LONGEST && (time > 0 || !clause.equals(FOR)))
        .orElseThrow(
            () ->
                new FaultTextException(
                    Phrase.of(
                        "%s needs a time such as 5s, of at most a day, but %s was found",
                        clause, Printable.quoted(word))));
  }

  private static int count(String word, String clause, int most) {
    int number = word.matches("[0-9]{1,4}") ? Integer.parseInt(word) : 0;
    if (number < 1 || number > most) {
      throw new FaultTextException(
          Phrase.of(
              "%s needs a number from 1 to %d, but %s was found",
              clause, most, Printable.quoted(word)));
    }
    return number;
  }

  private String following(String word, String example) {
    if (next >= tokens.size()) {
      throw new FaultTextException(
          Phrase.of("%s needs something after it, such as %s", word, example));
    }
    return tokens.get(next++).text();
  }

  private void once(String word) {
    if (!said.add(word)) {
      throw new FaultTextException(Phrase.of("%s is there twice", word));
    }
  }

  private void onceOf(String word, String other) {
    once(word);
    if (said.contains(other)) {
      throw new FaultTextException(Phrase.of("%s does not go with %s", word, other));
    }
  }

  private FaultTextException unknown(Token token) {
    List<String> known = new ArrayList<>();
    kind.directions().forEach(direction -> known.add(direction.word()));
    kind.ranges().forEach(range -> known.add(range.parameter().word()));
    known.addAll(List.of(DRONE, AT, AFTER, FOR));
    String shown = Printable.quoted(token.text());
    return new FaultTextException(
        Spelling.meant(token.text(), known)
            .map(meant -> Phrase.of("%s has no %s, did you mean %s?", kind.word(), shown, meant))
            .orElseGet(
                () ->
                    Phrase.of(
                        "%s has no %s, but only %s",
                        kind.word(), shown, String.join(", ", known))));
  }

  // --- formatting ---

  static String write(Fault fault) {
    StringBuilder text = new StringBuilder(what(fault));
    fault.target().drone().ifPresent(number -> text.append(" drone ").append(number));
    Begin begin = fault.span().begin();
    if (begin instanceof AfterTakeoff takeoff) {
      text.append(" at ").append(Unit.SECONDS.write(takeoff.seconds()));
    } else if (begin instanceof AfterCommand command) {
      text.append(" after ");
      if (command.nth() > 1) {
        text.append(ordinal(command.nth())).append(' ');
      }
      text.append('"').append(command.text()).append('"');
    }
    fault.span().seconds().ifPresent(time -> text.append(" for ").append(Unit.SECONDS.write(time)));
    return text.toString();
  }

  private static String what(Fault fault) {
    StringBuilder text = new StringBuilder(fault.kind().word());
    fault.target().directions().forEach(each -> text.append(' ').append(each.word()));
    List<Range> ranges = fault.kind().ranges();
    for (Range range : ranges) {
      double value = fault.value(range.parameter());
      boolean first = range.equals(ranges.get(0));
      if (first || value != range.usual()) {
        text.append(first ? " " : " " + range.parameter().word() + " ");
        text.append(range.parameter().unit().write(value));
      }
    }
    return text.toString();
  }

  private static String ordinal(int number) {
    String ending =
        switch (number % 100 / 10 == 1 ? 0 : number % 10) {
          case 1 -> "st";
          case 2 -> "nd";
          case 3 -> "rd";
          default -> "th";
        };
    return String.format(Locale.ROOT, "%d%s", number, ending);
  }
}
