package tellosimulator.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Stream;
import tellosimulator.command.WireText;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.RecordedCommand.Outcome;
import tellosimulator.recording.RecordedEvent;
import tellosimulator.recording.RecordedFlight;

/**
 * Builds the list of commands and events of a flight. Consecutive {@code rc} commands are merged
 * into one entry, and so are consecutive equal read commands. Not thread-safe.
 */
public final class ReportEntries {

  /**
   * Maximum number of entries on a page. Decided: more than a reader needs, and still fast to show.
   */
  static final int MOST = 3_000;

  /** The severities of entries that need attention. */
  private static final Set<String> WRONG = Set.of("warning", "error");

  private final ReportTexts texts;
  private final CommandWords commandWords;
  private final List<ReportEntry> entries = new ArrayList<>();

  /** Index of the last entry for each drone. */
  private final Map<Integer, Integer> last = new HashMap<>();

  /** Creates a builder for entries in the language of the texts. */
  public ReportEntries(ReportTexts texts) {
    this.texts = texts;
    commandWords = new CommandWords(texts);
  }

  /** Returns all entries in order of time; a command precedes the events at the same time. */
  public List<ReportEntry> of(RecordedFlight flight) {
    Stream<ReportEntry> commands = flight.commands().stream().map(this::of);
    Stream<ReportEntry> events =
        flight.events().stream().filter(event -> !event.severity().equals("detail")).map(this::of);
    Stream.concat(commands, events)
        .sorted(Comparator.comparingDouble(ReportEntry::time))
        .forEach(this::add);
    return List.copyOf(entries);
  }

  private ReportEntry of(RecordedCommand command) {
    boolean wrong = command.outcome().wrong();
    String text = WireText.printable(command.words().stripTrailing());
    String why = wrong ? texts.say(command.reason()) : "";
    ReportEntry.Words words =
        new ReportEntry.Words(
            text,
            WireText.printable(command.reply().stripTrailing()),
            why.isEmpty() ? commandWords.of(text) : why,
            command.duration(),
            1);
    String kind = command.outcome().name().toLowerCase(Locale.ROOT);
    return new ReportEntry(
        command.sent(), OptionalInt.of(command.drone()), kind, false, wrong, words);
  }

  private ReportEntry of(RecordedEvent event) {
    ReportEntry.Words words =
        new ReportEntry.Words(texts.say(event.phrase()), "", "", OptionalDouble.empty(), 1);
    boolean wrong = WRONG.contains(event.severity()) || event.kind().equals("touched");
    return new ReportEntry(event.time(), event.drone(), event.kind(), true, wrong, words);
  }

  private void add(ReportEntry entry) {
    int drone = entry.drone().orElse(0);
    Integer before = last.get(drone);
    if (before != null && continues(entries.get(before), entry)) {
      entries.set(before, entries.get(before).andOneMore(entry.words().reply()));
      return;
    }
    last.put(drone, entries.size());
    entries.add(entry);
  }

  private static boolean continues(ReportEntry before, ReportEntry entry) {
    if (before.event() || entry.event() || before.wrong() || entry.wrong()) {
      return false;
    }
    String text = entry.words().text();
    String textBefore = before.words().text();
    boolean steering = WireText.isSteering(text) && WireText.isSteering(textBefore);
    return steering || (WireText.isRead(text) && textBefore.equals(text));
  }

  /** Returns the number of commands with a given outcome. */
  static long count(RecordedFlight flight, Outcome outcome) {
    return flight.commands().stream().filter(each -> each.outcome() == outcome).count();
  }
}
