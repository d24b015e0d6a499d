package tellosimulator.cli;

import java.util.Locale;
import picocli.CommandLine.Help.Ansi;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.GradingListener;
import tellosimulator.time.RealTimer;
import tellosimulator.words.Printable;

/**
 * Shows the progress of grading: on a terminal as a bar that is drawn again after each flight,
 * elsewhere as a line for each flight. Thread-safe.
 */
final class GradingBar implements GradingListener {

  /** Length of the bar [characters]. Decided: leaves room for a name on 80 columns. */
  private static final int LENGTH = 24;

  private final ProgramOutput to;
  private final boolean terminal = Ansi.AUTO.enabled();
  private int flights;
  private int done;
  private RealTimer watch = new RealTimer();

  GradingBar(ProgramOutput to) {
    this.to = to;
  }

  @Override
  public synchronized void begins(int newFlights) {
    flights = newFlights;
    watch = new RealTimer();
  }

  @Override
  public synchronized void graded(String handIn, GradedFlight flight, boolean kept) {
    done++;
    if (!terminal) {
      to.out()
          .println(
              String.format(
                  Locale.ROOT,
                  "%d of %d: %s, %s, seed %d: %s (%s)%s",
                  done,
                  flights,
                  handIn,
                  flight.course(),
                  flight.seed(),
                  flight.result().verdict(),
                  flight.program(),
                  kept ? " (kept)" : ""));
      return;
    }
    int full = LENGTH * done / flights;
    double left = watch.seconds() / done * (flights - done);
    String bar = "#".repeat(full) + "-".repeat(LENGTH - full);
    to.help()
        .print(
            String.format(
                Locale.ROOT,
                "\r[%s] %d of %d, %.0f s left: %-20.20s",
                bar,
                done,
                flights,
                left,
                Printable.of(handIn)));
    if (done == flights) {
      to.help().println();
    }
    to.help().flush();
  }
}
