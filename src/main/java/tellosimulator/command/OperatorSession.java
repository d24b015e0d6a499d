package tellosimulator.command;

import java.util.Optional;
import java.util.function.Consumer;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * SDK mode, and which host operates the drone. Lost with the power; only who operated it last is
 * remembered, for people. For the simulation thread.
 *
 * <p>The host that first sends {@code command} is the operator; a program that is restarted sends
 * from another port of the same host and goes on. The drone is free again when it stands on the
 * ground and its operator has been silent for a minute, and after a reset; then the next sender of
 * {@code command} takes over, while the old operator just goes on if it is first.
 */
public final class OperatorSession {

  /** Silence on the ground after which the drone is free [s]. Decided. */
  private static final double FREE_AFTER = 60;

  /**
   * The same where everybody may steer, on the ground or not [s]. Decided: the time of the safety
   * landing.
   */
  private static final double FREE_FOR_ANYONE_AFTER = 15;

  /**
   * Silence of an operator on another machine after which its state lines rest [s]. Decided: what
   * nobody asks for is not sent into a network for ever.
   */
  private static final double REST_AFTER = 120;

  /** When it is tried once more whether anybody takes state lines [s]. Decided. */
  private static final double TRIES_AGAIN_AFTER = 2;

  /** A drone changed hands: who operates it now, and who on another host did before, if anybody. */
  public record Takeover(Peer operator, Optional<Peer> before) {}

  private final OperatorRule rule;
  private final Link unlinked;
  private final Consumer<Link> listener;
  private Link link;

  /** Who operated it before, if that was another host. */
  private Optional<Peer> former = Optional.empty();

  private SimTime lastHeard = SimTime.ZERO;
  private boolean released;
  private int rests;
  private SimTime restsSince = SimTime.ZERO;

  /**
   * @param statePort where state lines go unless {@code port} says otherwise
   * @param videoPort where video goes unless {@code port} says otherwise
   * @param listener is told of each other link at once, before anything is sent over it
   */
  public OperatorSession(OperatorRule rule, int statePort, int videoPort, Consumer<Link> listener) {
    this.rule = rule;
    this.listener = listener;
    this.unlinked = new Link(Optional.empty(), statePort, videoPort);
    this.link = unlinked;
  }

  public Link link() {
    return link;
  }

  /** Whether what {@code peer} sends may change anything, now or as the first {@code command}. */
  boolean admits(Peer peer) {
    if (!rule.exclusive()) {
      return true;
    }
    return link.sdkMode() ? isOperator(peer) : rule.accepts(peer.address().getAddress());
  }

  /** Why {@code peer} is not admitted, in plain words that follow "turned away: ". */
  Phrase refusal(Peer peer) {
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

  /** Notes that something came from {@code peer}; the operator is shown as it commanded last. */
  void heard(Peer peer, SimTime now) {
    if (isOperator(peer)) {
      lastHeard = now;
      released = false;
      rests = 0;
      adopt(link.with(peer));
    }
  }

  /**
   * Takes a {@code command}.
   *
   * @param standing whether the drone stands on the ground
   * @return the takeover, if the operator is another one now
   */
  public Optional<Takeover> open(Peer peer, SimTime now, boolean standing) {
    boolean same = isOperator(peer);
    if (same || !rule.accepts(peer.address().getAddress()) || !free(now, standing)) {
      return Optional.empty();
    }
    former = last().filter(lost -> !lost.host().equals(peer.host()));
    adopt(unlinked.with(peer));
    lastHeard = now;
    released = false;
    rests = 0;
    return Optional.of(new Takeover(peer, former));
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

  /** Lets the next sender of {@code command} take over, without disturbing the operator. */
  public void release() {
    released = true;
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
    adopt(link.withPorts(statePort, videoPort));
    rests = 0;
    return true;
  }

  /**
   * Sends no state lines until the operator is heard again, because nobody takes them; but tries
   * once more, for programs that open their port a little later.
   */
  public void restState(SimTime now) {
    if (wantsState(now)) {
      rests++;
      restsSince = now;
    }
  }

  /** Whether state lines are to be sent. */
  public boolean wantsState(SimTime now) {
    boolean remote = link.operator().filter(operator -> !operator.local()).isPresent();
    boolean taken = rests == 0 || (rests == 1 && now.since(restsSince) >= TRIES_AGAIN_AFTER);
    return link.sdkMode() && taken && !(remote && now.since(lastHeard) >= REST_AFTER);
  }

  /** Ends SDK mode, as without power: the drone is free. */
  void close() {
    former = last();
    adopt(unlinked);
    released = false;
    rests = 0;
  }

  private void adopt(Link newLink) {
    if (!newLink.equals(link)) {
      link = newLink;
      listener.accept(link);
    }
  }

  private boolean isOperator(Peer peer) {
    return link.operator().filter(operator -> operator.host().equals(peer.host())).isPresent();
  }
}
