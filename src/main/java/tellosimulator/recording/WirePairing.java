package tellosimulator.recording;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.command.CommandSyntax;
import tellosimulator.command.Reply;
import tellosimulator.command.WireText;

/**
 * Matches the replies of one drone to its commands when only the datagrams are known. The matching
 * follows from how the drone works: it performs one maneuver at a time, refuses other maneuvers in
 * the meantime, and answers all other commands immediately. Replies may be lost; commands that a
 * later reply proves to be finished are dropped. Not thread-safe.
 */
final class WirePairing {

  /**
   * Maximum delay of a reply that counts as immediate [s]. Measured: a drone answers reads after 5
   * to 228 ms, and no maneuver within 0.5 s.
   */
  private static final double PROMPT = 0.5;

  /** The commands that make a drone take off. */
  static final Set<String> TAKEOFFS =
      Set.of(CommandSyntax.TAKEOFF.verb(), CommandSyntax.THROW_FLY.verb());

  /**
   * The commands that are answered on completion: all that begin a flight, end a flight or require
   * one.
   */
  private static final Set<String> MANEUVERS =
      Stream.concat(
              TAKEOFFS.stream(),
              Stream.of(CommandSyntax.values())
                  .filter(CommandSyntax::needsFlight)
                  .map(CommandSyntax::verb))
          .collect(Collectors.toUnmodifiableSet());

  /**
   * A command that has not been answered yet.
   *
   * @param index its index in the list of all commands
   * @param sent the time when it was sent [s]
   */
  private record Open(int index, double sent, String text) {}

  private final Deque<Open> maneuvers = new ArrayDeque<>();
  private final Deque<Open> prompt = new ArrayDeque<>();

  /** Processes the next command. */
  void sent(int index, double time, String text) {
    String command = text.strip();
    if (!WireText.isUnanswered(command)) {
      boolean maneuver = MANEUVERS.contains(command.split(" ", 2)[0]);
      (maneuver ? maneuvers : prompt).addLast(new Open(index, time, command));
    }
  }

  /**
   * Processes the next reply.
   *
   * @return the index of the command that it answers; empty if no command matches
   */
  OptionalInt answered(double time, String reply) {
    Open command = commandOf(time, reply);
    return command == null ? OptionalInt.empty() : OptionalInt.of(command.index);
  }

  private Open commandOf(double time, String reply) {
    if (reply.equals(Reply.FORCED_STOP.text())) {
      boolean waits = !prompt.isEmpty() && prompt.peekLast().text.equals(CommandSyntax.STOP.verb());
      return waits ? prompt.pollLast() : null;
    }
    if (reply.equals(Reply.AUTO_LAND.text())) {
      return maneuvers.pollFirst();
    }
    boolean promptIsNewest =
        !prompt.isEmpty()
            && (maneuvers.isEmpty() || prompt.peekLast().index > maneuvers.peekLast().index);
    if (refusesAtOnce(reply)) {
      return (promptIsNewest ? prompt : maneuvers).pollLast();
    }
    boolean waitsForPrompt = !prompt.isEmpty() && time - prompt.peekLast().sent < PROMPT;
    return promptIsNewest || waitsForPrompt ? promptCommand(time) : maneuver(time);
  }

  private static boolean refusesAtOnce(String reply) {
    return reply.equals(Reply.NOT_JOYSTICK.text())
        || reply.startsWith(Reply.OUT_OF_RANGE.text())
        || reply.startsWith("unknown command");
  }

  /**
   * Returns the oldest command that the reply may answer. Commands are answered in order, so the
   * commands before it will get no reply, and are dropped.
   */
  private Open promptCommand(double time) {
    while (prompt.size() > 1 && time - prompt.peekFirst().sent >= PROMPT) {
      prompt.removeFirst();
    }
    return prompt.pollFirst();
  }

  /**
   * Returns the command that a maneuver's reply answers. If the newest maneuver was not refused
   * within {@link #PROMPT}, the drone has accepted it, so the earlier maneuvers are finished.
   */
  private Open maneuver(double time) {
    if (!maneuvers.isEmpty() && time - maneuvers.peekLast().sent >= PROMPT) {
      Open newest = maneuvers.pollLast();
      maneuvers.clear();
      return newest;
    }
    return maneuvers.pollFirst();
  }
}
