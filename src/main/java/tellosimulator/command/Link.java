package tellosimulator.command;

import java.util.Optional;

/**
 * Where a drone's state and video go.
 *
 * @param operator who sent the first {@code command}; empty while SDK mode is off
 * @param statePort port on the operator's host
 * @param videoPort port on the operator's host
 */
public record Link(Optional<Peer> operator, int statePort, int videoPort) {

  /** Whether a first {@code command} was taken since power-on. */
  public boolean sdkMode() {
    return operator.isPresent();
  }

  Link with(Peer newOperator) {
    return new Link(Optional.of(newOperator), statePort, videoPort);
  }

  Link withPorts(int newStatePort, int newVideoPort) {
    return new Link(operator, newStatePort, newVideoPort);
  }
}
