package tellosimulator.command;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import tellosimulator.words.Phrase;

/** A parameter of a command. It defines the form and range of a word. */
sealed interface Parameter {

  Name name();

  /** Returns the allowed values, in plain words. */
  Phrase allowed();

  /** Whether words of the right form can be out of range. */
  boolean limited();

  /** Whether the parameter takes the entire rest of a command, including spaces. */
  default boolean takesRest() {
    return false;
  }

  /** Whether a word has the right form. If not, the command is unknown. */
  boolean isForm(String word);

  /** Returns the reason why a word of the right form is invalid; empty if the word is valid. */
  Optional<Phrase> complaint(String word);

  /**
   * The name of a parameter.
   *
   * @param symbol the symbol, in the style of the guides
   * @param subject the subject of sentences about the parameter's value: the symbol, or a
   *     description if the symbol alone would be unclear
   */
  record Name(String symbol, Phrase subject) {

    /** Returns a name whose symbol is also the subject. */
    static Name of(String symbol) {
      return new Name(symbol, Phrase.of("%s", symbol));
    }
  }

  static Name named(String symbol, Phrase subject) {
    return new Name(symbol, subject);
  }

  /** Returns a parameter for a number without a range. */
  static Parameter number(Name name, String unit) {
    return number(name, unit, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
  }

  /** Returns a parameter for a number within a range, both ends included. */
  static Parameter number(Name name, String unit, double least, double most) {
    return new Numeric(name, unit, least, most, false);
  }

  /** Returns a parameter for a whole number within a range, both ends included. */
  static Parameter whole(Name name, int least, int most) {
    return new Numeric(name, "", least, most, true);
  }

  static Parameter whole(String symbol, int least, int most) {
    return whole(Name.of(symbol), least, most);
  }

  /** Returns a parameter for a choice of words. */
  static Parameter choice(Name name, String... words) {
    return new OptionValue(name, List.of(words));
  }

  static Parameter choice(String symbol, String... words) {
    return choice(Name.of(symbol), words);
  }

  /** Returns a parameter that takes any word. */
  static Parameter word(String symbol) {
    return new Word(Name.of(symbol), false);
  }

  /** Returns a parameter that takes all remaining words as one text with single spaces. */
  static Parameter text(String symbol) {
    return new Word(Name.of(symbol), true);
  }

  // --- shared by several commands ---

  static Parameter cm(String symbol) {
    return number(Name.of(symbol), "cm", -500, 500);
  }

  static Parameter distance(String symbol) {
    return number(named(symbol, Phrase.of("the distance")), "cm", 20, 500);
  }

  static Parameter angle(String symbol) {
    return number(named(symbol, Phrase.of("the angle")), "degrees");
  }

  static Parameter speed(String symbol) {
    return speed(symbol, 100);
  }

  static Parameter curveSpeed() {
    return speed("speed", 60);
  }

  private static Parameter speed(String symbol, double most) {
    return number(named(symbol, Phrase.of("the speed")), "cm/s", 10, most);
  }

  static Parameter stick(String symbol) {
    return number(Name.of(symbol), "", -100, 100);
  }

  static Parameter pad(String name) {
    return choice(name, "m1", "m2", "m3", "m4", "m5", "m6", "m7", "m8", "m-1", "m-2");
  }

  static Parameter rgb(String name) {
    return whole(name, 0, 255);
  }

  static Parameter hertz() {
    return number(Name.of("t"), "Hz", 0.1, 2.5);
  }

  static Parameter color() {
    return choice("colour", "r", "b", "p");
  }

  /**
   * A number in decimal digits.
   *
   * @param whole whether a fraction is out of range
   */
  record Numeric(Name name, String unit, double least, double most, boolean whole)
      implements Parameter {

    /**
     * The form of a number. Decided: ASCII digits, at most 15 characters, no exponent, no plus
     * sign.
     */
    private static final Pattern FORM = Pattern.compile("-?[0-9]+(\\.[0-9]+)?");

    private static final int LONGEST = 15;

    @Override
    public boolean limited() {
      return least > Double.NEGATIVE_INFINITY || most < Double.POSITIVE_INFINITY;
    }

    @Override
    public Phrase allowed() {
      Phrase range = limited() ? Phrase.of("%s to %s", text(least), text(most)) : Phrase.of("any");
      return unit.isEmpty() ? range : Phrase.of("%s %s", range, unit);
    }

    @Override
    public boolean isForm(String word) {
      return word.length() <= LONGEST && FORM.matcher(word).matches();
    }

    @Override
    public Optional<Phrase> complaint(String word) {
      double value = Double.parseDouble(word);
      if (whole && value != Math.rint(value)) {
        return Optional.of(Phrase.of("%s is %s, but must be a whole number", name.subject(), word));
      }
      return value >= least && value <= most
          ? Optional.empty()
          : Optional.of(
              Phrase.of("%s is %s, but must be from %s", name.subject(), word, allowed()));
    }

    private static String text(double value) {
      return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }
  }

  /**
   * One of several words. Any other word is out of range. The empty word between two spaces has the
   * wrong form.
   */
  record OptionValue(Name name, List<String> words) implements Parameter {

    @Override
    public boolean limited() {
      return true;
    }

    @Override
    public Phrase allowed() {
      return Phrase.of("%s", String.join(", ", words));
    }

    @Override
    public boolean isForm(String word) {
      return !word.isEmpty();
    }

    @Override
    public Optional<Phrase> complaint(String word) {
      return words.contains(word)
          ? Optional.empty()
          : Optional.of(
              Phrase.of(
                  "%s is %s, but must be one of %s",
                  name.subject(), WireText.printable(word), String.join(", ", words)));
    }
  }

  /**
   * Any word, except for the empty word between two spaces.
   *
   * @param takesRest whether the parameter extends to the end of the command, including spaces
   */
  record Word(Name name, boolean takesRest) implements Parameter {

    @Override
    public boolean limited() {
      return false;
    }

    @Override
    public Phrase allowed() {
      return takesRest ? Phrase.of("any text") : Phrase.of("any word");
    }

    @Override
    public boolean isForm(String word) {
      return !word.isEmpty();
    }

    @Override
    public Optional<Phrase> complaint(String word) {
      return Optional.empty();
    }
  }
}
