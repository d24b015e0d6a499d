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
import tellosimulator.command.WireText;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.RecordedCommand.Outcome;
import tellosimulator.recording.RecordedEvent;
import tellosimulator.recording.RecordedFlight;

/**
 * Makes the list of commands and events of a flight. Equal commands that follow each other, as when
 * a program steers or polls, become one entry. For one thread.
 */
public final class ReportEntries {

  /** Most entries that a page shows. Decided: more than anybody reads, and still quick. */
  static final int MOST = 3_000;

  /** Kinds of events that are told with their command. */
  private static final Set<String> OF_COMMANDS =
      Set.of("command", "reply", "refused", "failed", "ignored");

  /** Severities of what somebody should look at. */
  private static final Set<String> WRONG = Set.of("warning", "error");

  private final ReportTexts texts;
  private final CommandWords commandWords;
  private final List<ReportEntry> entries = new ArrayList<>();

  /** For each drone the index of its last entry. */
  private final Map<Integer, Integer> last = new HashMap<>();

  /** Entries in the words of a language. */
  public ReportEntries(ReportTexts texts) {
    this.texts = texts;
    commandWords = new CommandWords(texts);
  }

  /** All entries, in the order of time. */
  public List<ReportEntry> of(RecordedFlight flight) {
    List<ReportEntry> all = new ArrayList<>();
    flight.commands().forEach(command -> all.add(of(command)));
    flight.events().stream().filter(ReportEntries::isToldAlone).forEach(each -> all.add(of(each)));
    all.sort(Comparator.comparingDouble(ReportEntry::time));
    all.forEach(this::add);
    return List.copyOf(entries);
  }

  private static boolean isToldAlone(RecordedEvent event) {
    boolean ofCommand = OF_COMMANDS.contains(event.kind()) || !event.about().command().isEmpty();
    return !ofCommand && !event.severity().equals("detail");
  }

  private ReportEntry of(RecordedCommand command) {
    boolean wrong = command.outcome().wrong();
    String text = WireText.printable(command.text().stripTrailing());
    String why = wrong ? texts.translated(command.reason()) : "";
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
        new ReportEntry.Words(texts.translated(event.text()), "", "", OptionalDouble.empty(), 1);
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
    boolean steering = text.startsWith("rc ") && textBefore.startsWith("rc ");
    return steering || (text.endsWith("?") && textBefore.equals(text));
  }

  /** Whether a command is one that its author wanted to go otherwise. */
  static long count(RecordedFlight flight, Outcome outcome) {
    return flight.commands().stream().filter(each -> each.outcome() == outcome).count();
  }
}
