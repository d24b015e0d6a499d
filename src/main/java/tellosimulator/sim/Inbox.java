package tellosimulator.sim;

import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.Map;
import java.util.Queue;

/**
 * The queue of all that waits for the simulation: datagrams, and calls of the program itself, in
 * the order in which they came. Datagrams are bounded in all and for each sender, with a part that
 * only operators may fill, so that no flood keeps an operator out. For any thread.
 */
final class Inbox {

  /** Datagrams that may wait; what comes on top is lost, as in a full socket buffer. */
  private static final int CAPACITY = 4096;

  /** The part of it that is kept for operators. */
  private static final int RESERVED = 1024;

  /** Datagrams of one sender that may wait. Decided: some milliseconds of work. */
  private static final int MOST_OF_SENDER = 256;

  /** Something that waits. */
  sealed interface Item permits SimInput.Datagram, Call {}

  /**
   * Something that the program itself wants to be done.
   *
   * @param failure what is said if it fails: the beginning of a sentence
   * @param work what is done
   * @param shown run when the snapshot shows it, or when it never will be done; must not throw
   */
  record Call(String failure, Runnable work, Runnable shown) implements Item {}

  private final Queue<Item> waiting = new ArrayDeque<>();
  private final Map<InetSocketAddress, Integer> senders = new HashMap<>();
  private int datagrams;
  private volatile Runnable listener = () -> {};

  /** Sets what is told whenever something has come, on the thread that brought it. */
  void onCome(Runnable newListener) {
    listener = newListener;
  }

  /**
   * Lets a datagram wait.
   *
   * @param operator whether it comes from the host that operates the drone
   * @return false if there is no room for it
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

  /** Lets a call wait; there is always room for it. */
  void add(Call call) {
    synchronized (this) {
      waiting.add(call);
    }
    listener.run();
  }

  /** The next one, which goes on waiting; null if there is none. */
  synchronized Item peek() {
    return waiting.peek();
  }

  /** The next one, or null. */
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
