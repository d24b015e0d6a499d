package tellosimulator.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import tellosimulator.recording.RecordedCommand.Outcome;

/**
 * Finds out which reply belongs to which command. Events say it. Of the wire alone it follows from
 * how the drone works: it carries out one command at a time, and answers reads and refusals at
 * once. For one thread; each recording needs its own.
 */
final class CommandPairing {

  /** The reply to a command that comes while another one runs. Measured: FHNW report 2020. */
  static final String BUSY = "error Not joystick";

  private final List<RecordedCommand> commands = new ArrayList<>();

  /** Takes the next event. */
  void take(RecordedEvent event) {
    if (event.drone().isEmpty() || event.about().command().isEmpty()) {
      return;
    }
    int drone = event.drone().getAsInt();
    RecordedEvent.About about = event.about();
    switch (event.kind()) {
      case "command" -> begin(drone, event.time(), about.command());
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

  private void begin(int drone, double time, String text) {
    commands.add(
        new RecordedCommand(drone, time, text, Outcome.UNANSWERED, OptionalDouble.empty(), "", ""));
  }

  private void end(int drone, RecordedEvent event, Outcome outcome) {
    RecordedEvent.About about = event.about();
    int index = oldestOpen(drone, about.command());
    if (index < 0) { // such as one that never arrived
      begin(drone, event.time(), about.command());
      index = commands.size() - 1;
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

  private int oldestOpen(int drone, String text) {
    for (int i = 0; i < commands.size(); i++) {
      if (isOpen(i, drone) && commands.get(i).text().equals(text)) {
        return i;
      }
    }
    return -1;
  }

  private boolean isOpen(int index, int drone) {
    RecordedCommand command = commands.get(index);
    return command.drone() == drone && command.outcome() == Outcome.UNANSWERED;
  }

  /** Takes the next line of {@code wire.jsonl}, where there are no events. */
  void take(Fields line) {
    int drone = line.whole("drone").orElse(1);
    double time = line.numberOr("t", 0);
    String text = line.text("text");
    switch (line.text("kind")) {
      case "command" -> begin(drone, time, text);
      case "reply" -> answer(drone, time, text.stripTrailing());
      default -> {
        // state and video answer nothing
      }
    }
  }

  private void answer(int drone, double time, String reply) {
    int index = answeredBy(drone, reply);
    if (index < 0) {
      return;
    }
    RecordedCommand command = commands.get(index);
    Outcome outcome = isRefusal(reply) ? Outcome.REFUSED : Outcome.ANSWERED;
    commands.set(
        index,
        new RecordedCommand(
            drone, command.sent(), command.text(), outcome, OptionalDouble.of(time), reply, ""));
  }

  /** The newest one if it is answered at once, or else the oldest one that waits for a reply. */
  private int answeredBy(int drone, String reply) {
    int oldest = -1;
    int newest = -1;
    for (int i = 0; i < commands.size(); i++) {
      if (isOpen(i, drone) && !commands.get(i).text().startsWith("rc ")) {
        oldest = oldest < 0 ? i : oldest;
        newest = i;
      }
    }
    boolean atOnce =
        newest >= 0 && (commands.get(newest).text().endsWith("?") || reply.equals(BUSY));
    return atOnce ? newest : oldest;
  }

  private static boolean isRefusal(String reply) {
    return reply.startsWith("error")
        || reply.startsWith("out of range")
        || reply.startsWith("unknown command");
  }

  /** All commands, in the order in which they came. */
  List<RecordedCommand> commands() {
    return List.copyOf(commands);
  }
}
