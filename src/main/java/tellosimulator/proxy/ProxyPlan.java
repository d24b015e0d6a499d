package tellosimulator.proxy;

import java.net.InetSocketAddress;
import java.util.List;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.LocalNetworks;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * The addresses of a proxied drone. Immutable.
 *
 * @param drone the address where the real drone accepts commands
 * @param here the addresses where this machine accepts commands in place of the drone, as drone 1
 * @param towardsDrone the ports of this machine to which the drone sends; 0 lets the system choose
 * @param towardsOperator the ports of the operator's machine to which the drone's datagrams are
 *     forwarded
 */
public record ProxyPlan(
    InetSocketAddress drone,
    AddressPlan here,
    StreamPorts towardsDrone,
    StreamPorts towardsOperator) {

  /** Returns the addresses where this machine currently accepts commands. */
  List<InetSocketAddress> addresses(LocalNetworks networks) {
    return here.addresses(1, networks);
  }
}
