package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.benchmark.Measurement;

/**
 * A class: three programs on two machines fly three drones of a third machine at once, each the
 * address and port that its drone has.
 */
final class ClassTrial {

  private static final int DRONES = 3;
  private static final String PORT = "8889";
  private static final String TIME_FACTOR = "4";
  private static final double PATIENCE_SECONDS = 60;

  private ClassTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    List<Measurement> rows = new ArrayList<>();
    try (PrivateNetwork network = new PrivateNetwork(3)) {
      rows.addAll(addressEach(network));
      rows.add(simulatorEach(network));
    }
    return rows;
  }

  /** One simulator, in which each drone has an address of the network. */
  private static List<Measurement> addressEach(PrivateNetwork network) throws IOException {
    Host machine = network.host(1);
    List<String> addresses = new ArrayList<>(List.of(machine.address()));
    for (int drone = 2; drone <= DRONES; drone++) {
      String address = "10.77.0.10" + drone;
      machine.run("ip", "address", "add", address + "/24", "dev", "lan");
      addresses.add(address);
    }
    List<Seat> seats = new ArrayList<>();
    addresses.forEach(address -> seats.add(new Seat(address, PORT)));
    try (SimulatorProcess simulator =
        SimulatorProcess.start(
            machine, List.of(), "--bind", String.join(",", addresses), "--command-port", PORT)) {
      return List.of(
          fly("A class of three on one simulator with `--bind`", network, seats),
          LeakedInternals.row("… log", simulator));
    }
  }

  /** Three simulators on one machine, each with a port of its own. */
  private static Measurement simulatorEach(PrivateNetwork network) throws IOException {
    Host machine = network.host(1);
    List<SimulatorProcess> simulators = new ArrayList<>();
    List<Seat> seats = new ArrayList<>();
    try {
      for (int drone = 1; drone <= DRONES; drone++) {
        String port = "" + (18_889 + 10 * drone);
        simulators.add(
            SimulatorProcess.start(
                machine,
                List.of(),
                LanOptions.with("--command-port", port, "--time-factor", TIME_FACTOR)));
        seats.add(new Seat(machine.address(), port));
      }
      return fly("A class of three on three simulators with `--lan`", network, seats);
    } finally {
      simulators.forEach(SimulatorProcess::close);
    }
  }

  /** Where a student's drone is. */
  private record Seat(String address, String port) {}

  private static Measurement fly(String what, PrivateNetwork network, List<Seat> seats)
      throws IOException {
    List<Program> flights = new ArrayList<>();
    List<String> complaints = new ArrayList<>();
    try {
      for (int student = 0; student < seats.size(); student++) {
        Host laptop = network.host(2 + student % 2);
        Seat seat = seats.get(student);
        flights.add(laptop.start(StudentProgram.class, seat.address(), seat.port()));
      }
      for (Program flight : flights) {
        try {
          flight.await("flown", PATIENCE_SECONDS);
        } catch (IOException e) {
          complaints.add(e.getMessage());
        }
      }
    } finally {
      flights.forEach(Program::close);
    }
    complaints.forEach(System.out::println);
    int flown = seats.size() - complaints.size();
    return new Measurement(
        what, "all fly", flown + " of " + seats.size() + " fly", complaints.isEmpty());
  }
}
