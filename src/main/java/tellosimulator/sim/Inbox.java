package tellosimulator.sim;

import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.Map;
import java.util.Queue;
import tellosimulator.command.Peer;

/**
 * Datagrams that wait for the simulation, in the order in which they came. Bounded in all and for
 * each sender, and with a part that only operators may fill, so that no flood keeps an operator
 * out. For any thread.
 */
final class Inbox {

  /** Datagrams that may wait; what comes on top is lost, as in a full socket buffer. */
  private static final int CAPACITY = 4096;

  /** The part of it that is kept for operators. */
  private static final int RESERVED = 1024;

  /** Datagrams of one sender that may wait. Decided: some milliseconds of work. */
  private static final int MOST_OF_SENDER = 256;

  /**
   * A datagram.
   *
   * @param drone number of the drone that it came to
   * @param text one character a byte (ISO-8859-1)
   */
  record Datagram(int drone, Peer peer, String text) {}

  private final Queue<Datagram> waiting = new ArrayDeque<>();
  private final Map<InetSocketAddress, Integer> senders = new HashMap<>();

  /**
   * Lets a datagram wait.
   *
   * @param operator whether it comes from the host that operates the drone
   * @return false if there is no room for it
   */
  synchronized boolean offer(Datagram datagram, boolean operator) {
    int room = operator ? CAPACITY : CAPACITY - RESERVED;
    InetSocketAddress sender = datagram.peer().address();
    if (waiting.size() >= room || senders.getOrDefault(sender, 0) >= MOST_OF_SENDER) {
      return false;
    }
    senders.merge(sender, 1, Integer::sum);
    waiting.add(datagram);
    return true;
  }

  /** The next one, or null. */
  synchronized Datagram poll() {
    Datagram next = waiting.poll();
    if (next != null) {
      senders.computeIfPresent(
          next.peer().address(), (sender, count) -> count == 1 ? null : count - 1);
    }
    return next;
  }

  synchronized boolean isEmpty() {
    return waiting.isEmpty();
  }
}
