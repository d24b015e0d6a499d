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
import org.mockito.invocation.Invocation;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/** A handler in SDK mode with a mocked target and recorded replies. */
final class HandlerFixture {

  static final Peer OPERATOR = peer(1, 40_001);

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
        new CommandHandler(
            profile,
            behavior,
            target,
            new CommandHandler.Ends(
                session,
                datagram -> sent.add(new Sent(datagram.peer(), datagram.text())),
                observer));
  }

  /** Returns the handler of a drone that was just switched on, which waits for {@code command}. */
  static HandlerFixture fresh(Profile profile, Behavior behavior) {
    return new HandlerFixture(profile, behavior);
  }

  /** Returns a handler in SDK mode, on the ground. */
  static HandlerFixture grounded(Profile profile, Behavior behavior) {
    HandlerFixture fixture = new HandlerFixture(profile, behavior);
    fixture.session.open(OPERATOR, SimTime.ZERO, true);
    return fixture;
  }

  /** Returns a handler in SDK mode, in flight. */
  static HandlerFixture flying(Profile profile, Behavior behavior) {
    HandlerFixture fixture = grounded(profile, behavior);
    when(fixture.target.flying()).thenReturn(true);
    return fixture;
  }

  HandlerFixture busyWith(String words) {
    when(target.running()).thenReturn(Optional.of(phrase(words)));
    return this;
  }

  /** Returns a phrase that is equal in all languages. */
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

  /** The commands that were carried out. */
  List<String> carriedOut() {
    return calls().stream().map(call -> call.getArgument(0).toString()).toList();
  }

  /** Returns the responder of the last command that was carried out. */
  Responder responder() {
    List<Invocation> calls = calls();
    return calls.get(calls.size() - 1).getArgument(1);
  }

  /** Returns the texts of the replies since the last call, all of them to the operator. */
  List<String> takeReplies() {
    List<String> texts = new ArrayList<>();
    for (Sent reply : sent) {
      texts.add(reply.peer().equals(OPERATOR) ? reply.text() : "to a stranger: " + reply.text());
    }
    sent.clear();
    return texts;
  }

  /** Returns a peer on 127.0.0.{@code host}. */
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

  /** Returns the bytes of a text in UTF-8, each as one character, as they arrive from the wire. */
  static String wire(String text) {
    return new String(text.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
  }

  private List<Invocation> calls() {
    return mockingDetails(target).getInvocations().stream()
        .filter(call -> call.getMethod().getName().equals("carryOut"))
        .toList();
  }
}
