package tellosimulator.recording;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import tellosimulator.time.Ticker;

/**
 * The queue of entries to be written. Adding an entry never blocks: when the queue is full, an
 * {@link Entry.Overrun} is appended, and no more entries are accepted until a new flight begins.
 * {@link #add} and {@link #wake} are thread-safe; all other methods are confined to the writer's
 * thread.
 */
final class EntryQueue {

  /**
   * Maximum total weight of the waiting entries. Decided: enough for three seconds of a hundred
   * drones at fifty times real time, when they produce 100,000 samples and 50,000 state lines a
   * second.
   */
  private static final long MOST = 450_000;

  /** The queue takes at most one eighth of the heap. */
  private static final long SHARE_OF_HEAP = 8;

  /**
   * Memory for each unit of weight [bytes]. Measured: entries take 250 to 350 bytes for each unit.
   */
  private static final long UNIT_BYTES = 350;

  /** Weight of the waiting entries above which the writer is woken early. */
  private static final long PRESSING = 5_000;

  private final Queue<Entry> waiting = new ConcurrentLinkedQueue<>();
  private final AtomicLong weight = new AtomicLong();
  private final AtomicBoolean closed = new AtomicBoolean();
  private final Ticker ticker = new Ticker();
  private final long most;

  EntryQueue() {
    this(Math.min(MOST, Runtime.getRuntime().maxMemory() / SHARE_OF_HEAP / UNIT_BYTES));
  }

  /**
   * Creates an empty queue.
   *
   * @param most maximum total weight of the waiting entries
   */
  EntryQueue(long most) {
    this.most = most;
  }

  /** Adds an entry, or drops it if the queue is full. */
  void add(Entry entry) {
    boolean begins = entry instanceof Entry.Begin || entry instanceof Entry.NewRun;
    if (begins) {
      closed.set(false);
    } else if (closed.get() && !always(entry)) {
      return;
    }
    long all = weight.addAndGet(entry.weight());
    if (all <= most || always(entry)) {
      waiting.add(entry);
    } else {
      weight.addAndGet(-entry.weight());
      if (closed.compareAndSet(false, true)) {
        waiting.add(new Entry.Overrun());
      }
    }
    if (begins || all > PRESSING) {
      wake();
    }
  }

  /** Returns whether an entry is accepted even if the queue is full; such entries are rare. */
  private static boolean always(Entry entry) {
    return entry instanceof Entry.Begin
        || entry instanceof Entry.End
        || entry instanceof Entry.NewRun
        || entry instanceof Entry.Asked
        || entry instanceof Entry.Missed;
  }

  /** Removes the oldest entry. */
  Optional<Entry> poll() {
    Optional<Entry> next = Optional.ofNullable(waiting.poll());
    next.ifPresent(entry -> weight.addAndGet(-entry.weight()));
    return next;
  }

  /**
   * Removes all entries of earlier runs, or all entries if no new run is marked.
   *
   * @param taken receives each removed entry
   */
  void takeEarlier(Consumer<Entry> taken) {
    long begins = waiting.stream().filter(Entry.NewRun.class::isInstance).count();
    boolean more = true;
    for (long left = begins; more; ) {
      Optional<Entry> next = poll();
      next.ifPresent(taken);
      left -= next.filter(Entry.NewRun.class::isInstance).isPresent() ? 1 : 0;
      more = next.isPresent() && (begins == 0 || left > 0);
    }
    closed.set(false);
  }

  /**
   * Waits for the rest of the period; returns early if many entries are waiting.
   *
   * @param period the time between the ends of two waits [ns]
   */
  @SuppressWarnings("ReturnValueIgnored") // the reason for waking up does not matter
  void awaitTick(long period) {
    if (weight.get() <= PRESSING) {
      ticker.awaitTick(period);
    }
  }

  /** Waits until a flight begins or many entries are waiting. */
  void rest() {
    if (weight.get() <= PRESSING) {
      ticker.rest();
    }
  }

  /** Ends the current wait, or the next one. */
  void wake() {
    ticker.wake();
  }
}
