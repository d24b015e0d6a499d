package tellosimulator.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.words.Phrase;

/**
 * A row of the table of commands: how a command is written and treated. Immutable; {@link
 * CommandSyntax} makes each step by step.
 *
 * @param verbWords the fixed words that it begins with
 * @param since the SDK that brought it
 * @param parameters the words that follow
 * @param traits how it is treated
 * @param success the reply that says that it was carried out; for people
 * @param source where that is known from
 * @param rule what else must hold of the parameters, together
 */
record Row(
    List<String> verbWords,
    Sdk since,
    List<Parameter> parameters,
    Traits traits,
    String success,
    String source,
    Rule rule) {

  /**
   * What must hold of the parameters together.
   *
   * @param words for people; empty if there is no such rule
   */
  record Rule(String words, BiFunction<Arguments, Profile, Optional<Refusal>> check) {

    static final Rule NONE = new Rule("", (arguments, profile) -> Optional.empty());
  }

  /**
   * How a command is treated.
   *
   * @param busy what happens while another command runs
   * @param flight whether it needs motors that carry the drone
   * @param outOfRange the reply to a parameter that is out of its range
   */
  record Traits(BusyRule busy, boolean flight, Reply outOfRange) {}

  static Row row(String verb, Sdk since) {
    Traits traits = new Traits(BusyRule.REFUSED, false, Reply.ERROR);
    return new Row(
        List.of(verb.split(" ", -1)), since, List.of(), traits, "`ok` at once", "", Rule.NONE);
  }

  Row with(Parameter... more) {
    return new Row(verbWords, since, List.of(more), traits, success, source, rule);
  }

  /** Flies: it needs running motors, and answers when the drone has balanced out. */
  Row flight() {
    Traits flying = new Traits(traits.busy(), true, Reply.OUT_OF_RANGE);
    return new Row(verbWords, since, parameters, flying, "`ok` on arrival", source, rule);
  }

  Row whileBusy(BusyRule busy) {
    Traits changed = new Traits(busy, traits.flight(), traits.outOfRange());
    return new Row(verbWords, since, parameters, changed, success, source, rule);
  }

  Row outOfRange(Reply reply) {
    Traits changed = new Traits(traits.busy(), traits.flight(), reply);
    return new Row(verbWords, since, parameters, changed, success, source, rule);
  }

  Row answers(String words) {
    return new Row(verbWords, since, parameters, traits, words, source, rule);
  }

  Row from(String words) {
    return new Row(verbWords, since, parameters, traits, success, words, rule);
  }

  Row rule(String words, BiFunction<Arguments, Profile, Optional<Refusal>> check) {
    return new Row(verbWords, since, parameters, traits, success, source, new Rule(words, check));
  }

  static Row move(String verb) {
    return row(verb, Sdk.SDK_1_3)
        .with(Parameter.distance("x"))
        .flight()
        .from("FHNW report; SDK 2.0 guide");
  }

  static Row turn(String verb) {
    return row(verb, Sdk.SDK_1_3)
        .with(Parameter.angle("x"))
        .flight()
        .from("FHNW report: the range is not checked");
  }

  static Row read(String verb, Sdk since, String reply) {
    return row(verb, since)
        .whileBusy(BusyRule.READ)
        .answers(reply + ", then CR LF")
        .from(since == Sdk.SDK_3_0 ? "SDK 3.0 guide" : "FHNW report; TelloSwift");
  }

  static Row board(String verb, String part) {
    return row(verb, Sdk.SDK_3_0)
        .whileBusy(BusyRule.READ)
        .outOfRange(new Reply(part + " error"))
        .answers("`" + part + " ok` at once")
        .from("SDK 3.0 guide; RoboMaster SDK");
  }

  // --- what it says of words and values ---

  /** Whether words are this command with the right number and form of parameters. */
  boolean matches(List<String> separate) {
    List<String> words = joined(separate);
    int verbLength = verbWords.size();
    if (words.size() != verbLength + parameters.size()
        || !words.subList(0, verbLength).equals(verbWords)) {
      return false;
    }
    for (int i = 0; i < parameters.size(); i++) {
      if (!parameters.get(i).isForm(words.get(verbLength + i))) {
        return false;
      }
    }
    return true;
  }

  /** The words after the verb. */
  Arguments arguments(List<String> words) {
    List<String> joined = joined(words);
    return new Arguments(joined.subList(verbWords.size(), joined.size()));
  }

  /** The words with those of a text that takes the rest as one. */
  private List<String> joined(List<String> words) {
    int count = verbWords.size() + parameters.size();
    boolean text = parameters.stream().anyMatch(Parameter::takesRest);
    if (!text || words.size() <= count || words.contains("")) {
      return words;
    }
    List<String> joined = new ArrayList<>(words.subList(0, count - 1));
    joined.add(String.join(" ", words.subList(count - 1, words.size())));
    return joined;
  }

  /** What is wrong with the values; empty if nothing is. */
  Optional<Refusal> complaint(Arguments arguments, Profile profile) {
    for (int i = 0; i < parameters.size(); i++) {
      Optional<Phrase> complaint = parameters.get(i).complaint(arguments.word(i));
      if (complaint.isPresent()) {
        return complaint.map(reason -> new Refusal(traits.outOfRange(), reason));
      }
    }
    return rule.check().apply(arguments, profile);
  }

  /** Whether there are values that are out of range. */
  boolean limited() {
    return !rule.words().isEmpty() || parameters.stream().anyMatch(Parameter::limited);
  }

  /** The parameters and their allowed values, for people; neighbours with the same in one. */
  String ranges() {
    StringBuilder ranges = new StringBuilder();
    String before = "";
    for (int i = parameters.size() - 1; i >= 0; i--) {
      Parameter parameter = parameters.get(i);
      String allowed = parameter.allowed().english();
      boolean same = allowed.equals(before);
      before = allowed;
      String separator = ranges.isEmpty() ? "" : "; ";
      ranges.insert(0, parameter.name().symbol() + (same ? ", " : ": " + before + separator));
    }
    if (!rule.words().isEmpty()) {
      ranges.append("; ").append(rule.words());
    }
    return ranges.toString();
  }
}
