package tellosimulator.recording;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.command.WireText;
import tellosimulator.protocol.app.NamedPacket;
import tellosimulator.recording.RecordedCommand.Outcome;
import tellosimulator.words.Phrase;

/**
 * Matches replies to commands. An event names the command that it concerns. In recordings that
 * contain only datagrams, {@link WirePairing} infers the command of each reply. Not thread-safe;
 * each recording needs its own instance.
 */
final class CommandPairing {

  /** Identifies a command by the drone's number and the command's number. */
  private record Key(int drone, int number) {}

  /**
   * Maximum number of distinct texts in the cache. Decided: more than a program uses, unless its
   * commands contain counters.
   */
  private static final int MOST_TEXTS = 10_000;

  /** The prefixes of replies with which a drone refuses a command. */
  private static final List<String> REFUSALS =
      List.of("error", "led error", "matrix error", "out of range", "unknown command");

  private static final Phrase NO_REASON = Phrase.name("");

  private final List<RecordedCommand> commands = new ArrayList<>();

  /** Indexes of the commands that were found in events. */
  private final Map<Key, Integer> indexes = new HashMap<>();

  /** Indexes of the unanswered packets of the app's protocol, by the numbers of their exchanges. */
  private final Map<Key, Integer> packets = new HashMap<>();

  private final Map<Integer, WirePairing> wire = new HashMap<>();

  /** Cache of command texts, because programs send the same texts repeatedly. */
  private final Map<String, String> texts = new HashMap<>();

  /** Processes the next event. */
  void take(RecordedEvent event) {
    if (event.drone().isEmpty() || event.about().command().isEmpty()) {
      return;
    }
    int drone = event.drone().getAsInt();
    switch (event.kind()) {
      case "command" -> begin(drone, event);
      case "reply" -> end(drone, event, Outcome.ANSWERED);
      case "refused" -> end(drone, event, Outcome.REFUSED);
      case "failed" -> end(drone, event, Outcome.FAILED);
      case "ignored" -> end(drone, event, Outcome.IGNORED);
      case "lost" -> end(drone, event, Outcome.LOST);
      default -> {
        // the event concerns a command but does not end it
      }
    }
  }

  private int begin(int drone, RecordedEvent event) {
    int index = begin(drone, event.time(), event.about().command());
    event.about().number().ifPresent(number -> indexes.put(new Key(drone, number), index));
    return index;
  }

  /** Adds a command and returns its index. */
  private int begin(int drone, double time, String text) {
    commands.add(
        new RecordedCommand(
            drone, time, once(text), Outcome.UNANSWERED, OptionalDouble.empty(), "", NO_REASON));
    return commands.size() - 1;
  }

  private String once(String text) {
    return texts.size() < MOST_TEXTS
        ? texts.computeIfAbsent(text, each -> each)
        : texts.getOrDefault(text, text);
  }

  private void end(int drone, RecordedEvent event, Outcome outcome) {
    RecordedEvent.About about = event.about();
    Key key = new Key(drone, about.number().orElse(0));
    int index =
        indexes.containsKey(key) ? indexes.get(key) : begin(drone, event); // e.g. if it was lost
    RecordedCommand command = commands.get(index);
    if (command.outcome() == Outcome.ANSWERED && outcome == Outcome.ANSWERED) {
      return; // the second reply to a stop
    }
    boolean replied = outcome != Outcome.IGNORED && outcome != Outcome.LOST;
    OptionalDouble answered = replied ? OptionalDouble.of(event.time()) : OptionalDouble.empty();
    commands.set(index, command.ended(outcome, answered, once(about.reply()), about.reason()));
  }

  /** Processes the next line of {@code wire.jsonl}, for recordings without events. */
  void take(Fields line) {
    int drone = line.whole("drone").orElse(1);
    double time = line.moment("t").orElse(0);
    String text = line.text("text");
    WirePairing pairing = wire.computeIfAbsent(drone, number -> new WirePairing());
    Optional<NamedPacket> packet = NamedPacket.of(WireText.encode(text));
    switch (line.text("kind")) {
      case "command" -> {
        if (packet.isEmpty()) {
          pairing.sent(begin(drone, time, text), time, text);
        } else if (packet.get().command()) {
          packets.put(new Key(drone, packet.get().exchange()), begin(drone, time, text));
        }
      }
      case "reply" ->
          packet.ifPresentOrElse(
              named -> answer(drone, time, named),
              () -> answer(pairing, time, text.stripTrailing()));
      default -> {
        // state and video are not replies
      }
    }
  }

  /** Ends the packet that a packet of the drone answers, if it answers one. */
  private void answer(int drone, double time, NamedPacket packet) {
    Integer index = packets.remove(new Key(drone, packet.exchange()));
    if (index != null && packet.reply().isPresent()) {
      end(index, time, packet.reply().get().stripTrailing());
    }
  }

  private void answer(WirePairing pairing, double time, String reply) {
    OptionalInt found = pairing.answered(time, reply);
    if (found.isPresent()) {
      end(found.getAsInt(), time, reply);
    }
  }

  private void end(int index, double time, String reply) {
    OptionalDouble answered = OptionalDouble.of(time);
    commands.set(index, commands.get(index).ended(outcome(reply), answered, reply, NO_REASON));
  }

  private static Outcome outcome(String reply) {
    return REFUSALS.stream().anyMatch(reply::startsWith) ? Outcome.REFUSED : Outcome.ANSWERED;
  }

  /** All commands, in order of arrival. */
  List<RecordedCommand> commands() {
    return List.copyOf(commands);
  }
}
