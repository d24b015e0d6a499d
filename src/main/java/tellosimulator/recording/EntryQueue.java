package tellosimulator.recording;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import tellosimulator.time.Ticker;

/**
 * What waits to be written. Nobody who adds something ever waits: when there is too much, the last
 * entry is an {@link Entry.Overrun}, and nothing is taken until a new flight begins. {@link #add}
 * and {@link #wake} are for any thread, all else for that of the writer.
 */
final class EntryQueue {

  /**
   * Weight of all that may wait. Decided: three seconds of a hundred drones at fifty times real
   * time, which are 100,000 samples and 50,000 state lines a second.
   */
  private static final long MOST = 450_000;

  /** Part of the heap that may wait, as long as that is less: an eighth. */
  private static final long SHARE_OF_HEAP = 8;

  /** Bytes of a unit of weight. Measured: 250 to 350. */
  private static final long UNIT_BYTES = 350;

  /** Weight at which the writer is woken before its time. */
  private static final long PRESSING = 5_000;

  private final Queue<Entry> waiting = new ConcurrentLinkedQueue<>();
  private final AtomicLong weight = new AtomicLong();
  private final AtomicBoolean closed = new AtomicBoolean();
  private final AtomicBoolean pressed = new AtomicBoolean();
  private final Ticker ticker = new Ticker();
  private final long most;

  /** Weight that was taken and still counts: who adds shall seldom meet who takes. */
  private long taken;

  EntryQueue() {
    this(Math.min(MOST, Runtime.getRuntime().maxMemory() / SHARE_OF_HEAP / UNIT_BYTES));
  }

  /**
   * @param most weight that may wait
   */
  EntryQueue(long most) {
    this.most = most;
  }

  /** Adds an entry, or drops it, if too much waits. */
  void add(Entry entry) {
    if (entry instanceof Entry.Begin || entry instanceof Entry.Anew) {
      closed.set(false);
    } else if (closed.get() && !always(entry)) {
      return;
    }
    long all = weight.addAndGet(entry.weight());
    if (all > most && !always(entry)) {
      weight.addAndGet(-entry.weight());
      if (closed.compareAndSet(false, true)) {
        waiting.add(new Entry.Overrun());
      }
      wake();
      return;
    }
    waiting.add(entry);
    if (entry instanceof Entry.Begin || (all > PRESSING && pressed.compareAndSet(false, true))) {
      wake();
    }
  }

  /** Whether an entry must come through: there are few of its kind. */
  private static boolean always(Entry entry) {
    return entry instanceof Entry.Begin
        || entry instanceof Entry.End
        || entry instanceof Entry.Anew
        || entry instanceof Entry.Asked
        || entry instanceof Entry.Missed;
  }

  /** Takes the oldest entry. */
  Optional<Entry> poll() {
    Entry next = waiting.poll();
    if (next != null && !(next instanceof Entry.Overrun)) {
      taken += next.weight();
    }
    if (next == null || taken >= PRESSING / 2) {
      weight.addAndGet(-taken);
      taken = 0;
    }
    return Optional.ofNullable(next);
  }

  /**
   * Takes out all that belongs to earlier simulations, or all if there are none.
   *
   * @param taken is handed each entry that is taken out
   */
  void takeEarlier(Consumer<Entry> taken) {
    long begins = waiting.stream().filter(Entry.Anew.class::isInstance).count();
    boolean more = true;
    for (long left = begins; more; ) {
      Optional<Entry> next = poll();
      next.ifPresent(taken);
      left -= next.filter(Entry.Anew.class::isInstance).isPresent() ? 1 : 0;
      more = next.isPresent() && (begins == 0 || left > 0);
    }
    closed.set(false);
  }

  /**
   * Waits for a while, but not while much is to be done.
   *
   * @param period from one end of waiting to the next [ns]
   */
  @SuppressWarnings("ReturnValueIgnored") // whichever comes first
  void awaitTick(long period) {
    pressed.set(false);
    if (weight.get() <= PRESSING) {
      ticker.awaitTick(period);
    }
  }

  /** Waits until a flight begins, or much is to be done. */
  void rest() {
    pressed.set(false);
    if (weight.get() <= PRESSING) {
      ticker.rest();
    }
  }

  /** Ends the waiting, now or the next time. */
  void wake() {
    ticker.wake();
  }
}
