package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;
import tellosimulator.benchmark.Tour;

/**
 * Eight senders of garbage, as fast as they can, while a client flies that sends a command again to
 * which no reply comes: a socket's buffer in the kernel that is full takes nobody's datagrams.
 */
final class GarbageTrial {

  private static final int SENDERS = 8;

  /** No sender reaches that [datagrams/s]. */
  private static final int AS_FAST_AS_POSSIBLE = 10_000_000;

  /** What client packages do: DJITelloPy waits 7 s for a reply, and sends three times. */
  private static final int RETRY_MS = 7000;

  private static final int TRIES = 3;

  private static final double SHORTEST_SECONDS = 10;
  private static final double SECONDS_A_MINUTE = 4;
  private static final double PATIENCE_SECONDS = 30;

  private GarbageTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    double seconds = Math.max(SHORTEST_SECONDS, minutes * SECONDS_A_MINUTE);
    String from =
        IntStream.range(0, SENDERS)
            .mapToObj(i -> "127.0.0." + (11 + i))
            .collect(Collectors.joining(","));
    try (SimulatorProcess simulator = SimulatorProcess.here("--command-port", "0");
        Operator operator = new Operator(simulator.drone(1).getPort(), RETRY_MS, TRIES)) {
      operator.expect("command", "ok");
      try (Program senders =
          Host.HERE.start(
              Stranger.class,
              Host.HERE.address(),
              simulator.drone(1).getPort(),
              AS_FAST_AS_POSSIBLE,
              seconds,
              from,
              "garbage")) {
        senders.await("sending", PATIENCE_SECONDS);
        OtherLoad others = new OtherLoad();
        CompletableFuture<String> sent =
            CompletableFuture.supplyAsync(() -> sent(senders, seconds + PATIENCE_SECONDS));
        List<Measurement> rows = new ArrayList<>();
        int tours = 0;
        String harm = "";
        while (harm.isEmpty() && !(sent.isDone() && tours > 0)) {
          harm = fly(operator);
          tours += harm.isEmpty() ? 1 : 0;
        }
        String count = sent.join().split(" ", -1)[1];
        rows.add(
            Measurement.beside(
                "Eight senders of garbage for " + Math.round(seconds) + " s",
                String.format(Locale.ROOT, "%.1f million", Double.parseDouble(count) / 1e6)));
        Measurement flight =
            new Measurement(
                "… a client that flies",
                "is not harmed",
                harm.isEmpty()
                    ? tours + " tours, " + operator.sentAgain() + " commands sent again"
                    : harm,
                harm.isEmpty());
        rows.add(OtherLoad.judged(flight, others.share()));
        rows.add(Insides.row("… log", simulator));
        rows.add(Health.row("… after that", simulator));
        return rows;
      }
    }
  }

  private static String sent(Program senders, double patience) {
    try {
      return senders.await("sent", patience);
    } catch (IOException e) {
      throw new CompletionException(e);
    }
  }

  /** What went wrong; empty if nothing did. */
  private static String fly(Operator operator) {
    try {
      Tour.fly(operator);
      return "";
    } catch (IOException e) {
      return String.valueOf(e.getMessage());
    }
  }
}
