package tellosimulator.command;

import java.net.InetSocketAddress;
import java.util.Optional;

/**
 * The destination of a drone's state and video.
 *
 * @param operator the sender of the first {@code command}; empty while SDK mode is off
 * @param statePort the port for state lines on the operator's host
 * @param videoPort the port for video on the operator's host
 * @param packetizer splits the video into datagrams
 */
public record OperatorEndpoint(
    Optional<Peer> operator, int statePort, int videoPort, Packetizer packetizer) {

  /** Returns an endpoint for raw video. */
  public static OperatorEndpoint raw(Optional<Peer> operator, int statePort, int videoPort) {
    return new OperatorEndpoint(operator, statePort, videoPort, Packetizer.RAW);
  }

  /** Whether the operator uses the app's protocol, whose video has another format. */
  public boolean app() {
    return packetizer != Packetizer.RAW;
  }

  /** Whether the drone has an operator, that is, whether it has accepted {@code command}. */
  public boolean sdkMode() {
    return operator.isPresent();
  }

  /** Returns the operator with another port; empty if there is no operator. */
  public Optional<Peer> at(int port) {
    return operator.map(
        peer -> new Peer(new InetSocketAddress(peer.address().getAddress(), port), peer.via()));
  }

  OperatorEndpoint with(Peer newOperator) {
    return new OperatorEndpoint(Optional.of(newOperator), statePort, videoPort, packetizer);
  }

  OperatorEndpoint withPorts(int newStatePort, int newVideoPort) {
    return new OperatorEndpoint(operator, newStatePort, newVideoPort, packetizer);
  }
}
