package tellosimulator.sim;

import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.Map;
import java.util.Queue;

/**
 * The queue of inputs to the simulation, in order of arrival. It contains datagrams, and calls by
 * the program itself. The number of datagrams is limited, both in total and per sender. Part of the
 * capacity is reserved for operators, so that a flood cannot lock them out. Thread-safe.
 */
final class Inbox {

  /** Maximum number of waiting datagrams; further ones are lost, as with a full socket buffer. */
  private static final int CAPACITY = 4096;

  /** Part of the capacity that is reserved for operators [datagrams]. */
  private static final int RESERVED = 1024;

  /**
   * Maximum number of waiting datagrams per sender. Decided: handling this many takes a few
   * milliseconds.
   */
  private static final int MOST_OF_SENDER = 256;

  /** A queued item. */
  sealed interface Item permits SimInput.Datagram, Call {}

  /**
   * A task submitted by the program itself.
   *
   * @param failure the beginning of the log message on failure
   * @param work the task
   * @param shown a callback to run once the snapshot includes the effect, or once it is certain
   *     that the task will never be run; must not throw
   */
  record Call(String failure, Runnable work, Runnable shown) implements Item {}

  private final Queue<Item> waiting = new ArrayDeque<>();
  private final Map<InetSocketAddress, Integer> senders = new HashMap<>();
  private int datagrams;
  private volatile Runnable listener = () -> {};

  /** Sets the callback to run after each arrival, on the thread that added the item. */
  void onCome(Runnable newListener) {
    listener = newListener;
  }

  /**
   * Adds a datagram.
   *
   * @param operator whether the datagram comes from the host that operates the drone
   * @return false if there is no capacity for the datagram
   */
  boolean offer(SimInput.Datagram datagram, boolean operator) {
    boolean admitted = admit(datagram, operator);
    listener.run();
    return admitted;
  }

  private synchronized boolean admit(SimInput.Datagram datagram, boolean operator) {
    int room = operator ? CAPACITY : CAPACITY - RESERVED;
    InetSocketAddress sender = datagram.peer().address();
    if (datagrams >= room || senders.getOrDefault(sender, 0) >= MOST_OF_SENDER) {
      return false;
    }
    senders.merge(sender, 1, Integer::sum);
    datagrams++;
    waiting.add(datagram);
    return true;
  }

  /** Adds a call. There is always capacity for calls. */
  void add(Call call) {
    synchronized (this) {
      waiting.add(call);
    }
    listener.run();
  }

  /** Returns the next item without removing it; null if there is none. */
  synchronized Item peek() {
    return waiting.peek();
  }

  /** Removes and returns the next item, or null. */
  synchronized Item poll() {
    Item next = waiting.poll();
    if (next instanceof SimInput.Datagram datagram) {
      datagrams--;
      senders.computeIfPresent(
          datagram.peer().address(), (sender, count) -> count == 1 ? null : count - 1);
    }
    return next;
  }

  synchronized boolean isEmpty() {
    return waiting.isEmpty();
  }
}
