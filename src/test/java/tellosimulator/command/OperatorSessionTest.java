package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.command.HandlerFixture.OPERATOR;
import static tellosimulator.command.HandlerFixture.peer;
import static tellosimulator.testing.SteppedDrone.address;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.command.OperatorSession.Takeover;
import tellosimulator.time.SimTime;

class OperatorSessionTest {

  private static final Peer OTHER = peer(9, 40_001);
  private static final Optional<Peer> NO_OPERATOR = Optional.empty();

  private final List<OperatorEndpoint> links = new ArrayList<>();
  private final OperatorSession session = session(OperatorRule.FIRST);

  private OperatorSession session(OperatorRule rule) {
    return new OperatorSession(rule, 8890, 11_111, links::add);
  }

  @Test
  void withoutCommandThereIsNoOperator() {
    assertThat(session.link().sdkMode()).isFalse();
    assertThat(session.link().operator()).isEmpty();
    assertThat(session.wantsState(at(0))).isFalse();
    assertThat(session.admits(OTHER)).isTrue();
  }

  @Test
  void theSenderOfTheFirstCommandIsTheOperator() {
    assertThat(session.open(OPERATOR, at(3), true)).contains(new Takeover(OPERATOR, NO_OPERATOR));
    assertThat(session.link()).isEqualTo(OperatorEndpoint.raw(Optional.of(OPERATOR), 8890, 11_111));
    assertThat(links).containsExactly(session.link());
    assertThat(session.wantsState(at(3))).isTrue();
    assertThat(session.admits(OPERATOR)).isTrue();
    assertThat(session.admits(OTHER)).isFalse();
    assertThat(session.refusal(OTHER).english())
        .isEqualTo(
            "the drone is operated by 127.0.0.1 until it is released or, on the ground, 127.0.0.1 is silent for 60 s");
  }

  @Test
  void theOperatorsSecondCommandChangesNothing() {
    session.open(OPERATOR, at(0), true);

    assertThat(session.open(OPERATOR, at(100), true)).isEmpty();
    assertThat(session.link().operator()).contains(OPERATOR);
    assertThat(links).hasSize(1);
  }

  @Test
  void aProgramThatIsRestartedGoesOnFromAnotherPort() {
    session.open(OPERATOR, at(0), true);
    Peer restarted = peer(1, 50_000);

    assertThat(session.admits(restarted)).isTrue();
    session.heard(restarted, at(50));

    assertThat(session.link().operator()).contains(restarted);
    assertThat(session.open(OTHER, at(109.9), true)).isEmpty();
    assertThat(session.link().operator()).contains(restarted);
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # silence, stands, takes over
          0,         true,  false
          59.995,    true,  false
          60,        true,  true
          60,        false, false
          600,       false, false
          """)
  void anotherHostTakesOverAfterAMinuteOfSilenceOnTheGround(
      double silence, boolean standing, boolean takesOver) {
    session.open(OPERATOR, at(1), true);
    session.heard(OPERATOR, at(10));

    assertThat(session.open(OTHER, at(10 + silence), standing))
        .isEqualTo(
            takesOver ? Optional.of(new Takeover(OTHER, Optional.of(OPERATOR))) : Optional.empty());
    assertThat(session.link().operator()).contains(takesOver ? OTHER : OPERATOR);
  }

  @ParameterizedTest
  @CsvSource({"14.995, false", "15, true"})
  void whereAnyoneSteersStateGoesElsewhereAfter15Seconds(double silence, boolean takesOver) {
    OperatorSession open = session(OperatorRule.ANYONE);
    open.open(OPERATOR, at(0), true);

    assertThat(open.admits(OTHER)).isTrue();
    assertThat(open.open(OTHER, at(silence), false).isPresent()).isEqualTo(takesOver);
  }

  @Test
  void oneHostAlone() {
    OperatorSession alone = session(OperatorRule.only(OTHER.address().getAddress()));

    assertThat(alone.admits(OPERATOR)).isFalse();
    assertThat(alone.open(OPERATOR, at(0), true)).isEmpty();
    assertThat(alone.refusal(OPERATOR).english())
        .isEqualTo("--operator lets only 127.0.0.9 operate the drone");
    assertThat(alone.admits(OTHER)).isTrue();
    assertThat(alone.open(OTHER, at(0), true)).isPresent();
    assertThat(alone.open(OPERATOR, at(1000), true)).isEmpty();
  }

  @Test
  void whatOthersSendDoesNotKeepTheOperatorInPlace() {
    session.open(OPERATOR, at(0), true);
    session.heard(OTHER, at(59));

    assertThat(session.open(OTHER, at(60), true)).isPresent();
  }

  @Test
  void releasedItIsWhoseCommandComesFirst() {
    session.open(OPERATOR, at(0), true);
    session.release();

    assertThat(session.open(OTHER, at(1), false)).isPresent();

    session.release();
    session.heard(OTHER, at(2));
    assertThat(session.open(OPERATOR, at(3), false)).isEmpty();
  }

  @Test
  void portsMoveAndWithoutPowerTheyAreAsBefore() {
    session.open(OPERATOR, at(0), true);

    assertThat(session.setPorts(OPERATOR, 9000, 9001)).isTrue();
    assertThat(session.link()).isEqualTo(OperatorEndpoint.raw(Optional.of(OPERATOR), 9000, 9001));

    session.close();
    assertThat(session.link()).isEqualTo(OperatorEndpoint.raw(NO_OPERATOR, 8890, 11_111));
    assertThat(links).last().isEqualTo(session.link());
  }

  @Test
  void onlyTheOperatorMovesThePortsAndTheNextOneFindsThemAsBefore() {
    session.open(OPERATOR, at(0), true);

    assertThat(session.setPorts(OTHER, 9000, 9001)).isFalse();
    assertThat(session.link().statePort()).isEqualTo(8890);

    session.setPorts(OPERATOR, 9000, 9001);
    session.open(OTHER, at(60), true);
    assertThat(session.link()).isEqualTo(OperatorEndpoint.raw(Optional.of(OTHER), 8890, 11_111));
  }

  @Test
  void withoutPowerTheNextOneIsTheOperatorAtOnce() {
    session.open(OPERATOR, at(100), true);
    session.close();

    assertThat(session.open(OTHER, at(100), true))
        .contains(new Takeover(OTHER, Optional.of(OPERATOR)));
  }

  @Test
  void nobodyHasLostADroneThatGoesBackToItsOperator() {
    session.open(OPERATOR, at(100), true);
    session.close();

    assertThat(session.open(OPERATOR, at(100), true)).contains(new Takeover(OPERATOR, NO_OPERATOR));
  }

  @Test
  void stateThatNobodyTakesRestsUntilTheOperatorIsHeard() {
    session.open(OPERATOR, at(0), true);
    session.restState(at(0.1));

    assertThat(session.wantsState(at(2))).isFalse();
    session.heard(OTHER, at(2));
    assertThat(session.wantsState(at(2))).isFalse();
    session.heard(OPERATOR, at(2));
    assertThat(session.wantsState(at(2))).isTrue();
  }

  @Test
  void whoOpensThePortForStateLaterIsFoundByOneMoreTry() {
    session.open(OPERATOR, at(0), true);
    session.restState(at(0.1));
    session.restState(at(0.1));

    assertThat(session.wantsState(at(2.2))).isTrue();
    session.restState(at(2.3));
    assertThat(session.wantsState(at(100))).isFalse();
  }

  @Test
  void stateRestsAfterTwoSilentMinutesButNotOnLoopback() {
    Peer remote =
        new Peer(address("192.168.1.7", 40_000), new InetSocketAddress("192.168.1.2", 8879));
    session.open(remote, at(0), true);
    OperatorSession loopback = session(OperatorRule.FIRST);
    loopback.open(OPERATOR, at(0), true);

    assertThat(session.wantsState(at(119.9))).isTrue();
    assertThat(session.wantsState(at(120))).isFalse();
    assertThat(loopback.wantsState(at(100_000))).isTrue();
    session.heard(remote, at(500));
    assertThat(session.wantsState(at(500))).isTrue();
  }

  private static SimTime at(double seconds) {
    return SimTime.ZERO.plus(seconds);
  }
}
