package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.benchmark.Measurement;

/**
 * The network goes away in flight and comes back: the client's cable, the simulator's interface,
 * and that for so long that the drone lands by itself.
 */
final class InterfaceTrial {

  /** So that a silence of 15 s is one of less than 8 s. */
  private static final int TIME_FACTOR = 2;

  /** Four simulated seconds, and up to six until commands come again: the drone waits. */
  private static final double SHORT_SECONDS = 2;

  /** Twenty simulated seconds: the drone lands by itself after 15. */
  private static final double LONG_SECONDS = 10;

  /**
   * Decided: a second of the program. Linux takes up to another one until it has noticed that a
   * cable is in again, and one to ask for the neighbour's address again.
   */
  private static final double LONGEST_MS = 3000;

  private static final double WATCHED_SECONDS = 4;
  private static final double PATIENCE_SECONDS = 60;
  private static final int RETRY_MS = 2500;

  private static final String LANDED = "lands by itself";

  private InterfaceTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    try (PrivateNetwork network = new PrivateNetwork(2)) {
      Host machine = network.host(1);
      TourProcess.Ports ports = TourProcess.Ports.usual(machine.address());
      List<String> options = new ArrayList<>(List.of(ports.options()));
      options.addAll(List.of("--time-factor", "" + TIME_FACTOR, "--room", "2000x2000x500"));
      try (SimulatorProcess simulator =
              SimulatorProcess.start(
                  machine, List.of(), LanOptions.with(options.toArray(String[]::new)));
          TourProcess tours = new TourProcess(network.host(2), ports, RETRY_MS)) {
        tours.awaitFlying(PATIENCE_SECONDS);
        List<Measurement> rows = new ArrayList<>();
        rows.addAll(
            interrupt(
                "Client's cable out for 2 s", network.host(2), "cable", SHORT_SECONDS, tours));
        rows.addAll(
            interrupt("Simulator's interface down for 2 s", machine, "lan", SHORT_SECONDS, tours));
        rows.add(landing("… less than 15 simulated s: the drone", false, simulator));
        tours.awaitFlown(PATIENCE_SECONDS);
        tours.awaitFlying(PATIENCE_SECONDS);
        rows.addAll(
            interrupt("Simulator's interface down for 10 s", machine, "lan", LONG_SECONDS, tours));
        rows.add(landing("… more than 15 simulated s: the drone", true, simulator));
        int again = tours.awaitFlown(PATIENCE_SECONDS);
        rows.add(Measurement.beside("… the client flies on", again + " commands sent again"));
        rows.add(LeakedInternals.row("… log", simulator));
        return rows;
      }
    }
  }

  private static List<Measurement> interrupt(
      String what, Host where, String name, double seconds, TourProcess tours) throws IOException {
    OtherLoad others = new OtherLoad();
    where.run("ip", "link", "set", name, "down");
    long isDown = System.nanoTime();
    TourProcess.Window without = tours.window(isDown, seconds);
    long up = System.nanoTime();
    where.run("ip", "link", "set", name, "up");
    TourProcess.Window with = tours.window(up, WATCHED_SECONDS);
    double share = others.share();
    int leaked = without.state().count() + without.video().count() + without.reply().count();
    return List.of(
        new Measurement(
            what + ": what comes meanwhile", "nothing", leaked + " datagrams", leaked == 0),
        OtherLoad.judged(atMost("… until state lines come again", with.state()), share),
        OtherLoad.judged(atMost("… until pictures come again", with.video()), share),
        OtherLoad.judged(atMost("… until replies come again", with.reply()), share));
  }

  private static Measurement atMost(String what, Arrivals.Figures figures) {
    return Measurement.atMost(what, LONGEST_MS, figures.firstMs());
  }

  private static Measurement landing(String what, boolean wanted, SimulatorProcess simulator)
      throws IOException {
    boolean landed = simulator.program().log().contains(LANDED);
    String goesOn = "does not land by itself";
    return new Measurement(
        what, wanted ? LANDED : goesOn, landed ? LANDED : goesOn, landed == wanted);
  }
}
