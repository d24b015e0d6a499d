package tellosimulator.command;

import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.mockingDetails;
import static org.mockito.Mockito.when;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mockito.invocation.Invocation;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/** A handler in SDK mode whose target is mocked and whose replies are kept. */
final class HandlerFixture {

  static final Peer OPERATOR = peer(1, 40_001);

  /** What a target is asked or told besides the commands themselves. */
  private static final Set<String> NO_COMMANDS =
      Set.of("running", "flying", "notFlying", "unactivated", "linkAlive", "commandArrived");

  /** A reply that went out. */
  record Sent(Peer peer, String text) {}

  final CommandTarget target = mock(CommandTarget.class);
  final CommandObserver observer = mock(CommandObserver.class);
  final OperatorSession session = new OperatorSession(OperatorRule.FIRST, 8890, 11_111, link -> {});
  final List<Sent> sent = new ArrayList<>();
  final CommandHandler handler;
  SimTime now = SimTime.ZERO;

  private HandlerFixture(Profile profile, Behavior behavior) {
    handler =
        CommandHandler.of(profile, behavior)
            .target(target)
            .session(session)
            .replies((peer, text) -> sent.add(new Sent(peer, text)))
            .observer(observer)
            .build();
  }

  /** A drone that just got its power: it waits for {@code command}. */
  static HandlerFixture fresh(Profile profile, Behavior behavior) {
    return new HandlerFixture(profile, behavior);
  }

  /** In SDK mode, on the ground. */
  static HandlerFixture grounded(Profile profile, Behavior behavior) {
    HandlerFixture fixture = new HandlerFixture(profile, behavior);
    fixture.session.open(OPERATOR, SimTime.ZERO, true);
    return fixture;
  }

  /** In SDK mode, flying. */
  static HandlerFixture flying(Profile profile, Behavior behavior) {
    HandlerFixture fixture = grounded(profile, behavior);
    when(fixture.target.flying()).thenReturn(true);
    return fixture;
  }

  HandlerFixture busyWith(String words) {
    when(target.running()).thenReturn(Optional.of(phrase(words)));
    return this;
  }

  /** Words that are the same in all languages. */
  static Phrase phrase(String words) {
    return Phrase.of("%s", words);
  }

  void handle(String datagram) {
    handle(OPERATOR, datagram);
  }

  void handle(Peer peer, String datagram) {
    handler.handle(peer, datagram, now);
  }

  /** Lets time pass. */
  void after(double seconds) {
    now = now.plus(seconds);
  }

  /** The commands that were carried out: name of the target's method, then the record. */
  List<String> carriedOut() {
    return calls().stream().map(call -> call.getMethod().getName() + " " + record(call)).toList();
  }

  /** What came with the last command that was carried out. */
  Responder responder() {
    List<Invocation> calls = calls();
    return calls.get(calls.size() - 1).getArgument(1);
  }

  /** The texts of the replies since this was asked last, all of them to the operator. */
  List<String> takeReplies() {
    List<String> texts = new ArrayList<>();
    for (Sent reply : sent) {
      texts.add(reply.peer().equals(OPERATOR) ? reply.text() : "to a stranger: " + reply.text());
    }
    sent.clear();
    return texts;
  }

  /** A peer on 127.0.0.{@code host}. */
  static Peer peer(int host, int port) {
    try {
      InetAddress address = InetAddress.getByAddress(new byte[] {127, 0, 0, (byte) host});
      return new Peer(
          new InetSocketAddress(address, port),
          new InetSocketAddress(InetAddress.getLoopbackAddress(), 8889));
    } catch (java.net.UnknownHostException e) {
      throw new IllegalStateException(e);
    }
  }

  /** The bytes of a text in UTF-8, each as one character, as they come from the wire. */
  static String wire(String text) {
    return new String(text.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
  }

  private List<Invocation> calls() {
    return mockingDetails(target).getInvocations().stream()
        .filter(call -> !NO_COMMANDS.contains(call.getMethod().getName()))
        .toList();
  }

  private static String record(Invocation call) {
    return call.getArgument(0).toString();
  }
}
