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
import tellosimulator.command.WireText;
import tellosimulator.comparison.Tolerance.Aspect;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.ReportedState;
import tellosimulator.recording.UnreadableRecordingException;

/**
 * A comparison of two flights, command by command. The commands of each drone are paired in order.
 * If one flight has commands that the other lacks, the longest common subsequence determines the
 * pairs. {@code rc} has no reply and is left out. Immutable.
 *
 * @param pairs the pairs in the order of the first flight, drone by drone
 */
public record FlightComparison(List<CommandPair> pairs) {

  /**
   * Maximum size of the table of common subsequences [entries]. If a table would be larger,
   * commands of the first flight stay unpaired until one equals the next command of the second
   * flight.
   */
  private static final long MOST_PAIRS = 4_000_000;

  /** The commands of one drone in one flight. */
  private record Sequence(List<FlownCommand> commands) {
    String text(int index) {
      return commands.get(index).command().words();
    }

    int size() {
      return commands.size();
    }
  }

  /** A flight and its state lines. */
  public record Flight(RecordedFlight recording, List<ReportedState> states) {

    public Flight {
      states = List.copyOf(states);
    }

    /**
     * Reads a recording.
     *
     * @throws UnreadableRecordingException if the folder contains no readable recording; the
     *     message is one sentence
     * @throws IOException if a file of the recording cannot be read
     */
    public static Flight read(Path folder) throws UnreadableRecordingException, IOException {
      return new Flight(RecordedFlight.readCommands(folder), ReportedState.readAll(folder));
    }

    private Sequence sequence(int drone) {
      List<ReportedState> own = states.stream().filter(state -> state.drone() == drone).toList();
      return new Sequence(
          recording.commands().stream()
              .filter(command -> command.drone() == drone && !WireText.isSteering(command.words()))
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

  /** Whether all commands are alike within the tolerance. */
  public boolean alike() {
    return differing() == 0;
  }

  /** The number of commands that differ by more than the tolerance. */
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

  /**
   * Returns whether the next command of the first flight can stay unpaired without shortening the
   * common subsequence.
   */
  private static boolean firstAlone(int[][] common, int i, int j) {
    return common[i + 1][j] >= common[i][j + 1];
  }

  private static CommandPair alone(Optional<FlownCommand> first, Optional<FlownCommand> second) {
    return new CommandPair(first, second, Set.of(Aspect.MISSING));
  }

  /**
   * For each pair of positions, computes the length of the longest common subsequence of the
   * commands from there to the end.
   */
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
