package tellosimulator.fidelity;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import tellosimulator.benchmark.Statistics;
import tellosimulator.comparison.CommandPair;
import tellosimulator.comparison.FlightComparison;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.comparison.FlownCommand;
import tellosimulator.comparison.FlownCommand.Motion;
import tellosimulator.comparison.Tolerance;

/**
 * The tables of docs/fidelity.md: a published flight, and the same commands flown by the simulator.
 * {@code mvn -Pfidelity -Dfidelity.log=FILE process-test-classes} prints them.
 */
public final class FidelityPage {

  /** Flights of the simulator. Decided: enough for the scatter of a noise that is normal. */
  private static final int FLIGHTS = 20;

  /** What a duration may differ by, of the real one. Source: issue 18. */
  private static final double TOLERANCE = 0.15;

  private static final String DURATIONS =
      """
      | command | real | simulated, median (least to most) | ratio | within 15 % |
      |---|---|---|---|---|
      """;

  private static final String MOTIONS =
      """
      | command | | forward cm | left cm | up cm | turn degrees |
      |---|---|---|---|---|---|
      """;

  private final List<List<CommandPair>> flights;

  private FidelityPage(List<List<CommandPair>> flights) {
    this.flights = flights;
  }

  /** Prints the tables for the log that the property {@code fidelity.log} names. */
  public static void main(String[] args) throws IOException {
    Path folder = Files.createTempDirectory("fidelity");
    System.out.println(
        of(FlightLog.read(Path.of(System.getProperty("fidelity.log"))), folder).text());
  }

  /**
   * Flies the commands of a log.
   *
   * @param folder for recordings
   */
  static FidelityPage of(FlightLog log, Path folder) throws IOException {
    Flight real = log.recorded(folder.resolve("real"));
    List<List<CommandPair>> flights = new ArrayList<>();
    for (FlightLog simulated : SimulatedFlights.of(log.commands(), FLIGHTS)) {
      Flight flown = simulated.recorded(folder.resolve("simulated-" + flights.size()));
      flights.add(FlightComparison.of(real, flown, Tolerance.DEFAULT).pairs());
    }
    return new FidelityPage(flights);
  }

  /** Both tables in Markdown. */
  String text() {
    StringBuilder durations = new StringBuilder(DURATIONS);
    StringBuilder motions = new StringBuilder(MOTIONS);
    for (int command = 0; command < flights.get(0).size(); command++) {
      durations.append(duration(command));
      motions.append(motion(command));
    }
    return durations + "\n" + motions;
  }

  private String duration(int command) {
    FlownCommand real = first(command);
    double[] times = simulated(command, flown -> flown.command().duration().orElse(Double.NaN));
    double expected = real.command().duration().orElse(Double.NaN);
    double ratio = times[1] / expected;
    return String.format(
        Locale.ROOT,
        "| `%s` | %.2f s | %.2f s (%.2f to %.2f) | %.2f | %s |%n",
        real.command().text(),
        expected,
        times[1],
        times[0],
        times[2],
        ratio,
        Math.abs(ratio - 1) <= TOLERANCE ? "yes" : "**no**");
  }

  private String motion(int command) {
    Optional<Motion> real = first(command).motion();
    if (real.isEmpty()) {
      return "";
    }
    Motion moved = real.get();
    return String.format(
        Locale.ROOT,
        "| `%s` | real | %.0f | %.0f | %.0f | %.0f |%n| | simulated | %s | %s | %s | %s |%n",
        first(command).command().text(),
        moved.forward(),
        moved.left(),
        moved.up(),
        moved.turn(),
        range(command, Motion::forward),
        range(command, Motion::left),
        range(command, Motion::up),
        range(command, Motion::turn));
  }

  private String range(int command, ToDoubleFunction<Motion> part) {
    double[] values =
        simulated(command, flown -> flown.motion().map(part::applyAsDouble).orElse(Double.NaN));
    return Math.round(values[1])
        + " ("
        + Math.round(values[0])
        + " to "
        + Math.round(values[2])
        + ")";
  }

  private FlownCommand first(int command) {
    return flights.get(0).get(command).first().orElseThrow();
  }

  /** Least, median and most of all flights. */
  private double[] simulated(int command, ToDoubleFunction<FlownCommand> value) {
    List<Double> values =
        flights.stream()
            .map(pairs -> value.applyAsDouble(pairs.get(command).second().orElseThrow()))
            .filter(Double::isFinite)
            .sorted()
            .toList();
    return values.isEmpty()
        ? new double[] {Double.NaN, Double.NaN, Double.NaN}
        : new double[] {
          values.get(0), new Statistics(values).median(), values.get(values.size() - 1)
        };
  }
}
