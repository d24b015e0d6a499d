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

  private static final int DATAGRAMS_A_MINUTE = 1_000_000;

  /** Reached from ten minutes on. */
  private static final int MOST_DATAGRAMS = 10_000_000;

  /** A machine on which it takes longer sends less, which is told. */
  private static final double LONGEST_SECONDS = 300;

  private static final double PATIENCE_SECONDS = 30;

  private GarbageTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    long datagrams = Math.round(Math.min(MOST_DATAGRAMS, minutes * DATAGRAMS_A_MINUTE));
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
              LONGEST_SECONDS,
              from,
              "garbage",
              datagrams)) {
        senders.await("sending", PATIENCE_SECONDS);
        OtherLoad others = new OtherLoad();
        CompletableFuture<String> sent =
            CompletableFuture.supplyAsync(() -> sent(senders, LONGEST_SECONDS + PATIENCE_SECONDS));
        List<Measurement> rows = new ArrayList<>();
        int tours = 0;
        String harm = "";
        while (harm.isEmpty() && !(sent.isDone() && tours > 0)) {
          harm = fly(operator);
          tours += harm.isEmpty() ? 1 : 0;
        }
        String[] words = sent.join().split(" ", -1);
        rows.add(
            Measurement.beside(
                "Eight senders of garbage, " + datagrams + " datagrams",
                String.format(Locale.ROOT, "%s in %.0f s", words[1], Double.valueOf(words[3]))));
        Measurement flight =
            new Measurement(
                "… a client that flies",
                "is not harmed",
                harm.isEmpty()
                    ? tours + " tours, " + operator.sentAgain() + " commands sent again"
                    : harm,
                harm.isEmpty());
        rows.add(OtherLoad.judged(flight, others.share()));
        rows.add(LeakedInternals.row("… log", simulator));
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
