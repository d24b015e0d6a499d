package tellosimulator.view.video;

import java.util.Locale;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Where video threads order pictures of the window's scene, and the JavaFX thread takes them at its
 * next pulse. It measures what they cost, and takes orders only while they are cheap. A video
 * thread waits a limited time, the JavaFX thread never.
 */
public final class SnapshotDesk {

  private static final Logger LOG = LoggerFactory.getLogger(SnapshotDesk.class);

  /** How long a video thread waits for a picture [ns]. Decided: three pictures of a stream. */
  private static final long PATIENCE = 100_000_000;

  /**
   * After how long it is tried out for the first time again whether pictures are cheap [ns].
   * Decided: the window may have been hidden, or the graphics card busy; but a trial holds the
   * window up for a moment, so that each further one waits twice as long.
   */
  private static final long REST = 60_000_000_000L;

  /** After how long it is tried out at the latest [ns]. Decided: a stutter an hour is not seen. */
  private static final long LONGEST_REST = 64 * REST;

  /** Pictures of a trial have this size [pixels]. Measured: that of a drone's pictures. */
  private static final int WIDTH = 960;

  private static final int HEIGHT = 720;

  private final Queue<SnapshotOrder> orders = new ConcurrentLinkedQueue<>();
  private final SnapshotCosts costs = new SnapshotCosts();
  private final LongSupplier clock;
  private volatile Runnable ordered = () -> {};
  private volatile boolean open;
  private boolean cheap;
  private long rest = REST;
  private long trialNanos;

  SnapshotDesk() {
    this(System::nanoTime);
  }

  /**
   * @param clock by which it measures [ns]
   */
  SnapshotDesk(LongSupplier clock) {
    this.clock = clock;
  }

  /** Tells somebody of each order, on any thread. */
  void onOrder(Runnable listener) {
    ordered = listener;
  }

  /** Somebody takes pictures from now on; it is tried out what they cost. For any thread. */
  public void open() {
    open = true;
    tryOut();
  }

  /** Nobody takes pictures any more. For any thread. */
  public void close() {
    open = false;
    orders.clear();
  }

  /** Orders pictures that nobody gets, to know what they cost. */
  private synchronized void tryOut() {
    trialNanos = clock.getAsLong() + rest; // if nobody takes these
    costs.forget();
    orders.clear();
    int[] argb = new int[WIDTH * HEIGHT];
    for (int i = 0; i < SnapshotCosts.FEWEST; i++) {
      orders.add(new SnapshotOrder(1, WIDTH, HEIGHT, argb));
    }
  }

  /**
   * Has a picture taken, and waits for it.
   *
   * @return whether there is one; if not, its pixels may still come
   */
  boolean take(SnapshotOrder order) {
    orders.add(order);
    ordered.run();
    if (order.await(PATIENCE)) {
      return true;
    }
    orders.remove(order);
    disappointed();
    return false;
  }

  /** The streams of several drones may all wait in vain for the same window. */
  private synchronized void disappointed() {
    if (cheap) {
      giveUp("the window is busy");
    }
  }

  /** Whether pictures are cheap, as far as is known; sometimes that is tried out again. */
  synchronized boolean accepts() {
    if (open && !cheap && clock.getAsLong() > trialNanos) {
      tryOut();
    }
    return open && cheap;
  }

  /**
   * Takes the pictures that were ordered, but leaves some for the next pulse rather than hold up
   * this one. For the JavaFX thread.
   *
   * @param photographer fills an order
   */
  public void serve(Consumer<SnapshotOrder> photographer) {
    long spent = 0;
    while (spent < SnapshotCosts.LIMIT) {
      SnapshotOrder order = orders.poll();
      if (order == null) {
        return;
      }
      long begun = clock.getAsLong();
      photographer.accept(order);
      order.fill();
      long cost = clock.getAsLong() - begun;
      judge(cost);
      spent += cost;
    }
  }

  private synchronized void judge(long cost) {
    costs.add(cost);
    if (!costs.known()) {
      return;
    }
    if (!costs.cheap()) {
      giveUp(described(costs.median()));
    } else if (!cheap) {
      cheap = true;
      LOG.debug("Drones film the window's scene: {}", described(costs.median()));
    }
  }

  private static String described(long cost) {
    return String.format(Locale.ROOT, "a picture takes %.1f ms", cost * 1e-6);
  }

  /** Others film, for a while. */
  private synchronized void giveUp(String why) {
    LOG.debug("Drones do not film the window's scene: {}", why);
    cheap = false;
    costs.forget();
    trialNanos = clock.getAsLong() + rest;
    rest = Math.min(2 * rest, LONGEST_REST);
  }
}
