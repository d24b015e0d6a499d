package tellosimulator.endurance;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** When datagrams came to a socket, on the clock of {@link System#nanoTime}. For any thread. */
final class Arrivals {

  private final List<Long> times = new ArrayList<>();

  /**
   * What came within a window of time.
   *
   * @param count how many
   * @param firstMs from the window's beginning to the first one [ms]; not a number without one
   * @param periodMs from one to the next, on average [ms]; not a number with less than two
   * @param gapMs from one to the next, at the most [ms]
   */
  record Figures(int count, double firstMs, double periodMs, double gapMs) {

    /** What {@link #toWords} wrote. */
    static Figures of(String words) {
      List<String> all = List.of(words.split(" ", -1));
      return new Figures(
          Integer.parseInt(all.get(0)),
          Double.parseDouble(all.get(1)),
          Double.parseDouble(all.get(2)),
          Double.parseDouble(all.get(3)));
    }

    /** Four numbers with blanks between them. */
    String toWords() {
      return String.format(Locale.ROOT, "%d %.3f %.3f %.3f", count, firstMs, periodMs, gapMs);
    }
  }

  /** Receives until the socket is closed; from then on nobody else may. */
  static Arrivals at(DatagramSocket socket) {
    Arrivals arrivals = new Arrivals();
    Daemon.start("arrivals", () -> arrivals.receive(socket));
    return arrivals;
  }

  private void receive(DatagramSocket socket) {
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    try {
      while (true) {
        socket.receive(packet);
        add(System.nanoTime());
      }
    } catch (IOException e) {
      return; // closed
    }
  }

  private synchronized void add(long nanos) {
    times.add(nanos);
  }

  /** Those from one moment to another one. */
  synchronized Figures between(long from, long to) {
    List<Long> within = times.stream().filter(time -> time >= from && time < to).toList();
    if (within.isEmpty()) {
      return new Figures(0, Double.NaN, Double.NaN, 0);
    }
    long longest = 0;
    for (int i = 1; i < within.size(); i++) {
      longest = Math.max(longest, within.get(i) - within.get(i - 1));
    }
    long first = within.get(0);
    long last = within.get(within.size() - 1);
    double period = within.size() < 2 ? Double.NaN : (last - first) * 1e-6 / (within.size() - 1);
    return new Figures(within.size(), (first - from) * 1e-6, period, longest * 1e-6);
  }
}
