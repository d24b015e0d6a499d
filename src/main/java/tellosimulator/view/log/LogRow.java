package tellosimulator.view.log;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.view.log.LogLine.Outcome;

/**
 * A row of the log: a command with all lines about it, or a line of its own. Immutable.
 *
 * @param number counts rows without gaps, in the order in which they began
 * @param arrivals its lines, oldest first; at least one
 */
record LogRow(long number, List<Arrival> arrivals) {

  /**
   * A line, and when it came.
   *
   * @param order counts the lines of all rows
   */
  record Arrival(long order, LogLine line) {}

  LogRow {
    arrivals = List.copyOf(arrivals);
  }

  /** The same row with a line more. */
  LogRow with(Arrival more) {
    List<Arrival> all = new ArrayList<>(arrivals);
    all.add(more);
    return new LogRow(number, all);
  }

  /** The lines of rows in the order in which they came. */
  static List<LogLine> lines(List<LogRow> rows) {
    return rows.stream()
        .flatMap(row -> row.arrivals.stream())
        .sorted(Comparator.comparingLong(Arrival::order))
        .map(Arrival::line)
        .toList();
  }

  List<LogLine> lines() {
    return arrivals.stream().map(Arrival::line).toList();
  }

  /** With which it began. */
  LogLine first() {
    return arrivals.get(0).line();
  }

  /** That of the line that matters most. */
  LogLevel level() {
    return arrivals.stream().map(arrival -> arrival.line().level()).min(LogLevel::compareTo).get();
  }

  /** The command that it is about, for people; empty if it is about none. */
  Optional<String> command() {
    return first().exchange().map(LogLine.Exchange::printable);
  }

  /** What became of the command; empty as long as nobody knows. */
  Optional<Outcome> outcome() {
    return answer().flatMap(LogLine::exchange).flatMap(LogLine.Exchange::outcome);
  }

  /** From the command to its answer [simulated s]; empty if one of them is not there. */
  OptionalDouble duration() {
    boolean both = first().exchange().flatMap(LogLine.Exchange::outcome).isEmpty();
    return answer()
        .filter(answer -> both)
        .map(answer -> OptionalDouble.of(answer.time().seconds() - first().time().seconds()))
        .orElse(OptionalDouble.empty());
  }

  private Optional<LogLine> answer() {
    return lines().stream()
        .filter(line -> line.exchange().flatMap(LogLine.Exchange::outcome).isPresent())
        .reduce((before, last) -> last);
  }
}
