package tellosimulator.junit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import tellosimulator.command.WireText;
import tellosimulator.junit.JournalEntry.Outcome;

/**
 * All that came to a drone since the test began, and what it answered. A command is meant by its
 * first words: {@code "forward"} is each {@code forward}, {@code "forward 100"} only that one.
 */
public final class Journal {

  /** What becomes of texts that the drone does not take for commands. */
  private static final Set<Outcome> UNTAKEN =
      EnumSet.of(Outcome.LOST, Outcome.IGNORED, Outcome.TURNED_AWAY);

  /** From this many on, equal commands in a row are told in one line. */
  private static final int MANY = 4;

  private final TelloSimulator simulator;
  private final Supplier<List<JournalEntry>> entries;
  private final String who;

  /**
   * @param entries of the drone until now
   * @param who the drone, as a subject
   */
  Journal(TelloSimulator simulator, Supplier<List<JournalEntry>> entries, String who) {
    this.simulator = simulator;
    this.entries = entries;
    this.who = who;
  }

  /** All of it until now, in the order in which the drone took it. */
  public List<JournalEntry> entries() {
    simulator.settle();
    return entries.get();
  }

  /** The texts that the drone took for commands, in order. */
  public List<String> commands() {
    return entries().stream()
        .filter(entry -> !UNTAKEN.contains(entry.outcome()))
        .map(JournalEntry::text)
        .toList();
  }

  /** Commands that the drone refused, or could not bring to their end. */
  public List<JournalEntry> refused() {
    return entries().stream()
        .filter(entry -> entry.outcome() == Outcome.REFUSED || entry.outcome() == Outcome.FAILED)
        .toList();
  }

  /**
   * Waits until a command has come and, unless none is given, an answer to it.
   *
   * @param timeout how long at the most, by the wall clock
   * @return the first such command
   * @throws AssertionError if it does not come in time
   */
  public JournalEntry await(String command, Duration timeout) {
    Optional<JournalEntry> found = simulator.monitor().await(timeout, () -> settled(command));
    return found.orElseThrow(
        () ->
            new AssertionError(
                String.format(
                    Locale.ROOT,
                    "%s: `%s` %s within %.1f s%n%s",
                    who,
                    command,
                    all(command).isEmpty() ? "did not come" : "was not answered",
                    timeout.toMillis() / 1000.0,
                    this)));
  }

  private Optional<JournalEntry> settled(String command) {
    return entries.get().stream().filter(entry -> entry.is(command) && entry.settled()).findFirst();
  }

  /**
   * Checks how often a command came.
   *
   * @throws AssertionError if it came more or less often
   */
  public void verify(Times times, String command) {
    List<JournalEntry> found = all(command);
    if (!times.holds(found.size())) {
      throw new AssertionError(
          String.format(
              Locale.ROOT,
              "%s: expected `%s` %s, but it came %s%n%s",
              who,
              command,
              times,
              Times.times(found.size()),
              lines(found.isEmpty() ? entries() : found)));
    }
  }

  /**
   * Checks that a command never came.
   *
   * @throws AssertionError if it did
   */
  public void never(String command) {
    verify(Times.times(0), command);
  }

  private List<JournalEntry> all(String command) {
    return entries().stream().filter(entry -> entry.is(command)).toList();
  }

  /** All lines; many equal commands in a row are told in one. */
  @Override
  public String toString() {
    return lines(entries());
  }

  private String lines(List<JournalEntry> shown) {
    if (shown.isEmpty()) {
      return "  nothing came to " + who;
    }
    List<String> lines = new ArrayList<>();
    int next = 0;
    while (next < shown.size()) {
      int end = next + 1;
      while (end < shown.size() && alike(shown.get(next), shown.get(end))) {
        end++;
      }
      if (end - next >= MANY) {
        lines.add(shown.get(next).toString());
        lines.add(
            String.format(
                Locale.ROOT,
                "             … %d more `%s`",
                end - next - 1,
                firstWord(shown.get(next))));
      } else {
        shown.subList(next, end).forEach(entry -> lines.add(entry.toString()));
      }
      next = end;
    }
    return String.join(System.lineSeparator(), lines);
  }

  private static boolean alike(JournalEntry one, JournalEntry other) {
    return firstWord(one).equals(firstWord(other))
        && one.outcome() == other.outcome()
        && one.reply().equals(other.reply())
        && one.explanation().equals(other.explanation());
  }

  private static String firstWord(JournalEntry entry) {
    return WireText.printable(entry.text().split(" ", 2)[0]);
  }
}
