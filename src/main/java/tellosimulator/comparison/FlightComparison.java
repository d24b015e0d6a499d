package tellosimulator.comparison;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import tellosimulator.comparison.Tolerance.Aspect;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.ReportedState;
import tellosimulator.recording.UnreadableRecordingException;

/**
 * Two flights, command by command. Commands are paired drone by drone, in order; where one flight
 * has some that the other lacks, the longest common subsequence decides. {@code rc} has no reply
 * and is left out. Immutable; for any thread.
 *
 * @param pairs in the order of the first flight, drone by drone
 */
public record FlightComparison(List<CommandPair> pairs) {

  /** Pairs of commands that are looked at; longer flights are paired as far as they go alike. */
  private static final long MOST_PAIRS = 4_000_000;

  /** A drone's commands of one flight. */
  private record Sequence(List<FlownCommand> commands) {
    String text(int index) {
      return commands.get(index).command().text();
    }

    int size() {
      return commands.size();
    }
  }

  /** A flight and what its state lines said. */
  public record Flight(RecordedFlight recording, List<ReportedState> states) {

    public Flight {
      states = List.copyOf(states);
    }

    /**
     * Reads a recording.
     *
     * @throws UnreadableRecordingException with a sentence, if there is none
     * @throws IOException if a file of it cannot be read
     */
    public static Flight read(Path folder) throws UnreadableRecordingException, IOException {
      return new Flight(RecordedFlight.read(folder), ReportedState.readAll(folder));
    }

    private Sequence sequence(int drone) {
      List<ReportedState> own = states.stream().filter(state -> state.drone() == drone).toList();
      return new Sequence(
          recording.commands().stream()
              .filter(command -> command.drone() == drone && !command.text().startsWith("rc "))
              .map(command -> FlownCommand.of(command, own))
              .toList());
    }
  }

  public FlightComparison {
    pairs = List.copyOf(pairs);
  }

  /** Compares two flights. */
  public static FlightComparison of(Flight first, Flight second, Tolerance tolerance) {
    NavigableSet<Integer> drones = new TreeSet<>();
    Stream.of(first, second)
        .flatMap(flight -> flight.recording.commands().stream())
        .map(RecordedCommand::drone)
        .forEach(drones::add);
    List<CommandPair> pairs = new ArrayList<>();
    for (int drone : drones) {
      pairs.addAll(pairs(first.sequence(drone), second.sequence(drone), tolerance));
    }
    return new FlightComparison(pairs);
  }

  /** Whether nothing differs by more than is tolerated. */
  public boolean alike() {
    return differing() == 0;
  }

  /** How many commands differ by more than is tolerated. */
  public long differing() {
    return pairs.stream().filter(pair -> !pair.alike()).count();
  }

  private static List<CommandPair> pairs(Sequence first, Sequence second, Tolerance tolerance) {
    boolean huge = (long) first.size() * second.size() > MOST_PAIRS;
    int[][] common = huge ? new int[0][] : commonLengths(first, second);
    List<CommandPair> pairs = new ArrayList<>();
    int i = 0;
    int j = 0;
    while (i < first.size() || j < second.size()) {
      if (i < first.size() && j < second.size() && first.text(i).equals(second.text(j))) {
        FlownCommand one = first.commands.get(i++);
        FlownCommand two = second.commands.get(j++);
        pairs.add(
            new CommandPair(Optional.of(one), Optional.of(two), tolerance.differing(one, two)));
      } else if (j == second.size() || (i < first.size() && (huge || firstAlone(common, i, j)))) {
        pairs.add(alone(Optional.of(first.commands.get(i++)), Optional.empty()));
      } else {
        pairs.add(alone(Optional.empty(), Optional.of(second.commands.get(j++))));
      }
    }
    return pairs;
  }

  /** Whether nothing is lost if the next command of the first flight has no counterpart. */
  private static boolean firstAlone(int[][] common, int i, int j) {
    return common[i + 1][j] >= common[i][j + 1];
  }

  private static CommandPair alone(Optional<FlownCommand> first, Optional<FlownCommand> second) {
    return new CommandPair(first, second, Set.of(Aspect.MISSING));
  }

  /** Lengths of the longest common subsequences from each pair of commands on. */
  private static int[][] commonLengths(Sequence first, Sequence second) {
    int[][] common = new int[first.size() + 1][second.size() + 1];
    for (int i = first.size() - 1; i >= 0; i--) {
      for (int j = second.size() - 1; j >= 0; j--) {
        common[i][j] =
            first.text(i).equals(second.text(j))
                ? common[i + 1][j + 1] + 1
                : Math.max(common[i + 1][j], common[i][j + 1]);
      }
    }
    return common;
  }
}
