package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.benchmark.Measurement;

/**
 * Somebody sends {@code command} and {@code streamon} in the name of another machine, the victim,
 * which shall get next to nothing.
 */
final class ReflectorTrial implements AutoCloseable {

  private static final String PORT = "8889";
  private static final String STATE_PORT = "8890";
  private static final String VIDEO_PORT = "11111";
  private static final String SENDER_PORT = "40000";

  /** Where the victim answers that nobody listens. */
  private static final double MOST_BYTES = 1000;

  private static final double SECONDS = 10;

  /** After so much silence of an operator nothing is sent to him any more, and some tolerance. */
  private static final double REST_SECONDS = 120 + 2;

  /** How long nothing must come after that [s]. */
  private static final double QUIET_SECONDS = 8;

  /** From where nobody sends who is on the same cable. Source: RFC 5737, and a private one. */
  private static final List<String> OFF_LINK = List.of("203.0.113.7", "10.99.0.7");

  private static final double PATIENCE_SECONDS = 10;

  private final PrivateNetwork network = new PrivateNetwork(3);
  private final Host victim = network.host(2);
  private final Host attacker = network.host(3);
  private final SimulatorProcess simulator;

  private ReflectorTrial() throws IOException {
    try {
      // What goes elsewhere goes by the victim, who then sees it.
      network.host(1).run("ip", "route", "add", "default", "via", victim.address());
      simulator =
          SimulatorProcess.start(
              network.host(1), List.of(), LanOptions.with("--command-port", PORT));
    } catch (IOException e) {
      network.close();
      throw e;
    }
  }

  /** A victim that answers ICMP, and senders that are on no cable of the machine. */
  static List<Measurement> run(double minutes) throws IOException {
    List<Measurement> rows = new ArrayList<>();
    try (ReflectorTrial trial = new ReflectorTrial()) {
      rows.addAll(trial.answeringVictim());
    }
    for (String sender : OFF_LINK) {
      try (ReflectorTrial trial = new ReflectorTrial()) {
        rows.addAll(trial.offLink(sender));
      }
    }
    return rows;
  }

  /** A victim that takes all and says nothing; takes somewhat more than two minutes. */
  static List<Measurement> runSilent(double minutes) throws IOException {
    try (ReflectorTrial trial = new ReflectorTrial()) {
      return List.of(trial.silentVictim());
    }
  }

  private List<Measurement> answeringVictim() throws IOException {
    try (Program witness = witness()) {
      double forged = forge(victim.address());
      Waiting.pass(SECONDS);
      double bytes = seen(witness, 1);
      forge(victim.address());
      Waiting.pass(SECONDS);
      return List.of(
          Measurement.atMost(
              "Forged sender: the victim, which answers ICMP, gets", MOST_BYTES, bytes, "B"),
          Measurement.beside(
              "… factor for " + (int) forged + " forged bytes",
              String.format(Locale.ROOT, "%.1f", bytes / forged)),
          Measurement.atMost(
              "… and when it is forged again", MOST_BYTES, seen(witness, 1) - bytes, "B"));
    }
  }

  private Measurement silentVictim() throws IOException {
    try (Program witness = witness(STATE_PORT, VIDEO_PORT, SENDER_PORT)) {
      double forged = forge(victim.address());
      Waiting.pass(REST_SECONDS + QUIET_SECONDS);
      double bytes = seen(witness, 1);
      double seconds = REST_SECONDS + QUIET_SECONDS - seen(witness, 2);
      return new Measurement(
          "Forged sender: a victim that is silent gets something for",
          String.format(Locale.ROOT, "at most %.0f s", REST_SECONDS),
          String.format(
              Locale.ROOT, "%.1f s, %.1f MB, factor %.0f", seconds, bytes / 1e6, bytes / forged),
          seconds <= REST_SECONDS);
    }
  }

  private List<Measurement> offLink(String sender) throws IOException {
    try (Program witness = witness()) {
      forge(sender);
      Waiting.pass(SECONDS / 2);
      double bytes = seen(witness, 1);
      boolean told = simulator.program().log().contains(sender);
      return List.of(
          Measurement.atMost(
              "Forged sender " + sender + ", on no link of the machine, gets", 0, bytes, "B"),
          new Measurement("… the log", "names it", told ? "names it" : "does not name it", told));
    }
  }

  private Program witness(String... silentPorts) throws IOException {
    List<Object> arguments = new ArrayList<>(List.of("witness", network.host(1).address()));
    arguments.addAll(List.of(silentPorts));
    Program witness = victim.python("datagrams.py", arguments.toArray());
    witness.await("watching", PATIENCE_SECONDS);
    return witness;
  }

  private static double seen(Program witness, int word) throws IOException {
    witness.type("");
    return Double.parseDouble(witness.await("seen", PATIENCE_SECONDS).split(" ", -1)[word]);
  }

  /** Sends the two commands, and tells how many bytes that took. */
  private double forge(String sender) throws IOException {
    String drone = network.host(1).address();
    try (Program forger =
        attacker.python(
            "datagrams.py", "forge", sender, SENDER_PORT, drone, PORT, "command", "streamon")) {
      return Double.parseDouble(forger.await("forged", PATIENCE_SECONDS).split(" ", -1)[1]);
    }
  }

  @Override
  public void close() {
    simulator.close();
    network.close();
  }
}
