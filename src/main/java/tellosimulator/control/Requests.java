package tellosimulator.control;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import tellosimulator.command.WireText;
import tellosimulator.json.Json;
import tellosimulator.junit.SimulatedDrone;
import tellosimulator.junit.TelloSimulator;
import tellosimulator.words.Spelling;

/** The table of what can be asked: name, parameters, what it does. For any thread. */
final class Requests {

  /** What stands beside the parameters. */
  private static final Set<String> ENVELOPE = Set.of("id", "token", "do");

  /** How long is waited unless told otherwise [s]. Decided: as the kit does. */
  private static final double PATIENCE = 30;

  private final Map<String, Request> table = new LinkedHashMap<>();
  private final TelloSimulator simulator;

  private record Request(List<String> parameters, Function<Parameters, Object> result) {}

  Requests(TelloSimulator simulator) {
    this.simulator = simulator;
    tell("drones", List.of(), request -> simulator.drones().stream().map(Answers::drone).toList());
    tell("truth", List.of("drone"), request -> Answers.truth(drone(request).truth()));
    tell("journal", List.of("drone"), this::journal);
    tell("goals", List.of(), request -> Answers.goals(simulator.simulation().goals()));
    tell("explanation", List.of(), request -> simulator.explanation());
    tell(
        "faults",
        List.of("drone"),
        request -> simulator.simulation().faults().running(request.drone()));
    carryOut(
        "inject",
        List.of("fault"),
        request -> simulator.simulation().faults().inject(request.text("fault")));
    carryOut("clear-faults", List.of(), request -> simulator.simulation().faults().clear());
    carryOut(
        "link",
        List.of("preset"),
        request -> simulator.simulation().faults().link(request.text("preset")));
    carryOut("reset", List.of(), request -> simulator.reset());
    carryOut(
        "battery",
        List.of("drone", "percent"),
        request -> drone(request).battery(request.number("percent")));
    carryOut(
        "place",
        List.of("drone", "x", "y", "heading"),
        request ->
            drone(request)
                .placeAt(request.number("x"), request.number("y"), request.number("heading", 0)));
    carryOut("power", List.of("drone", "on"), request -> drone(request).power(request.flag("on")));
    carryOut(
        "wind",
        List.of("speed", "towards"),
        request ->
            simulator.simulation().wind(request.number("speed"), request.number("towards", 0)));
    tell("advance", List.of("seconds"), this::advance);
    carryOut(
        "await-still",
        List.of("timeout"),
        request -> simulator.simulation().awaitStill(request.seconds("timeout", PATIENCE)));
    tell("await-goals", List.of("timeout"), this::awaitGoals);
    tell("await", List.of("drone", "command", "timeout"), this::await);
  }

  private void tell(String name, List<String> parameters, Function<Parameters, Object> result) {
    table.put(name, new Request(parameters, result));
  }

  private void carryOut(String name, List<String> parameters, Consumer<Parameters> what) {
    tell(
        name,
        parameters,
        request -> {
          what.accept(request);
          return Map.of();
        });
  }

  /** The names, in order. */
  List<String> names() {
    return List.copyOf(table.keySet());
  }

  /**
   * Does what is asked, and returns the result once it is done.
   *
   * @throws IllegalArgumentException with a sentence, if the request makes no sense
   * @throws IllegalStateException with a sentence, if it cannot be done now
   * @throws AssertionError with a sentence in its first line, if what is waited for does not come
   */
  Object result(Map<String, Object> request) {
    if (!(request.get("do") instanceof String name)) {
      throw new IllegalArgumentException(
          "the request needs do, one of " + String.join(", ", table.keySet()));
    }
    Request found = table.get(name);
    if (found == null) {
      throw new IllegalArgumentException(
          "there is no request `"
              + WireText.printable(name)
              + "`"
              + Spelling.meant(name, table.keySet())
                  .map(meant -> ", did you mean " + meant + "?")
                  .orElse("; there are " + String.join(", ", table.keySet())));
    }
    Map<String, Object> parameters = new LinkedHashMap<>(request);
    parameters.keySet().removeAll(ENVELOPE);
    parameters.keySet().forEach(parameter -> check(name, found.parameters, parameter));
    return found.result.apply(new Parameters(name, parameters));
  }

  private static void check(String name, List<String> known, String parameter) {
    if (known.contains(parameter)) {
      return;
    }
    List<String> all = new ArrayList<>(known);
    all.addAll(ENVELOPE);
    String those = known.isEmpty() ? "; it has none" : "; it has " + String.join(", ", known);
    throw new IllegalArgumentException(
        name
            + " has no parameter `"
            + WireText.printable(parameter)
            + "`"
            + Spelling.meant(parameter, all)
                .map(meant -> ", did you mean " + meant + "?")
                .orElse(those));
  }

  private SimulatedDrone drone(Parameters parameters) {
    return simulator.drone(parameters.drone());
  }

  private Object journal(Parameters parameters) {
    return drone(parameters).journal().entries().stream().map(Answers::entry).toList();
  }

  private Object advance(Parameters parameters) {
    simulator.simulation().advance(parameters.seconds("seconds"));
    double now = simulator.simulation().time().toNanos() * 1e-9;
    return Map.of("seconds", Json.rounded(now));
  }

  private Object awaitGoals(Parameters parameters) {
    simulator.simulation().awaitGoals(parameters.seconds("timeout", PATIENCE));
    return Answers.goals(simulator.simulation().goals());
  }

  private Object await(Parameters parameters) {
    Duration timeout = parameters.seconds("timeout", PATIENCE);
    return Answers.entry(drone(parameters).journal().await(parameters.text("command"), timeout));
  }
}
