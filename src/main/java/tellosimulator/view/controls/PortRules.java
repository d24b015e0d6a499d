package tellosimulator.view.controls;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import tellosimulator.network.AddressPlan;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.view.text.Message;

/** Which ports of a drone and of an operator go together. */
final class PortRules {

  /** The ports that there are. */
  static final NumberRange PORTS = new NumberRange(1, AddressPlan.HIGHEST_PORT, 1);

  private static final Set<Integer> LISTENING_PORTS =
      Set.of(StreamPorts.DEFAULT.statePort(), StreamPorts.DEFAULT.videoPort());

  private PortRules() {}

  /** State and video go to the same host, so they need different ports. */
  static Optional<Message> streamPort(double port, int otherStreamPort) {
    if (port != Math.rint(port)) {
      return Optional.of(Message.of("port.whole"));
    }
    return port == otherStreamPort
        ? Optional.of(Message.of("port.same", Integer.toString(otherStreamPort)))
        : Optional.empty();
  }

  /**
   * Two drones cannot listen on the same port of the same address.
   *
   * @param own where this drone listens, on its old port
   * @param others where each drone listens, in the order of their numbers, this one's empty
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

  /** What is possible, but works only if the operator program runs on another machine. */
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
