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
 * Finds the command that a reply of one drone belongs to, where only the wire is known. It follows
 * from how the drone works: it carries out one maneuver at a time, refuses another one meanwhile,
 * and answers everything else at once. Replies may be lost, so the commands that a reply proves to
 * be over are forgotten. For one thread.
 */
final class WirePairing {

  /**
   * What comes within this time was answered at once [s]. Measured: a drone answers reads after 5
   * to 228 ms, and no maneuver within 0.5 s.
   */
  private static final double PROMPT = 0.5;

  /** What lets a drone take off. */
  static final Set<String> TAKEOFFS =
      Set.of(CommandSyntax.TAKEOFF.verb(), CommandSyntax.THROW_FLY.verb());

  /** Commands that are answered on arrival: all that begin, need or end flight. */
  private static final Set<String> MANEUVERS =
      Stream.concat(
              TAKEOFFS.stream(),
              Stream.of(CommandSyntax.values())
                  .filter(CommandSyntax::needsFlight)
                  .map(CommandSyntax::verb))
          .collect(Collectors.toUnmodifiableSet());

  /**
   * A command that waits for its reply.
   *
   * @param index in the list of all commands
   * @param sent [s]
   */
  private record Open(int index, double sent, String text) {}

  private final Deque<Open> maneuvers = new ArrayDeque<>();
  private final Deque<Open> prompt = new ArrayDeque<>();

  /** Takes the next command. */
  void sent(int index, double time, String text) {
    String command = text.strip();
    if (!WireText.isUnanswered(command)) {
      boolean maneuver = MANEUVERS.contains(command.split(" ", 2)[0]);
      (maneuver ? maneuvers : prompt).addLast(new Open(index, time, command));
    }
  }

  /**
   * Takes the next reply.
   *
   * @return the index of its command; empty if it belongs to none
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

  /** They are answered in their order, so that older ones than the one found get no reply. */
  private Open promptCommand(double time) {
    while (prompt.size() > 1 && time - prompt.peekFirst().sent >= PROMPT) {
      prompt.removeFirst();
    }
    return prompt.pollFirst();
  }

  /** The newest one was not refused, so that the others are over, unless it has just been sent. */
  private Open maneuver(double time) {
    if (!maneuvers.isEmpty() && time - maneuvers.peekLast().sent >= PROMPT) {
      Open newest = maneuvers.pollLast();
      maneuvers.clear();
      return newest;
    }
    return maneuvers.pollFirst();
  }
}
