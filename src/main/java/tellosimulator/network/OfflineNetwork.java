package tellosimulator.network;

import java.util.OptionalInt;
import java.util.function.IntFunction;
import tellosimulator.command.ReplyPort;
import tellosimulator.sim.Simulation;
import tellosimulator.sim.StatePort;

/**
 * What stands in for sockets where a simulation has none: a tap sees what would have left, and what
 * is taken. For the simulation thread.
 */
public final class OfflineNetwork {

  private final Ports ports = Ports.withoutSockets();

  /**
   * @param tap sees what passes
   */
  public OfflineNetwork(WireTap tap) {
    ports.setTap(tap);
  }

  /** The way out for the replies of the drone of a number; see {@link CommandResponseSender}. */
  public IntFunction<ReplyPort> replies(OptionalInt fixedPort) {
    return drone -> new CommandResponseSender(drone, ports, fixedPort, link -> {});
  }

  /** The way out for state lines. */
  public StatePort states() {
    return new StateConnection(ports);
  }

  /** Shows the tap what a simulation takes, from now on. */
  public void listen(Simulation to) {
    to.listen(new TakenDatagrams(ports));
  }
}
