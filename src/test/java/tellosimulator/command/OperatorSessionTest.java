package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.command.HandlerFixture.OPERATOR;
import static tellosimulator.command.HandlerFixture.peer;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.time.SimTime;

class OperatorSessionTest {

  private static final Peer OTHER = peer(9, 40_001);

  private final OperatorSession session = new OperatorSession(8890, 11_111);

  @Test
  void withoutCommandThereIsNoOperator() {
    assertThat(session.link().sdkMode()).isFalse();
    assertThat(session.link().operator()).isEmpty();
  }

  @Test
  void theSenderOfTheFirstCommandIsTheOperator() {
    assertThat(session.open(OPERATOR, at(3))).isTrue();
    assertThat(session.link().sdkMode()).isTrue();
    assertThat(session.link().operator()).contains(OPERATOR);
    assertThat(session.link().statePort()).isEqualTo(8890);
    assertThat(session.link().videoPort()).isEqualTo(11_111);
  }

  @Test
  void theOperatorsSecondCommandChangesNothing() {
    session.open(OPERATOR, at(0));

    assertThat(session.open(OPERATOR, at(100))).isFalse();
    assertThat(session.link().operator()).contains(OPERATOR);
  }

  @Test
  void anotherPortOfTheOperatorsHostIsTheOperatorToo() {
    session.open(OPERATOR, at(0));
    Peer samePc = peer(1, 50_000);

    assertThat(session.open(samePc, at(20))).isFalse();
    session.heard(samePc, at(20));
    assertThat(session.open(OTHER, at(34.9))).isFalse();
    assertThat(session.link().operator()).contains(OPERATOR);
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # silence, takes over
          0,         false
          14.995,    false
          15,        true
          60,        true
          """)
  void anotherHostTakesOverAfter15SecondsOfSilence(double silence, boolean takesOver) {
    session.open(OPERATOR, at(1));
    session.heard(OPERATOR, at(10));

    assertThat(session.open(OTHER, at(10 + silence))).isEqualTo(takesOver);
    assertThat(session.link().operator()).contains(takesOver ? OTHER : OPERATOR);
  }

  @Test
  void whatOthersSendDoesNotKeepTheOperatorInPlace() {
    session.open(OPERATOR, at(0));
    session.heard(OTHER, at(14));

    assertThat(session.open(OTHER, at(15))).isTrue();
  }

  @Test
  void whoTookOverStaysUntilItIsSilent() {
    session.open(OPERATOR, at(0));
    session.open(OTHER, at(15));

    assertThat(session.open(OPERATOR, at(16))).isFalse();
    assertThat(session.link().operator()).contains(OTHER);
    assertThat(session.open(OPERATOR, at(30))).isTrue();
  }

  @Test
  void portsMoveAndWithoutPowerTheyAreAsBefore() {
    session.open(OPERATOR, at(0));

    assertThat(session.setPorts(OPERATOR, 9000, 9001)).isTrue();
    assertThat(session.link().statePort()).isEqualTo(9000);
    assertThat(session.link().videoPort()).isEqualTo(9001);
    assertThat(session.link().operator()).contains(OPERATOR);

    session.close();
    assertThat(session.link().sdkMode()).isFalse();
    assertThat(session.link().statePort()).isEqualTo(8890);
    assertThat(session.link().videoPort()).isEqualTo(11_111);
  }

  @Test
  void onlyTheOperatorMovesThePortsAndTheNextOneFindsThemAsBefore() {
    session.open(OPERATOR, at(0));

    assertThat(session.setPorts(OTHER, 9000, 9001)).isFalse();
    assertThat(session.link().statePort()).isEqualTo(8890);

    session.setPorts(OPERATOR, 9000, 9001);
    session.open(OTHER, at(15));
    assertThat(session.link().statePort()).isEqualTo(8890);
    assertThat(session.link().videoPort()).isEqualTo(11_111);
  }

  @Test
  void withoutPowerTheNextOneIsTheOperatorAtOnce() {
    session.open(OPERATOR, at(100));
    session.close();

    assertThat(session.open(OTHER, at(100))).isTrue();
  }

  private static SimTime at(double seconds) {
    return SimTime.ZERO.plus(seconds);
  }
}
