package tellosimulator.command;

import java.util.Optional;
import tellosimulator.time.SimTime;

/**
 * SDK mode, and who the operator is. Lost with the power. For the simulation thread.
 *
 * <p>The sender of the first {@code command} is the operator. When it has been silent for a while,
 * the next sender of {@code command} takes over.
 */
public final class OperatorSession {

  /** Silence after which another may take over [s]. Decided: the time of the safety landing. */
  private static final double SILENCE = 15;

  private final Link unlinked;
  private Link link;
  private SimTime lastHeard = SimTime.ZERO;

  /**
   * @param statePort where state lines go unless {@code port} says otherwise
   * @param videoPort where video goes unless {@code port} says otherwise
   */
  public OperatorSession(int statePort, int videoPort) {
    this.unlinked = new Link(Optional.empty(), statePort, videoPort);
    this.link = unlinked;
  }

  public Link link() {
    return link;
  }

  /** Notes that something came from {@code peer}. */
  void heard(Peer peer, SimTime now) {
    if (isOperator(peer)) {
      lastHeard = now;
    }
  }

  /**
   * Takes a {@code command}.
   *
   * @return whether the operator is another one now
   */
  public boolean open(Peer peer, SimTime now) {
    boolean silent = now.since(lastHeard) >= SILENCE;
    if (link.sdkMode() && (isOperator(peer) || !silent)) {
      return false;
    }
    link = unlinked.with(peer);
    lastHeard = now;
    return true;
  }

  /**
   * Takes a {@code port}, which moves the ports of its sender only.
   *
   * @return false if the sender is not the operator
   */
  public boolean setPorts(Peer peer, int statePort, int videoPort) {
    if (!isOperator(peer)) {
      return false;
    }
    link = link.withPorts(statePort, videoPort);
    return true;
  }

  /** Forgets everything, as without power. */
  public void close() {
    link = unlinked;
  }

  private boolean isOperator(Peer peer) {
    return link.operator().filter(operator -> operator.host().equals(peer.host())).isPresent();
  }
}
