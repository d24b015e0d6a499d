package tellosimulator.proxy;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Locale;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.LocalNetworks;
import tellosimulator.sim.SimConfig.Outlets;

/**
 * Which drone is passed on, and where. Immutable; for any thread.
 *
 * @param drone where the real drone takes commands
 * @param here where this machine takes them in its place, as of a drone 1
 * @param towardsDrone the ports of this machine to which the drone sends; 0 for one that the system
 *     chooses
 * @param towardsOperator the ports of the operator's machine to which that is passed on
 */
public record ProxyPlan(
    InetSocketAddress drone, AddressPlan here, Outlets towardsDrone, Outlets towardsOperator) {

  /** Where a real drone takes commands. Documented: SDK 1.3 User Guide. */
  public static final int COMMAND_PORT = 8889;

  /**
   * @throws IllegalArgumentException with a clause, if the proxy would talk to itself
   */
  public ProxyPlan {
    if (here.addresses(1, LocalNetworks.look()).contains(drone)) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "--drone %s:%d is where the proxy itself takes commands; name the drone's address",
              drone.getAddress().getHostAddress(),
              drone.getPort()));
    }
  }

  /** Where commands are taken on this machine now. */
  List<InetSocketAddress> addresses(LocalNetworks networks) {
    return here.addresses(1, networks);
  }
}
