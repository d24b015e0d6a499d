package tellosimulator.network;

import java.net.InetSocketAddress;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.network.Ports.Outgoing;
import tellosimulator.sim.StatePort;

/**
 * Sends state lines to the operator's host, from the address and port that was commanded. Called on
 * the simulation thread.
 */
public final class StateConnection implements StatePort {

  private final Ports ports;

  public StateConnection(Ports ports) {
    this.ports = ports;
  }

  @Override
  public void send(StateReport report) {
    report
        .link()
        .operator()
        .ifPresent(operator -> send(operator, report.link().statePort(), report));
  }

  private void send(Peer operator, int statePort, StateReport report) {
    InetSocketAddress to = new InetSocketAddress(operator.address().getAddress(), statePort);
    byte[] bytes = WireText.encode(report.corruption().applied(StateLine.format(report)));
    Outgoing line = new Outgoing(report.state().drone(), WireTap.Kind.STATE, bytes);
    ports.send(operator.via(), line, to);
  }
}
