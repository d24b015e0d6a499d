package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.benchmark.Measurement;

/** A stranger sends 50,000 datagrams of garbage a second while an operator queries and flies. */
final class FloodTrial {

  private static final int RATE = 50_000;

  /** With less than this it is no flood, and the row does not count. */
  private static final double LEAST_RATE = 0.8 * RATE;

  private static final double MOST_LOST_PERCENT = 0.5;
  private static final double LARGEST_GROWTH_MB = 30;
  private static final double LARGEST_LOG_MB = 1;

  private static final double SHORTEST_SECONDS = 10;
  private static final double SECONDS_A_MINUTE = 3;

  /** How much longer the stranger sends than the operator is watched [s]. */
  private static final double LONGER_SECONDS = 2;

  /** How long the Java machine may compile what a flood takes before memory counts [s]. */
  private static final double COMPILING_SECONDS = 8;

  private static final double PATIENCE_SECONDS = 60;

  private static final Pattern SERVED =
      Pattern.compile("served lost (\\d+) asked (\\d+) median (\\S+) p99 (\\S+) period (\\S+)");

  private static final Pattern SENT = Pattern.compile("sent (\\d+) in (\\S+) s");

  /** From here the operator sends too, where he is on the same machine. */
  private static final String OWN = "127.0.0.1";

  private final String name;
  private final Host operator;
  private final Host stranger;

  /** The addresses that the stranger sends from, with commas between them. */
  private final String from;

  /** Garbage may hold commands; from the operator's own address they count as his. */
  private final String what;

  private FloodTrial(String name, Host operator, Host stranger, String from) {
    this.name = name;
    this.operator = operator;
    this.stranger = stranger;
    this.from = from;
    what = from.equals(OWN) ? "nonsense" : "garbage";
  }

  /** A stranger on another machine of the network, on this one, and at the operator's address. */
  static List<Measurement> run(double minutes) throws IOException {
    double seconds = Math.max(SHORTEST_SECONDS, minutes * SECONDS_A_MINUTE);
    List<Measurement> rows = new ArrayList<>();
    try (PrivateNetwork network = new PrivateNetwork(3)) {
      rows.addAll(
          new FloodTrial("Flood from another machine", network.host(2), network.host(3), "0.0.0.0")
              .against(network.host(1), seconds, LanOptions.with("--command-port", "8889")));
    }
    rows.addAll(here("Flood from another address of the machine", "127.0.0.9", seconds));
    rows.addAll(here("Flood of nonsense from the operator's own address", OWN, seconds));
    return rows;
  }

  private static List<Measurement> here(String name, String from, double seconds)
      throws IOException {
    return new FloodTrial(name, Host.HERE, Host.HERE, from)
        .against(Host.HERE, seconds, "--command-port", "0");
  }

  private List<Measurement> against(Host host, double seconds, String... options)
      throws IOException {
    String statePort = "" + FreePort.find();
    List<String> all = new ArrayList<>(List.of(options));
    all.addAll(List.of("--state-port", statePort, "--room", "2000x2000x500"));
    try (SimulatorProcess simulator =
            SimulatorProcess.start(host, List.of(), all.toArray(String[]::new));
        Program pilot =
            operator.start(
                Pilot.class, host.address(), simulator.drone(1).getPort(), statePort, seconds)) {
      pilot.await("flying", PATIENCE_SECONDS);
      double calm = simulator.figures().residentMegabytes();
      long log = simulator.program().logBytes();
      long begun = System.nanoTime();
      try (Program sender =
          stranger.start(
              Stranger.class,
              host.address(),
              simulator.drone(1).getPort(),
              RATE,
              COMPILING_SECONDS + seconds + LONGER_SECONDS,
              from,
              what)) {
        sender.await("sending", PATIENCE_SECONDS);
        Waiting.pass(COMPILING_SECONDS);
        double heap = simulator.figures().heapMegabytes();
        double resident = simulator.figures().residentMegabytes();
        OtherLoad others = new OtherLoad();
        pilot.type("go");
        Matcher served = match(SERVED, pilot.await("served", seconds + PATIENCE_SECONDS));
        double share = others.share();
        Matcher sent = match(SENT, sender.await("sent", PATIENCE_SECONDS));
        double rate = Double.parseDouble(sent.group(1)) / Double.parseDouble(sent.group(2));
        double residentGrowth = simulator.figures().residentMegabytes() - resident;
        double logGrowth =
            (simulator.program().logBytes() - log) / 1e6 * 60e9 / (System.nanoTime() - begun);
        double heapGrowth = simulator.figures().heapMegabytes() - heap;
        List<Measurement> rows = new ArrayList<>(service(served, rate));
        rows.add(
            Measurement.beside(
                "… resident memory grows at its beginning, while it is compiled, by",
                String.format(Locale.ROOT, "%.2f MB", resident - calm)));
        rows.add(
            Measurement.atMost(
                "… resident memory grows by", LARGEST_GROWTH_MB, residentGrowth, "MB"));
        rows.add(Measurement.atMost("… heap grows by", LARGEST_GROWTH_MB, heapGrowth, "MB"));
        rows.add(Measurement.atMost("… log grows in a minute by", LARGEST_LOG_MB, logGrowth, "MB"));
        rows.add(LeakedInternals.row("… log", simulator));
        return rows.stream().map(row -> OtherLoad.judged(row, share)).toList();
      }
    }
  }

  private List<Measurement> service(Matcher served, double rate) {
    double lost = Double.parseDouble(served.group(1));
    double lostPercent = 100 * lost / Double.parseDouble(served.group(2));
    double period = Double.parseDouble(served.group(5));
    return List.of(
        new Measurement(
            name,
            String.format(Locale.ROOT, "at least %.0f datagrams/s", LEAST_RATE),
            String.format(Locale.ROOT, "%.0f datagrams/s", rate),
            rate >= LEAST_RATE),
        Measurement.atMost("… operator's queries lost", MOST_LOST_PERCENT, lostPercent, "%"),
        Measurement.atMost("… reply, median", 1, Double.parseDouble(served.group(3))),
        Measurement.atMost("… reply, 99th percentile", 10, Double.parseDouble(served.group(4))),
        new Measurement(
            "… state lines, mean period",
            "100 ms ± 1",
            String.format(Locale.ROOT, "%.3f ms", period),
            Math.abs(period - 100) <= 1));
  }

  private static Matcher match(Pattern pattern, String line) throws IOException {
    Matcher matcher = pattern.matcher(line);
    if (!matcher.find()) {
      throw new IOException("cannot be read: " + line);
    }
    return matcher;
  }
}
