package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.command.Request;
import tellosimulator.sim.LastCommand.Outcome;
import tellosimulator.sim.LastCommand.Shown;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

class LastCommandTest {

  private static final Peer PEER =
      new Peer(
          new InetSocketAddress(InetAddress.getLoopbackAddress(), 9),
          new InetSocketAddress(InetAddress.getLoopbackAddress(), 8));

  private final LastCommand last = new LastCommand();

  @Test
  void aCommandRunsUntilItIsAnswered() {
    assertThat(last.newest()).isEmpty();

    last.event(new SimEvent.CommandReceived(SimTime.ZERO, 2, new Request(1, PEER, "forward 100")));
    assertThat(last.newest())
        .contains(new Shown(2, 1, "forward 100", Outcome.RUNNING, "", Optional.empty()));

    last.event(
        new SimEvent.ReplySent(SimTime.ZERO, 2, new Request(1, PEER, "forward 100"), Reply.OK));
    assertThat(last.newest())
        .contains(new Shown(2, 1, "forward 100", Outcome.DONE, "ok", Optional.empty()));

    last.clear();
    assertThat(last.newest()).isEmpty();
  }

  @Test
  void readsAndSticksDoNotCount() {
    last.event(new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(1, PEER, "battery?")));
    last.event(
        new SimEvent.ReplySent(
            SimTime.ZERO, 1, new Request(1, PEER, "battery?"), Reply.line("90")));
    last.event(new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(2, PEER, "rc 0 0 0 0")));

    assertThat(last.newest()).isEmpty();
  }

  @Test
  void whatWasSentBeforeEndsUnnoticedIfItSucceeds() {
    Phrase reason = Phrase.of("because");
    Shown refused = new Shown(1, 2, "flip f", Outcome.FAILED, "error", Optional.of(reason));
    last.event(new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(1, PEER, "forward 60")));
    last.event(
        new SimEvent.CommandRefused(
            SimTime.ZERO, 1, new Request(2, PEER, "flip f"), Reply.line("error"), reason));

    last.event(
        new SimEvent.ReplySent(SimTime.ZERO, 1, new Request(1, PEER, "forward 60"), Reply.OK));
    assertThat(last.newest()).contains(refused);

    last.event(
        new SimEvent.CommandFailed(
            SimTime.ZERO, 1, new Request(1, PEER, "forward 60"), Reply.OK, reason));
    assertThat(last.newest().map(Shown::text)).contains("forward 60");
  }

  @Test
  void readsAndSticksAreHeard() {
    last.event(new SimEvent.CommandReceived(SimTime.ZERO.plus(1), 1, new Request(1, PEER, "land")));
    assertThat(last.silence(41)).as("sent at 1 s").isEqualTo(40);

    last.event(
        new SimEvent.CommandReceived(SimTime.ZERO.plus(40), 1, new Request(1, PEER, "battery?")));
    assertThat(last.silence(41)).isEqualTo(1);

    last.event(new SimEvent.RunStarted(SimTime.ZERO));
    assertThat(last.silence(0)).isZero();
  }

  @Test
  void whatIsRefusedOrIgnoredFailed() {
    Phrase reason = Phrase.of("because");

    last.event(
        new SimEvent.CommandRefused(
            SimTime.ZERO, 1, new Request(1, PEER, "up 9"), Reply.OUT_OF_RANGE, reason));
    assertThat(last.newest())
        .contains(new Shown(1, 1, "up 9", Outcome.FAILED, "out of range", Optional.of(reason)));

    last.event(new SimEvent.CommandIgnored(SimTime.ZERO, 1, PEER, "up 20", reason));
    assertThat(last.newest())
        .contains(new Shown(1, 0, "up 20", Outcome.FAILED, "", Optional.of(reason)));
  }

  @Test
  void everyDatagramIsHeard() {
    last.onInput(SimTime.ZERO.plus(40), new SimInput.Datagram(1, PEER, new byte[1]));

    assertThat(last.silence(41)).isEqualTo(1);
  }

  @Test
  void readsAndSticksOfTheAppDoNotCount() {
    last.event(new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(1, PEER, "ssid? (app)")));
    last.event(
        new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(2, PEER, "rc 0 9 0 0 (app)")));
    assertThat(last.newest()).isEmpty();

    last.event(new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(3, PEER, "land (app)")));
    assertThat(last.newest().map(Shown::text)).contains("land (app)");
  }
}
