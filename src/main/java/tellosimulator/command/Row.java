package tellosimulator.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.words.Phrase;

/**
 * A row of the command table: the syntax of a command and how it is treated. Immutable. {@link
 * CommandSyntax} builds each row step by step.
 *
 * @param verbWords the fixed words at the beginning of the command
 * @param since the SDK that introduced the command
 * @param parameters the parameters, which follow the verb
 * @param traits how the command is treated
 * @param success a description of the reply when the command succeeds
 * @param source the source of the facts in this row
 * @param rule a rule that involves several parameters
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
   * A rule that involves several parameters.
   *
   * @param words a description; empty if there is no rule
   */
  record Rule(String words, BiFunction<Arguments, Profile, Optional<Refusal>> check) {

    static final Rule NONE = new Rule("", (arguments, profile) -> Optional.empty());
  }

  /**
   * How a command is treated.
   *
   * @param busy how it is treated while another command runs
   * @param flight whether it requires an airborne drone
   * @param outOfRange the reply when a parameter is out of range
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

  /**
   * Returns a copy for a flight command. Such a command requires running motors, and is answered
   * when the drone hovers steadily.
   */
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

  // --- matching and checks ---

  /** Whether the words match this command, with the right number and form of parameters. */
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

  /** Returns the words after the verb. */
  Arguments arguments(List<String> words) {
    List<String> joined = joined(words);
    return new Arguments(joined.subList(verbWords.size(), joined.size()));
  }

  /** Joins the last words into one if the last parameter takes the rest of the command. */
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

  /** Returns the refusal of invalid values; empty if the values are valid. */
  Optional<Refusal> complaint(Arguments arguments, Profile profile) {
    for (int i = 0; i < parameters.size(); i++) {
      Optional<Phrase> complaint = parameters.get(i).complaint(arguments.word(i));
      if (complaint.isPresent()) {
        return complaint.map(reason -> new Refusal(traits.outOfRange(), reason));
      }
    }
    return rule.check().apply(arguments, profile);
  }

  /** Whether the values can be out of range. */
  boolean limited() {
    return !rule.words().isEmpty() || parameters.stream().anyMatch(Parameter::limited);
  }

  /**
   * Describes the parameters and their ranges. Adjacent parameters with equal ranges share one
   * description.
   */
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
