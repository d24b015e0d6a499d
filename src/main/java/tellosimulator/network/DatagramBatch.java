package tellosimulator.network;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.sim.Simulation;

/**
 * Datagrams that were received together, in the order in which they are handed over. Each socket
 * tells its own order alone. Between drones the order follows from what programs wait for: {@code
 * rc} and {@code emergency} have no reply, so a program may send more after them, but after
 * anything else it waits; therefore those two were sent before what others than their own drone
 * got. For one thread.
 */
final class DatagramBatch {

  /** Datagrams that are handed over together. Decided: many drones' worth. */
  private static final int MOST = 64;

  private final List<Entry> entries = new ArrayList<>();

  /**
   * A datagram that may be handed over.
   *
   * @param connection that it came through
   * @param text one character a byte (ISO-8859-1)
   */
  record Entry(CommandConnection connection, Peer peer, String text) {

    private boolean unanswered() {
      return WireText.isUnanswered(text);
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
   * Hands everything over; empty afterwards. If one cannot be taken, it is lost alone: the next
   * call hands over those after it.
   */
  void handOver(Simulation simulation) {
    while (!entries.isEmpty()) {
      Entry entry = entries.remove(0);
      entry.connection().handOver(simulation, entry);
    }
  }
}
