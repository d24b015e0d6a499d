package tellosimulator.fault;

import java.util.Collections;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import tellosimulator.fault.FaultKind.Range;
import tellosimulator.words.Phrase;

/**
 * A fault to inject: its kind, target, parameters and time. Immutable; for any thread.
 *
 * @param values of all parameters of the kind, in SI
 */
public record Fault(FaultKind kind, Target target, Map<FaultParameter, Double> values, Span span) {

  /**
   * What it concerns.
   *
   * @param drone its number, from 1; empty for all
   * @param directions of a fault of the link; empty for all that the kind has
   */
  public record Target(OptionalInt drone, Set<LinkDirection> directions) {

    /** All drones, and all directions. */
    public static final Target ALL = new Target(OptionalInt.empty(), Set.of());

    public Target {
      Set<LinkDirection> ordered = EnumSet.noneOf(LinkDirection.class);
      ordered.addAll(directions);
      directions = Collections.unmodifiableSet(ordered);
    }
  }

  /**
   * When it acts.
   *
   * @param seconds how long [simulated s]; empty for ever
   */
  public record Span(Begin begin, OptionalDouble seconds) {

    /** From now on, for ever. */
    public static final Span ALWAYS = new Span(new AtOnce(), OptionalDouble.empty());
  }

  /** When a fault begins. */
  public sealed interface Begin {}

  /** As soon as it is known. */
  public record AtOnce() implements Begin {}

  /**
   * After the first takeoff of any drone.
   *
   * @param seconds how long after it [simulated s]
   */
  public record AfterTakeoff(double seconds) implements Begin {}

  /**
   * When a drone takes a command, which is the first that it concerns.
   *
   * @param text what the command begins with
   * @param nth the how manieth such command of the drone, from 1
   */
  public record AfterCommand(String text, int nth) implements Begin {}

  public Fault {
    Map<FaultParameter, Double> complete = new EnumMap<>(FaultParameter.class);
    for (Range range : kind.ranges()) {
      complete.put(range.parameter(), range.usual());
    }
    for (Map.Entry<FaultParameter, Double> value : values.entrySet()) {
      check(kind, value.getKey(), value.getValue());
      complete.put(value.getKey(), value.getValue());
    }
    checkOrder(complete);
    for (LinkDirection direction : target.directions()) {
      if (!kind.directions().contains(direction)) {
        throw new FaultTextException(
            Phrase.of("%s does not concern %s", kind.word(), direction.word()));
      }
    }
    values = Collections.unmodifiableMap(complete);
  }

  private static void check(FaultKind kind, FaultParameter parameter, double value) {
    Range range =
        kind.range(parameter)
            .orElseThrow(
                () ->
                    new FaultTextException(
                        Phrase.of("%s has no %s", kind.word(), parameter.word())));
    if (!(value >= range.least() && value <= range.most())) {
      throw new FaultTextException(
          Phrase.of(
              "%s is %s, but must be from %s to %s",
              parameter.word(),
              parameter.unit().write(value),
              parameter.unit().write(range.least()),
              parameter.unit().write(range.most())));
    }
  }

  private static void checkOrder(Map<FaultParameter, Double> values) {
    Double least = values.get(FaultParameter.LEAST);
    if (least != null
        && !(least <= values.get(FaultParameter.TIME)
            && values.get(FaultParameter.TIME) <= values.get(FaultParameter.MOST))) {
      throw new FaultTextException(Phrase.of("the delay must be from its least to its most"));
    }
  }

  /**
   * Reads a fault of one line, such as {@code loss state 20% drone 2 at 5s for 10s}.
   *
   * @throws FaultTextException with a sentence, if it is none
   */
  public static Fault of(String text) {
    return FaultText.read(text);
  }

  /** A parameter in SI. */
  public double value(FaultParameter parameter) {
    return values.get(parameter);
  }

  /** Whether it concerns a way over the link. */
  public boolean concerns(LinkDirection direction) {
    return target.directions().isEmpty()
        ? kind.directions().contains(direction)
        : target.directions().contains(direction);
  }

  /** Whether it concerns a drone. */
  public boolean concerns(int drone) {
    return target.drone().isEmpty() || target.drone().getAsInt() == drone;
  }

  /** In one line, as it is read. */
  public String text() {
    return FaultText.write(this);
  }

  @Override
  public String toString() {
    return text();
  }
}
