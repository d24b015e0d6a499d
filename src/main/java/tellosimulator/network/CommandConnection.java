package tellosimulator.network;

import java.io.IOException;
import java.nio.channels.ClosedChannelException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.Peer;
import tellosimulator.sim.Simulation;
import tellosimulator.time.Threads;

/**
 * Receives the commands that come to one port of a drone, on a thread of its own, and hands them to
 * the simulation. Nothing that arrives ends it; closing its port does.
 */
public final class CommandConnection {

  private static final Logger LOG = LoggerFactory.getLogger(CommandConnection.class);

  private final int drone;
  private final DatagramPort port;
  private final Ports ports;
  private final Simulation simulation;
  private boolean warned;

  private CommandConnection(int drone, DatagramPort port, Ports ports, Simulation simulation) {
    this.drone = drone;
    this.port = port;
    this.ports = ports;
    this.simulation = simulation;
  }

  /**
   * Starts receiving.
   *
   * @param drone its number, from 1
   * @param ports of all drones; what comes from one of them is no command
   */
  public static void listen(int drone, DatagramPort port, Ports ports, Simulation simulation) {
    CommandConnection connection = new CommandConnection(drone, port, ports, simulation);
    Threads.start("command-" + drone, connection::run);
  }

  private void run() {
    boolean open = true;
    while (open) {
      try {
        receive();
      } catch (ClosedChannelException e) {
        open = false;
      } catch (IOException | RuntimeException e) {
        LOG.warn("Receiving on {} failed once: {}", port.address(), e.toString());
        Threads.backOff();
      }
    }
  }

  private void warnOnce() {
    if (!warned) {
      LOG.warn(
          "Drone {} receives its own replies or state lines at {}: give --command-port, --state-port"
              + " and --reply-port different ports",
          drone,
          port.address());
    }
    warned = true;
  }

  private void receive() throws IOException {
    DatagramPort.Received received = port.receive();
    if (ports.own(received.sender())) {
      warnOnce();
      return;
    }
    Peer peer = new Peer(received.sender(), port.address());
    if (!simulation.submit(drone, peer, received.text())) {
      LOG.debug("Drone {} is flooded, a datagram from {} is lost", drone, peer);
    }
  }
}
