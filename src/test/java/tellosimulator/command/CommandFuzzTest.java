package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.controller.FlightEvent;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/** A million texts of all kinds: each is ignored, or carried out once, or answered once. */
@Tag("slow")
class CommandFuzzTest {

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          EDU,   REPORT,   1, 400000
          TELLO, MEASURED, 2, 200000
          TT,    MEASURED, 3, 400000
          """)
  void whateverArrivesHasExactlyOneConsequence(
      Profile profile, Behavior behavior, long seed, int texts) {
    CountingTarget target = new CountingTarget();
    Counts counts = new Counts();
    OperatorSession session = new OperatorSession(OperatorRule.FIRST, 8890, 11_111, link -> {});
    session.open(HandlerFixture.OPERATOR, SimTime.ZERO, true);
    CommandHandler handler =
        new CommandHandler(
            profile,
            behavior,
            target,
            new CommandHandler.Ends(session, datagram -> counts.sent++, counts));
    GarbageSource garbage = new GarbageSource(seed);
    List<Peer> peers = List.of(HandlerFixture.OPERATOR, HandlerFixture.peer(2, 1));
    Random random = new Random(seed);

    for (int i = 0; i < texts; i++) {
      String text = garbage.next();
      target.running = random.nextBoolean() ? Optional.of(Phrase.of("`up 50`")) : Optional.empty();
      target.flying = random.nextBoolean();
      int consequences = counts.consequences() + target.carriedOut;
      int answers = counts.refused + counts.replied;
      int sent = counts.sent;

      handler.handle(peers.get(random.nextInt(peers.size())), text, new SimTime(i));

      consequences = counts.consequences() + target.carriedOut - consequences;
      answers = counts.refused + counts.replied - answers;
      sent = counts.sent - sent;
      boolean once = consequences == 1 && sent == answers && sent <= 1;
      boolean copy = consequences == 0 && sent <= 1 && mayBeCopy(profile, text);
      if (!once && !copy) {
        fail("`%s` had %d consequences, %d answers", WireText.printable(text), consequences, sent);
      }
    }

    assertThat(target.carriedOut).as("some of it was meant").isGreaterThan(texts / 100);
    assertThat(counts.refused).as("most of it was not").isGreaterThan(texts / 10);
    assertThat(counts.sent).isGreaterThanOrEqualTo(counts.refused);
    assertThat(session.link().sdkMode()).isTrue();
  }

  /** Returns whether a text may be a copy, which only repeats the reply to the original. */
  private static boolean mayBeCopy(Profile profile, String text) {
    return profile.hasPads() && text.startsWith("Re") && text.length() >= 7;
  }

  private static final class Counts implements CommandObserver {
    private int ignored;
    private int refused;
    private int replied;
    private int sent;

    int consequences() {
      return ignored + refused;
    }

    @Override
    public void happened(FlightEvent event) {}

    @Override
    public void operatorChanged(OperatorSession.Takeover takeover, OperatorEndpoint link) {}

    @Override
    public void received(Request request) {}

    @Override
    public void ignored(Peer peer, String text, Phrase reason) {
      ignored++;
    }

    @Override
    public void turnedAway(Peer peer, String text, Phrase reason) {
      ignored++;
    }

    @Override
    public void replied(Request request, Reply reply) {
      replied++;
    }

    @Override
    public void failed(Request request, Reply reply, Phrase reason) {
      throw new AssertionError("nothing was begun that could fail: " + reason);
    }

    @Override
    public void refused(Request request, Reply reply, Phrase reason) {
      refused++;
      if (reason.english().isBlank()) {
        throw new AssertionError("no reason for " + reply);
      }
    }
  }
}
