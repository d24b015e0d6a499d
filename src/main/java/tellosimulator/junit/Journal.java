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
 * The texts that have been sent to a drone since the test began, and the drone's replies. Methods
 * identify a command by its first words: {@code "forward"} matches every {@code forward}, {@code
 * "forward 100"} matches only {@code forward 100}.
 */
public final class Journal {

  /** The outcomes of texts that the drone did not accept as commands. */
  private static final Set<Outcome> UNTAKEN =
      EnumSet.of(Outcome.LOST, Outcome.IGNORED, Outcome.TURNED_AWAY);

  /** Minimum number of similar consecutive entries for which the printed journal is abbreviated. */
  private static final int MANY = 4;

  private final TelloSimulator simulator;
  private final Supplier<List<JournalEntry>> entries;
  private final String who;

  /**
   * Creates the journal of a drone.
   *
   * @param entries supplies the drone's entries so far
   * @param who the drone, as the subject of a sentence
   */
  Journal(TelloSimulator simulator, Supplier<List<JournalEntry>> entries, String who) {
    this.simulator = simulator;
    this.entries = entries;
    this.who = who;
  }

  /** Returns all entries so far, in the order in which the texts arrived. */
  public List<JournalEntry> entries() {
    simulator.settle();
    return entries.get();
  }

  /** Returns the texts that the drone accepted as commands, in order. */
  public List<String> commands() {
    return entries().stream()
        .filter(entry -> !UNTAKEN.contains(entry.outcome()))
        .map(JournalEntry::text)
        .toList();
  }

  /** Returns the commands that the drone refused or could not complete. */
  public List<JournalEntry> refused() {
    return entries().stream()
        .filter(entry -> entry.outcome() == Outcome.REFUSED || entry.outcome() == Outcome.FAILED)
        .toList();
  }

  /**
   * Waits until a command has arrived. If the command has a reply, also waits for the reply.
   *
   * @param timeout the maximum wait, in wall clock time
   * @return the entry of the first command that matches
   * @throws AssertionError on timeout
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
   * Verifies how often a command arrived.
   *
   * @throws AssertionError if it arrived more or less often
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
   * Verifies that a command never arrived.
   *
   * @throws AssertionError if it arrived
   */
  public void never(String command) {
    verify(Times.times(0), command);
  }

  private List<JournalEntry> all(String command) {
    return entries().stream().filter(entry -> entry.is(command)).toList();
  }

  /**
   * Returns all entries, one line each. Of many similar consecutive entries, only the first is
   * printed, followed by the number of the others.
   */
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
