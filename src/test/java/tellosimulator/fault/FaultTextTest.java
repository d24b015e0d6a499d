package tellosimulator.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.fault.Fault.AfterCommand;
import tellosimulator.fault.Fault.AfterTakeoff;
import tellosimulator.fault.Fault.AtOnce;
import tellosimulator.testing.ForPeople;

class FaultTextTest {

  @Test
  void aTextSaysWhatWhereWhenAndHowLong() {
    Fault fault = Fault.of("loss state 20% drone 2 at 5s for 10s");

    assertThat(fault.kind()).isEqualTo(FaultKind.LOSS);
    assertThat(fault.target().directions()).isEqualTo(Set.of(LinkDirection.STATE));
    assertThat(fault.target().drone()).isEqualTo(OptionalInt.of(2));
    assertThat(fault.value(FaultParameter.SHARE)).isEqualTo(0.2);
    assertThat(fault.value(FaultParameter.BURST)).as("usual").isEqualTo(1);
    assertThat(fault.span().begin()).isEqualTo(new AfterTakeoff(5));
    assertThat(fault.span().seconds()).isEqualTo(OptionalDouble.of(10));
  }

  @Test
  void afterNamesACommandAndWhichOfThem() {
    assertThat(Fault.of("cut after \"forward 100\" for 3s").span().begin())
        .isEqualTo(new AfterCommand("forward 100", 1));
    assertThat(Fault.of("cut after 2nd takeoff").span().begin())
        .isEqualTo(new AfterCommand("takeoff", 2));
    assertThat(Fault.of("cut after \"2nd\"").span().begin()).isEqualTo(new AfterCommand("2nd", 1));
  }

  @Test
  void withoutDirectionAndTimeItActsEverywhereAtOnceForEver() {
    Fault fault = Fault.of("cut");

    assertThat(LinkDirection.values()).allMatch(fault::concerns);
    assertThat(fault.concerns(7)).isTrue();
    assertThat(fault.span().begin()).isEqualTo(new AtOnce());
    assertThat(fault.span().seconds()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          loss   20 % state,                   loss state 20%
          loss state share 20,                 loss state 20%
          loss 12.5% burst 3,                  loss 12.5% burst 3
          delay 44 ms replies spread 0.0386 s, delay replies 44ms spread 38.6ms
          delay 2s least 5ms,                  delay 2s least 5ms
          cut for 2 min,                       cut for 120s
          cut at 0s,                           cut at 0s
          cut replies commands drone 3,        cut commands replies drone 3
          cut after 'battery?',                cut after "'battery?'"
          bandwidth 64 kbit/s,                 bandwidth 64kbit/s
          overheat 95.5 C,                     overheat 95.5C
          yaw-drift turn 2,                    yaw-drift 2deg/s
          weak-takeoff 20 cm,                  weak-takeoff 20cm
          no-valid-imu 5 cm/s for 3s,          no-valid-imu 5cm/s for 3s
          reorder state 10% time 1.2s,         reorder state 10% time 1.2s
          cut after 12th go for 100ms,         cut after 12th "go" for 100ms
          """)
  void whatIsWrittenIsReadAsTheSame(String written, String usual) {
    Fault fault = Fault.of(written);

    assertThat(fault.text()).isEqualTo(usual);
    assertThat(Fault.of(usual)).isEqualTo(fault);
  }

  @ParameterizedTest
  @EnumSource(FaultKind.class)
  void eachKindIsReadFromItsWordAlone(FaultKind kind) {
    Fault fault = Fault.of(kind.word());

    assertThat(fault.kind()).isEqualTo(kind);
    assertThat(Fault.of(fault.text())).isEqualTo(fault);
    assertThat(kind.words()).endsWith(".");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          lost 20%              | there is no "lost", did you mean loss?
          xyz                   | expected one of bandwidth, baro-jump, conn-ack-lost,
          loss stat             | loss has no "stat", did you mean state?
          loss wobble           | loss has no "wobble", but only commands, replies, state, video, share, burst, drone, at, after, for
          loss 120%             | share is 120%, but must be from 0% to 100%
          loss 20ms             | share is a number in %, but "20ms" was found
          cut 20%               | cut has no value, but "20%" was found
          cut burst             | cut has no "burst"
          loss 20% 30%          | share is there twice
          loss state state      | state is there twice
          loss at               | at needs something after it, such as 5s
          loss at soon          | at needs a time such as 5s, of at most a day, but "soon" was found
          loss for 0s           | for needs a time such as 5s
          loss at 5s after up   | after does not go with at
          loss drone 0          | drone needs a number from 1 to 1000, but "0" was found
          loss drone x          | drone needs a number from 1 to 1000, but "x" was found
          loss after ""         | after needs what a command begins with, of at most 100 letters
          loss "state"          | loss has no "state", did you mean state?
          delay 3ms least 5ms   | the delay must be from its least to its most
          """)
  void aMistakeIsASentenceThatNamesIt(String written, String sentence) {
    assertThatThrownBy(() -> Fault.of(written))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(sentence)
        .satisfies(e -> ForPeople.check(e.getMessage()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " ", "\t", "\"", "\"\"", "loss \"", "\0", "loss \0", "-1", "loss -1"})
  void whateverIsGivenTheAnswerIsForPeople(String written) {
    if (!written.equals("loss \"")) { // an open quotation mark is ignored
      assertThatThrownBy(() -> Fault.of(written))
          .isInstanceOf(FaultTextException.class)
          .satisfies(e -> ForPeople.check(e.getMessage()))
          .satisfies(e -> assertThat(e.getMessage().chars()).allMatch(c -> c >= ' '));
    }
  }

  @ParameterizedTest
  @EnumSource(LinkPreset.class)
  void presetsAreFaultsThatActAllTheTime(LinkPreset preset) {
    assertThat(preset.faults()).allMatch(fault -> fault.span().equals(Fault.Span.ALWAYS));
    assertThat(LinkPreset.of(preset.option())).isEqualTo(preset);
    assertThat(Optional.of(preset.faults()).filter(faults -> !faults.isEmpty()).isPresent())
        .isEqualTo(preset != LinkPreset.IDEAL);
  }

  @Test
  void aMisspeltPresetIsNamedWithTheNearestOne() {
    assertThatThrownBy(() -> LinkPreset.of("clasroom"))
        .hasMessage("there is no \"clasroom\", did you mean classroom?");
  }
}
