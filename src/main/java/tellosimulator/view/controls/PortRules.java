package tellosimulator.view.controls;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import tellosimulator.network.AddressPlan;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.view.text.Message;

/** Rules for the ports of a drone and of an operator. */
final class PortRules {

  /** The valid ports. */
  static final NumberRange PORTS = new NumberRange(1, AddressPlan.HIGHEST_PORT, 1);

  private static final Set<Integer> LISTENING_PORTS =
      Set.of(StreamPorts.DEFAULT.statePort(), StreamPorts.DEFAULT.videoPort());

  private PortRules() {}

  /**
   * Returns the error message if a port is not valid for a stream. State and video go to the same
   * host, so they need different ports.
   */
  static Optional<Message> streamPort(double port, int otherStreamPort) {
    if (port != Math.rint(port)) {
      return Optional.of(Message.of("port.whole"));
    }
    return port == otherStreamPort
        ? Optional.of(Message.of("port.same", Integer.toString(otherStreamPort)))
        : Optional.empty();
  }

  /**
   * Returns the error message if a port is not valid as the command port. Two drones cannot listen
   * on the same port of the same address.
   *
   * @param own the addresses of this drone, with its current port
   * @param others the addresses of each drone, in the order of drone numbers; empty for this drone
   */
  static Optional<Message> command(
      double port, List<InetSocketAddress> own, List<List<InetSocketAddress>> others) {
    if (port != Math.rint(port)) {
      return Optional.of(Message.of("port.whole"));
    }
    for (int i = 0; i < others.size(); i++) {
      for (InetSocketAddress address : own) {
        if (others.get(i).contains(new InetSocketAddress(address.getAddress(), (int) port))) {
          return Optional.of(Message.of("port.other-drone", Integer.toString(i + 1)));
        }
      }
    }
    return Optional.empty();
  }

  /** Returns a warning if the command port works only for operator programs on other machines. */
  static Optional<Message> warning(int command, StreamPorts streamPorts) {
    if (command == AddressPlan.REAL_COMMAND_PORT) {
      return Optional.of(Message.of("port.operators", Integer.toString(command)));
    }
    boolean listening =
        LISTENING_PORTS.contains(command)
            || command == streamPorts.statePort()
            || command == streamPorts.videoPort();
    return listening
        ? Optional.of(Message.of("port.listening", Integer.toString(command)))
        : Optional.empty();
  }
}
