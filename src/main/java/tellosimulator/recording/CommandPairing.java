package tellosimulator.recording;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.command.WireText;
import tellosimulator.recording.RecordedCommand.Outcome;

/**
 * Finds out which reply belongs to which command. Events say it; of the wire alone it follows by
 * {@link WirePairing}. For one thread; each recording needs its own.
 */
final class CommandPairing {

  /** A command's drone and text. */
  private record Sent(int drone, String text) {}

  private final List<RecordedCommand> commands = new ArrayList<>();

  /** Indexes of the commands that wait for what becomes of them, by events. */
  private final Map<Sent, Deque<Integer>> open = new HashMap<>();

  private final Map<Integer, WirePairing> wire = new HashMap<>();

  /** Takes the next event. */
  void take(RecordedEvent event) {
    if (event.drone().isEmpty() || event.about().command().isEmpty()) {
      return;
    }
    int drone = event.drone().getAsInt();
    RecordedEvent.About about = event.about();
    switch (event.kind()) {
      case "command" ->
          waiting(drone, about.command()).addLast(begin(drone, event.time(), about.command()));
      case "reply" -> end(drone, event, Outcome.ANSWERED);
      case "refused" -> end(drone, event, Outcome.REFUSED);
      case "failed" -> end(drone, event, Outcome.FAILED);
      case "ignored" -> end(drone, event, Outcome.IGNORED);
      case "lost" -> end(drone, event, Outcome.LOST);
      default -> {
        // it concerns a command, but does not end it
      }
    }
  }

  private Deque<Integer> waiting(int drone, String text) {
    return open.computeIfAbsent(new Sent(drone, text), sent -> new ArrayDeque<>());
  }

  /** Adds a command, and returns its index. */
  private int begin(int drone, double time, String text) {
    commands.add(
        new RecordedCommand(drone, time, text, Outcome.UNANSWERED, OptionalDouble.empty(), "", ""));
    return commands.size() - 1;
  }

  private void end(int drone, RecordedEvent event, Outcome outcome) {
    RecordedEvent.About about = event.about();
    Deque<Integer> waiting = waiting(drone, about.command());
    boolean atOnce = outcome == Outcome.REFUSED || WireText.isUnanswered(about.command());
    Integer index = atOnce ? waiting.pollLast() : waiting.pollFirst();
    if (index == null) { // such as one that never arrived
      index = begin(drone, event.time(), about.command());
    }
    RecordedCommand command = commands.get(index);
    boolean replied = outcome != Outcome.IGNORED && outcome != Outcome.LOST;
    commands.set(
        index,
        new RecordedCommand(
            drone,
            command.sent(),
            command.text(),
            outcome,
            replied ? OptionalDouble.of(event.time()) : OptionalDouble.empty(),
            about.reply(),
            about.reason()));
  }

  /** Takes the next line of {@code wire.jsonl}, where there are no events. */
  void take(Fields line) {
    int drone = line.whole("drone").orElse(1);
    double time = line.moment("t").orElse(0);
    String text = line.text("text");
    WirePairing pairing = wire.computeIfAbsent(drone, number -> new WirePairing());
    switch (line.text("kind")) {
      case "command" -> pairing.sent(begin(drone, time, text), time, text);
      case "reply" -> answer(pairing, time, text.stripTrailing());
      default -> {
        // state and video answer nothing
      }
    }
  }

  private void answer(WirePairing pairing, double time, String reply) {
    OptionalInt index = pairing.answered(time, reply);
    if (index.isPresent()) {
      RecordedCommand command = commands.get(index.getAsInt());
      commands.set(
          index.getAsInt(),
          new RecordedCommand(
              command.drone(),
              command.sent(),
              command.text(),
              outcome(reply),
              OptionalDouble.of(time),
              reply,
              ""));
    }
  }

  private static Outcome outcome(String reply) {
    boolean refused =
        reply.startsWith("error")
            || reply.startsWith("led error")
            || reply.startsWith("matrix error")
            || reply.startsWith("out of range")
            || reply.startsWith("unknown command");
    return refused ? Outcome.REFUSED : Outcome.ANSWERED;
  }

  /** All commands, in the order in which they came. */
  List<RecordedCommand> commands() {
    return List.copyOf(commands);
  }
}
