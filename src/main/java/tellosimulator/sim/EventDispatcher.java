package tellosimulator.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Exceptions;
import tellosimulator.time.SimTime;

/**
 * Keeps what happens until the snapshot shows it, and tells the listeners then. What one of them
 * throws concerns nobody else. For the simulation thread but for {@link #listen}.
 */
final class EventDispatcher {

  private static final Logger LOG = LoggerFactory.getLogger(Simulation.class);

  private static final String LISTENER_FAILED = "A listener failed";

  private final List<SimEvent> waiting = new ArrayList<>();
  private final List<SimListener> listeners;

  /**
   * @param listeners in the order in which they are told
   */
  EventDispatcher(List<SimListener> listeners) {
    this.listeners = new CopyOnWriteArrayList<>(listeners);
  }

  /** Tells one more listener, after all others. For any thread. */
  void listen(SimListener listener) {
    listeners.add(listener);
  }

  /** Tells that an input is taken next. */
  void taken(SimTime now, SimInput input) {
    for (SimListener listener : listeners) {
      guarded(LISTENER_FAILED, () -> listener.taken(now, input));
    }
  }

  void add(SimEvent event) {
    waiting.add(event);
  }

  /** Forgets what nobody was told yet. */
  void clear() {
    waiting.clear();
  }

  /** Tells what has happened since the last time. */
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

  /** Tells that a step was completed. */
  void stepped(SimSnapshot snapshot) {
    for (SimListener listener : listeners) {
      try { // written out: this is done in each step, and costs a hundredth of it as a lambda
        listener.stepped(snapshot);
      } catch (Throwable e) {
        failed(LISTENER_FAILED, e);
      }
    }
  }

  /** Carries something out; what it throws is logged, unless nothing can go on after it. */
  static void guarded(String failure, Runnable work) {
    try {
      work.run();
    } catch (Throwable e) {
      failed(failure, e);
    }
  }

  /** A stack that overflowed, too, concerns one piece of work alone. */
  private static void failed(String failure, Throwable e) {
    Exceptions.throwIfFatal(e);
    LOG.error("{}; please report this: {}", failure, e.toString(), e);
  }
}
