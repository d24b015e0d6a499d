package tellosimulator.command;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;

/**
 * What is known of a command besides its name and its record. Immutable; made step by step by the
 * table of {@link CommandSyntax}.
 *
 * @param verb the fixed words at the beginning
 * @param since the SDK that brought it
 * @param parameters the words that follow
 * @param traits how it is treated
 * @param success the reply that says that it was carried out; for people
 * @param source where that is known from
 * @param rule what else must hold of the parameters, together
 */
record Row(
    String verb,
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
    return new Row(verb, since, List.of(), traits, "`ok` at once", "", Rule.NONE);
  }

  Row with(Parameter... more) {
    return new Row(verb, since, List.of(more), traits, success, source, rule);
  }

  /** Flies: it needs running motors, and answers when the drone has balanced out. */
  Row flight() {
    Traits flying = new Traits(traits.busy(), true, Reply.OUT_OF_RANGE);
    return new Row(verb, since, parameters, flying, "`ok` on arrival", source, rule);
  }

  Row whileBusy(BusyRule busy) {
    Traits changed = new Traits(busy, traits.flight(), traits.outOfRange());
    return new Row(verb, since, parameters, changed, success, source, rule);
  }

  Row outOfRange(Reply reply) {
    Traits changed = new Traits(traits.busy(), traits.flight(), reply);
    return new Row(verb, since, parameters, changed, success, source, rule);
  }

  Row answers(String words) {
    return new Row(verb, since, parameters, traits, words, source, rule);
  }

  Row from(String words) {
    return new Row(verb, since, parameters, traits, success, words, rule);
  }

  Row rule(String words, BiFunction<Arguments, Profile, Optional<Refusal>> check) {
    return new Row(verb, since, parameters, traits, success, source, new Rule(words, check));
  }
}
