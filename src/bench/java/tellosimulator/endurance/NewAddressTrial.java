package tellosimulator.endurance;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import tellosimulator.benchmark.Measurement;

/** The machine moves to another network while the program runs. */
final class NewAddressTrial {

  private static final String PORT = "8889";
  private static final String NEW = "10.88.0.1";
  private static final String NEW_CLIENT = "10.88.0.2";
  private static final double PATIENCE_SECONDS = 30;

  private NewAddressTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    try (PrivateNetwork network = new PrivateNetwork(2)) {
      Host first = network.host(1);
      Host client = network.host(2);
      try (SimulatorProcess simulator =
          SimulatorProcess.start(
              first, List.of(), LanOptions.with("--command-port", PORT, "--time-factor", "4"))) {
        boolean before = flies(client, first.address());
        first.run("ip", "address", "del", first.address() + "/24", "dev", "lan");
        first.run("ip", "address", "add", NEW + "/24", "dev", "lan");
        client.run("ip", "address", "add", NEW_CLIENT + "/24", "dev", "cable");
        simulator.type("power off");
        simulator.type("power on");
        long begun = System.nanoTime();
        boolean after = flies(client, NEW);
        double seconds = (System.nanoTime() - begun) * 1e-9;
        return List.of(
            new Measurement(
                "An address that appears after the start, after power off and on",
                "is served",
                String.format(
                    Locale.ROOT, "%s, flight of %.1f s", after ? "is served" : "is not", seconds),
                before && after));
      }
    }
  }

  private static boolean flies(Host client, String drone) throws IOException {
    try (Program flight = client.start(StudentProgram.class, drone, PORT)) {
      return flight.await("flown", PATIENCE_SECONDS).equals("flown");
    } catch (IOException e) {
      System.out.println(drone + ": " + e.getMessage());
      return false;
    }
  }
}
