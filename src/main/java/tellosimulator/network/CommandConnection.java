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
final class CommandConnection {

  private static final Logger LOG = LoggerFactory.getLogger(CommandConnection.class);

  private final int drone;
  private final DatagramPort port;
  private final Ports ports;
  private final Simulation simulation;
  private boolean warned;

  /**
   * Receives nothing yet.
   *
   * @param drone its number, from 1
   * @param ports of all drones; what comes from one of them is no command
   */
  CommandConnection(int drone, DatagramPort port, Ports ports, Simulation simulation) {
    this.drone = drone;
    this.port = port;
    this.ports = ports;
    this.simulation = simulation;
  }

  /**
   * Starts receiving, and counts what comes.
   *
   * @return the thread, which ends soon after its port was closed, and frees it then
   */
  Thread listen(Traffic traffic) {
    return Threads.start("command-" + drone, () -> run(traffic));
  }

  private void run(Traffic traffic) {
    boolean open = true;
    while (open) {
      try {
        receive(traffic);
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

  private void receive(Traffic traffic) throws IOException {
    DatagramPort.Received received = port.receive();
    traffic.countReceived();
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
