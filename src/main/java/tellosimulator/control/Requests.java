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

/** The table of requests: name, parameters and action. Thread-safe. */
public final class Requests {

  /** The members of a request that are not parameters. */
  private static final Set<String> ENVELOPE = Set.of("id", "token", "do");

  /** Default timeout [s]. Decided: the same as in the test kit. */
  private static final double PATIENCE = 30;

  private final Map<String, Request> table = new LinkedHashMap<>();
  private final TelloSimulator simulator;

  private record Request(List<String> parameters, Function<Parameters, Object> result) {}

  /** Creates the requests to a simulator. */
  public Requests(TelloSimulator simulator) {
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

  /** Returns the names of all requests, in the order of the table. */
  List<String> names() {
    return List.copyOf(table.keySet());
  }

  /**
   * Executes a request and returns its result once it is complete.
   *
   * @throws IllegalArgumentException if the request is invalid; the message is one sentence
   * @throws IllegalStateException if the request cannot be executed now; the message is one
   *     sentence
   * @throws AssertionError if an awaited condition does not occur; the first line of the message is
   *     a sentence
   */
  public Object result(Map<String, Object> request) {
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
              + Spelling.hint(
                  name, table.keySet(), "; there are " + String.join(", ", table.keySet())));
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
            + Spelling.hint(parameter, all, those));
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
