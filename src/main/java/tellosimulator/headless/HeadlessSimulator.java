package tellosimulator.headless;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Collectors;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.DroneNetwork;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.Simulation;
import tellosimulator.sim.SimulationLoop;

/** The program without a window: drones that are on, a console, and a line when it is ready. */
public final class HeadlessSimulator implements AutoCloseable {

  private final DroneNetwork network;
  private final Simulation simulation;
  private final SimulationLoop loop;

  /**
   * Opens the sockets and starts the simulation; all drones are on.
   *
   * @param replyPort port to which all replies go; empty for the port each command came from
   * @throws PortTakenException if an address or port cannot be had
   */
  public HeadlessSimulator(SimConfig config, AddressPlan plan, OptionalInt replyPort)
      throws PortTakenException {
    network = DroneNetwork.open(plan);
    simulation =
        new Simulation(
            config, drone -> network.replies(replyPort), network.states(), List.of(new EventLog()));
    for (int drone = 1; drone <= config.starts().size(); drone++) {
      simulation.control(new Control.Power(drone, true));
    }
    loop = new SimulationLoop(simulation);
    network.listen(simulation);
  }

  /**
   * Says that it is ready and takes what is typed; returns after {@code quit}, and never if the
   * input ends without it.
   */
  public void run(BufferedReader in, PrintStream out) throws IOException, InterruptedException {
    shrinkHeap();
    out.println(ready());
    out.flush();
    if (!new Console(simulation, loop::carryOut, in, out).run()) {
      new CountDownLatch(1).await();
    }
  }

  /**
   * Gives memory back. The JVM starts with a sixty-fourth of the machine's memory as heap and fills
   * it before it collects for the second time; a full collection lets it adopt the few megabytes
   * that a simulation needs.
   */
  private static void shrinkHeap() {
    System.gc();
  }

  private String ready() {
    List<String> drones = new ArrayList<>();
    for (List<InetSocketAddress> addresses : network.addresses()) {
      String where =
          addresses.stream()
              .map(address -> address.getAddress().getHostAddress() + ":" + address.getPort())
              .collect(Collectors.joining(", "));
      drones.add("drone " + (drones.size() + 1) + " at " + where);
    }
    return "ready: " + String.join("; ", drones);
  }

  @Override
  public void close() {
    network.close();
    loop.close();
  }
}
