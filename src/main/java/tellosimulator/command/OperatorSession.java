package tellosimulator.command;

import java.util.Optional;
import java.util.function.Consumer;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The SDK mode of a drone, and the host that operates it. A loss of power ends SDK mode and leaves
 * the drone without an operator. After that, the session remembers the previous operator only for
 * messages. Confined to the simulation thread.
 *
 * <p>The first host that sends {@code command} becomes the operator. A restarted program sends from
 * another port of the same host, and the host remains the operator. The drone becomes free after a
 * reset, or when it stands on the ground and its operator has been silent for a minute. The next
 * sender of {@code command} then becomes the operator.
 */
public final class OperatorSession {

  /** Silence of the operator after which a drone on the ground becomes free [s]. Decided. */
  private static final double FREE_AFTER = 60;

  /**
   * Silence of the operator after which the drone becomes free, even in flight, if every host may
   * send commands [s]. Decided: the same as the timeout of the safety landing.
   */
  private static final double FREE_FOR_ANYONE_AFTER = 15;

  /**
   * Silence of an operator on another machine after which state lines are suspended [s]. Decided: a
   * program that has ended must not cause traffic in the network for ever.
   */
  private static final double REST_AFTER = 120;

  /** Delay after which the session tries once more to send state lines [s]. Decided. */
  private static final double TRIES_AGAIN_AFTER = 2;

  /** A change of operator, with the previous operator if it was another host. */
  public record Takeover(Peer operator, Optional<Peer> before) {}

  private final OperatorRule rule;
  private final OperatorEndpoint unlinked;
  private final Consumer<OperatorEndpoint> listener;
  private OperatorEndpoint link;

  /** Whether {@code command} has been accepted since the drone has power. */
  private boolean text;

  /** The number of requests so far, in all protocols. */
  private int requests;

  /** The previous operator, if it was another host. */
  private Optional<Peer> former = Optional.empty();

  private SimTime lastHeard = SimTime.ZERO;
  private boolean released;
  private int rests;
  private SimTime restsSince = SimTime.ZERO;

  /**
   * Creates a session without an operator.
   *
   * @param statePort the port for state lines, unless {@code port} changes it
   * @param videoPort the port for video, unless {@code port} changes it
   * @param listener notified of each new endpoint before anything is sent to it
   */
  public OperatorSession(
      OperatorRule rule, int statePort, int videoPort, Consumer<OperatorEndpoint> listener) {
    this.rule = rule;
    this.listener = listener;
    this.unlinked = OperatorEndpoint.raw(Optional.empty(), statePort, videoPort);
    this.link = unlinked;
  }

  public OperatorEndpoint link() {
    return link;
  }

  /**
   * Whether {@code peer} may send commands that change anything. While there is no operator, any
   * host that the rule accepts may.
   */
  public boolean admits(Peer peer) {
    if (!rule.exclusive()) {
      return true;
    }
    return link.sdkMode() ? isOperator(peer) : rule.accepts(peer.address().getAddress());
  }

  /** Explains why {@code peer} is not admitted, worded to follow "turned away: ". */
  public Phrase refusal(Peer peer) {
    if (!rule.accepts(peer.address().getAddress())) {
      return Phrase.of(
          "--operator lets only %s operate the drone", rule.only().orElseThrow().getHostAddress());
    }
    String operator = link.operator().orElseThrow().host();
    return former.filter(lost -> lost.host().equals(peer.host())).isPresent()
        ? Phrase.of(
            "the drone is operated by %s now, which took over from %s; release it to take it back",
            operator, peer.host())
        : Phrase.of(
            "the drone is operated by %s until it is released or, on the ground, %s is silent for"
                + " %.0f s",
            operator, operator, FREE_AFTER);
  }

  /**
   * Records that {@code peer} has sent something. If the peer's host is the operator, the endpoint
   * is updated to the peer's current address.
   */
  public void heard(Peer peer, SimTime now) {
    if (isOperator(peer)) {
      lastHeard = now;
      released = false;
      rests = 0;
      adopt(link.with(peer));
    }
  }

  /**
   * Handles {@code command}: makes its sender the operator if the drone is free.
   *
   * @param standing whether the drone stands on the ground
   * @return the takeover, if the operator has changed
   */
  public Optional<Takeover> open(Peer peer, SimTime now, boolean standing) {
    text = true;
    if (isOperator(peer) && link.app()) {
      adopt(unlinked.with(peer));
    }
    return isOperator(peer) ? Optional.empty() : take(unlinked.with(peer), now, standing);
  }

  /**
   * Handles a connection request of the app: makes its sender the operator if the drone is free, or
   * if the sender is the operator already. Until the drone loses power, none is accepted after
   * {@code command}. Measured: TelloPy 95.
   *
   * @param standing whether the drone stands on the ground
   * @param videoPort the port for video on the sender's host
   * @return whether the sender is the operator now
   */
  public boolean openForApp(
      Peer peer, SimTime now, boolean standing, int videoPort, Packetizer packetizer) {
    if (text) {
      return false;
    }
    OperatorEndpoint wanted =
        new OperatorEndpoint(Optional.of(peer), unlinked.statePort(), videoPort, packetizer);
    if (isOperator(peer)) {
      adopt(wanted);
      return true;
    }
    return take(wanted, now, standing).isPresent();
  }

  private Optional<Takeover> take(OperatorEndpoint wanted, SimTime now, boolean standing) {
    Peer peer = wanted.operator().orElseThrow();
    if (!rule.accepts(peer.address().getAddress()) || !free(now, standing)) {
      return Optional.empty();
    }
    former = last().filter(lost -> !lost.host().equals(peer.host()));
    adopt(wanted);
    lastHeard = now;
    released = false;
    rests = 0;
    return Optional.of(new Takeover(peer, former));
  }

  /** Returns the number of the next request, from 1. */
  public int nextRequest() {
    requests++;
    return requests;
  }

  private Optional<Peer> last() {
    return link.operator().or(() -> former);
  }

  private boolean free(SimTime now, boolean standing) {
    double silence = now.since(lastHeard);
    boolean given =
        rule.exclusive() ? standing && silence >= FREE_AFTER : silence >= FREE_FOR_ANYONE_AFTER;
    return !link.sdkMode() || released || given;
  }

  /**
   * Lets the next sender of {@code command} become the operator. The current operator is not
   * affected until then.
   */
  public void release() {
    released = true;
  }

  /**
   * Handles {@code port}. It changes the ports only if its sender is the operator.
   *
   * @return false if the sender is not the operator
   */
  public boolean setPorts(Peer peer, int statePort, int videoPort) {
    if (!isOperator(peer)) {
      return false;
    }
    adopt(link.withPorts(statePort, videoPort));
    rests = 0;
    return true;
  }

  /**
   * Handles the report that the operator's state port is closed: suspends state lines until the
   * operator sends something. After the first report, one more line is sent, in case a program
   * opens its port a little later.
   */
  public void restState(SimTime now) {
    if (wantsState(now)) {
      rests++;
      restsSince = now;
    }
  }

  /** Whether state lines must be sent now. */
  public boolean wantsState(SimTime now) {
    boolean remote = link.operator().filter(operator -> !operator.local()).isPresent();
    boolean taken = rests == 0 || (rests == 1 && now.since(restsSince) >= TRIES_AGAIN_AFTER);
    return link.sdkMode()
        && !link.app()
        && taken
        && !(remote && now.since(lastHeard) >= REST_AFTER);
  }

  /** Ends SDK mode, as on a loss of power. The drone is then free. */
  public void close() {
    former = last();
    text = false;
    adopt(unlinked);
    released = false;
    rests = 0;
  }

  private void adopt(OperatorEndpoint newLink) {
    if (!newLink.equals(link)) {
      link = newLink;
      listener.accept(link);
    }
  }

  private boolean isOperator(Peer peer) {
    return link.operator().filter(operator -> operator.host().equals(peer.host())).isPresent();
  }
}
