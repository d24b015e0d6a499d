package tellosimulator.view.log;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.view.log.LogLine.Outcome;

/**
 * A row of the log: a command with all lines about it, or a single line. Immutable.
 *
 * @param number the sequence number of the row; rows are numbered consecutively in the order of
 *     creation
 * @param arrivals the lines, oldest first; at least one
 */
record LogRow(long number, List<Arrival> arrivals) {

  /**
   * A line with its position in the order of arrival.
   *
   * @param order the sequence number of the line; the lines of all rows are numbered consecutively
   */
  record Arrival(long order, LogLine line) {}

  LogRow {
    arrivals = List.copyOf(arrivals);
  }

  /** Returns a copy of this row with an additional line. */
  LogRow with(Arrival more) {
    List<Arrival> all = new ArrayList<>(arrivals);
    all.add(more);
    return new LogRow(number, all);
  }

  /** Returns the lines of all given rows in the order of their arrival. */
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

  /** Returns the line that arrived first. */
  LogLine first() {
    return arrivals.get(0).line();
  }

  /** Returns the level of the most important line. */
  LogLevel level() {
    return arrivals.stream().map(arrival -> arrival.line().level()).min(LogLevel::compareTo).get();
  }

  /** Returns the printable command; empty if the row is not about a command. */
  Optional<String> command() {
    return first().exchange().map(LogLine.Exchange::printable);
  }

  /** Returns the outcome of the command; empty until the outcome is known. */
  Optional<Outcome> outcome() {
    return answer().flatMap(LogLine::exchange).flatMap(LogLine.Exchange::outcome);
  }

  /** Returns the time from the command to its reply [simulated s]; empty if either is missing. */
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
