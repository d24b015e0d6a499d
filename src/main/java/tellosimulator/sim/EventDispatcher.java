package tellosimulator.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Exceptions;
import tellosimulator.time.SimTime;

/**
 * Queues events until the snapshot includes their effects, then notifies the listeners of them. An
 * exception in one listener does not affect the others. Confined to the simulation thread except
 * for {@link #listen}.
 */
final class EventDispatcher {

  private static final Logger LOG = LoggerFactory.getLogger(Simulation.class);

  private static final String LISTENER_FAILED = "A listener failed";

  private final List<SimEvent> waiting = new ArrayList<>();
  private final List<SimListener> listeners;

  /**
   * Creates a dispatcher.
   *
   * @param listeners in order of notification
   */
  EventDispatcher(List<SimListener> listeners) {
    this.listeners = new CopyOnWriteArrayList<>(listeners);
  }

  /** Adds a listener after all others. Thread-safe. */
  void listen(SimListener listener) {
    listeners.add(listener);
  }

  /** Notifies the listeners that an input is about to be applied. */
  void onInput(SimTime now, SimInput input) {
    for (SimListener listener : listeners) {
      guarded(LISTENER_FAILED, () -> listener.onInput(now, input));
    }
  }

  void add(SimEvent event) {
    waiting.add(event);
  }

  /** Discards all queued events. */
  void clear() {
    waiting.clear();
  }

  /** Notifies the listeners of all queued events. */
  void dispatch() {
    if (waiting.isEmpty()) {
      return;
    }
    List<SimEvent> happened = List.copyOf(waiting);
    waiting.clear();
    for (SimEvent event : happened) {
      for (SimListener listener : listeners) {
        guarded(LISTENER_FAILED, () -> listener.event(event));
      }
    }
  }

  /** Notifies the listeners that a step is complete. */
  void stepped(SimSnapshot snapshot) {
    for (SimListener listener : listeners) {
      try { // not guarded(): a lambda here would take 1 % of a step's time
        listener.stepped(snapshot);
      } catch (Throwable e) {
        failed(LISTENER_FAILED, e);
      }
    }
  }

  /** Runs a task, and logs any exception except a fatal one, which is rethrown. */
  static void guarded(String failure, Runnable work) {
    try {
      work.run();
    } catch (Throwable e) {
      failed(failure, e);
    }
  }

  /**
   * Logs a failure, or rethrows it if it is fatal. A stack overflow is not fatal, because it ends
   * only one task.
   */
  private static void failed(String failure, Throwable e) {
    Exceptions.throwIfFatal(e);
    LOG.error("{}; please report this: {}", failure, e.toString(), e);
  }
}
