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
 * A fault to inject: its kind, target, parameters and time. Immutable.
 *
 * @param values the values of all parameters of the kind, in the units given at {@link
 *     FaultParameter}
 */
public record Fault(FaultKind kind, Target target, Map<FaultParameter, Double> values, Span span) {

  /**
   * The target of a fault.
   *
   * @param drone the number of the drone, from 1; empty for all drones
   * @param directions the directions of a link fault; empty for all directions of the kind
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
   * The time during which a fault is active.
   *
   * @param seconds the duration [simulated s]; empty if the fault never ends
   */
  public record Span(Begin begin, OptionalDouble seconds) {

    /** The fault begins at once and never ends. */
    public static final Span ALWAYS = new Span(new AtOnce(), OptionalDouble.empty());
  }

  /** The trigger that begins a fault. */
  public sealed interface Begin {}

  /** The fault begins at the start of the simulation, or when it is injected. */
  public record AtOnce() implements Begin {}

  /**
   * The fault begins after the first takeoff of any drone.
   *
   * @param seconds the time after the takeoff [simulated s]
   */
  public record AfterTakeoff(double seconds) implements Begin {}

  /**
   * The fault begins when a drone receives a command. This command is the first to be affected.
   *
   * @param text the beginning of the command
   * @param nth which of the drone's commands with this beginning triggers the fault, from 1
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
   * Parses a fault from one line, such as {@code loss state 20% drone 2 at 5s for 10s}.
   *
   * @throws FaultTextException if the text is not a valid fault; the message is one sentence
   */
  public static Fault of(String text) {
    return FaultText.read(text);
  }

  /**
   * Returns the value of a parameter that the kind has, in the unit given at {@link
   * FaultParameter}.
   */
  public double value(FaultParameter parameter) {
    return values.get(parameter);
  }

  /** Whether the fault affects a direction of the link. */
  public boolean concerns(LinkDirection direction) {
    return target.directions().isEmpty()
        ? kind.directions().contains(direction)
        : target.directions().contains(direction);
  }

  /** Whether the fault affects a drone. */
  public boolean concerns(int drone) {
    return target.drone().isEmpty() || target.drone().getAsInt() == drone;
  }

  /** Formats the fault as a line that {@link #of} can parse. */
  public String text() {
    return FaultText.write(this);
  }

  @Override
  public String toString() {
    return text();
  }
}
