package tellosimulator.proxy;

import java.net.InetSocketAddress;
import java.util.List;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.LocalNetworks;
import tellosimulator.sim.SimConfig.StreamPorts;

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
    InetSocketAddress drone,
    AddressPlan here,
    StreamPorts towardsDrone,
    StreamPorts towardsOperator) {

  /** Where commands are taken on this machine now. */
  List<InetSocketAddress> addresses(LocalNetworks networks) {
    return here.addresses(1, networks);
  }
}
