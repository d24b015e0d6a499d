package tellosimulator.headless;

import java.util.HashSet;
import java.util.Set;
import tellosimulator.command.WireText;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;

/**
 * Detects programs that do not wait for replies: they send {@code rc}, which has none, or a command
 * before the reply to the one before, or speak the app's protocol, which answers an order at its
 * beginning. What such a program does depends on how fast simulated time passes. Notified on the
 * simulation thread; all other methods are thread-safe.
 */
final class PaceWatch implements SimListener {

  private final Runnable notified;
  private final Set<Integer> unanswered = new HashSet<>();
  private volatile boolean active;
  private volatile boolean impatient;

  /**
   * Creates an inactive watch.
   *
   * @param notified called once, on the simulation thread
   */
  PaceWatch(Runnable notified) {
    this.notified = notified;
  }

  void activate() {
    active = true;
  }

  /** Whether the program did not wait, since the activation. */
  boolean impatient() {
    return impatient;
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.CommandReceived received) {
      boolean waited = unanswered.add(received.drone()) && !isNotWaitedFor(received.text());
      if (active && !impatient && !waited) {
        impatient = true;
        notified.run();
      }
    } else if (event instanceof SimEvent.ReplyLost lost) {
      unanswered.remove(lost.drone());
    } else if (event instanceof SimEvent.OfCommand command) {
      unanswered.remove(command.drone());
    }
  }

  private static boolean isNotWaitedFor(String command) {
    return WireText.isSteering(command) || command.endsWith(WireText.APP_SUFFIX);
  }
}
