package tellosimulator.network;

import java.io.IOException;
import java.nio.channels.ClosedChannelException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.Peer;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.Exceptions;
import tellosimulator.concurrent.Verdict;
import tellosimulator.concurrent.Worker;
import tellosimulator.sim.Simulation;

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
  private final Gate gate;
  private boolean warned;

  /** Decides whether a datagram is taken. */
  @FunctionalInterface
  interface Gate {
    boolean admits(Peer peer, String text);
  }

  /**
   * Receives nothing yet.
   *
   * @param drone its number, from 1
   * @param ports of all drones; what comes from one of them is no command
   */
  CommandConnection(int drone, DatagramPort port, Ports ports, Simulation simulation, Gate gate) {
    this.drone = drone;
    this.port = port;
    this.ports = ports;
    this.simulation = simulation;
    this.gate = gate;
  }

  /**
   * Starts receiving, and counts what comes.
   *
   * @return the worker, which ends soon after its port was closed, and frees it then
   */
  Worker listen(Traffic traffic) {
    return Worker.start("command-" + drone, new Receiver(traffic));
  }

  private final class Receiver implements Agent {

    private final String failed = "Receiving on " + port.address() + " failed";
    private final Verdict once = Verdict.goOn(failed);
    private final Verdict fatal = Verdict.retry(failed);
    private final Traffic traffic;

    Receiver(Traffic traffic) {
      this.traffic = traffic;
    }

    @Override
    public Outcome doWork() throws IOException {
      try {
        receive(traffic);
        return Outcome.WORKED;
      } catch (ClosedChannelException e) {
        return Outcome.FINISHED;
      }
    }

    @Override
    public Verdict onError(Throwable failure) {
      return Exceptions.isFatal(failure) ? fatal : once;
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
    if (!gate.admits(peer, received.text()) || !simulation.submit(drone, peer, received.text())) {
      traffic.countDropped();
    }
  }
}
