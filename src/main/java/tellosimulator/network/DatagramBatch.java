package tellosimulator.network;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.sim.Simulation;

/**
 * Datagrams that were received together, in the order in which they are handed over. A socket
 * preserves only the order of its own datagrams. The order of datagrams to different drones is
 * inferred from how programs wait for replies. {@code rc} and {@code emergency} have no reply, so a
 * program may send another command right after them. After any other command, a program waits for
 * the reply. Therefore, an {@code rc} or {@code emergency} in the batch was sent before the other
 * commands to other drones. Not thread-safe.
 */
final class DatagramBatch {

  /** Maximum number of datagrams that are handed over together. Decided: enough for many drones. */
  private static final int MOST = 64;

  private final List<Entry> entries = new ArrayList<>();

  /**
   * A datagram waiting to be handed over.
   *
   * @param connection the connection that received the datagram
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  record Entry(CommandConnection connection, Peer peer, byte[] bytes) {

    private boolean unanswered() {
      return WireText.isUnanswered(WireText.decode(bytes));
    }
  }

  int size() {
    return entries.size();
  }

  boolean hasRoom() {
    return entries.size() < MOST;
  }

  void add(Entry entry) {
    int place = entries.size();
    if (entry.unanswered()) {
      while (place > 0 && overtakes(entry, entries.get(place - 1))) {
        place--;
      }
    }
    entries.add(place, entry);
  }

  private static boolean overtakes(Entry later, Entry earlier) {
    return !earlier.unanswered() && earlier.connection().drone() != later.connection().drone();
  }

  /**
   * Hands over all datagrams and empties the batch. If the handover of a datagram fails, only that
   * datagram is lost. The next call continues with the subsequent ones.
   */
  void handOver(Simulation simulation) {
    while (!entries.isEmpty()) {
      Entry entry = entries.remove(0);
      entry.connection().handOver(simulation, entry);
    }
  }
}
