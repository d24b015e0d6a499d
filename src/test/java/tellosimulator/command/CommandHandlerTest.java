package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.argThat;
import static org.mockito.ArgumentMatchers.eq;
import static org.mockito.Mockito.never;
import static org.mockito.Mockito.verify;
import static tellosimulator.command.HandlerFixture.OPERATOR;
import static tellosimulator.command.HandlerFixture.peer;
import static tellosimulator.command.HandlerFixture.wire;
import static tellosimulator.profile.Behavior.MEASURED;
import static tellosimulator.profile.Behavior.REPORT;
import static tellosimulator.profile.Profile.EDU;
import static tellosimulator.profile.Profile.TELLO;
import static tellosimulator.profile.Profile.TT;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.words.Phrase;

/** The handling of texts that are not commands, and the order of the checks of all others. */
class CommandHandlerTest {

  private static final String UNKNOWN = "unknown command: ";

  // --- before `command` ---

  @ParameterizedTest
  @ValueSource(
      strings = {
        "takeoff",
        "battery?",
        "emergency",
        "rc 0 0 0 0",
        "Command",
        "command?",
        "",
        "foo"
      })
  void beforeCommandEverythingIsIgnored(String text) {
    HandlerFixture drone = HandlerFixture.fresh(EDU, REPORT);

    drone.handle(text);

    assertThat(drone.carriedOut()).isEmpty();
    assertThat(drone.takeReplies()).isEmpty();
    verify(drone.observer).ignored(eq(OPERATOR), eq(text), any(Phrase.class));
    verify(drone.target, never()).linkAlive();
  }

  @ParameterizedTest
  @ValueSource(strings = {"command", "command\\r\\n", "command\\s", "Re0101\\scommand"})
  void commandIsTheFirstThatIsCarriedOut(String escaped) {
    HandlerFixture drone = HandlerFixture.fresh(EDU, REPORT);

    drone.handle(escaped.translateEscapes());

    assertThat(drone.carriedOut()).containsExactly("EnterSdkMode[]");
  }

  @Test
  void withoutPowerSdkModeIsForgotten() {
    HandlerFixture drone = HandlerFixture.grounded(EDU, REPORT);

    drone.session.close();
    drone.handle("battery?");

    assertThat(drone.carriedOut()).isEmpty();
    assertThat(drone.takeReplies()).isEmpty();
  }

  // --- syntax ---

  /** Two simulators whose ports point at each other would answer each other forever. */
  @Test
  void anEchoOfAnotherDroneIsNotEchoed() {
    HandlerFixture drone = HandlerFixture.flying(Profile.EDU, Behavior.REPORT);

    drone.handle("unknown command: mid:-2;x:-200;");

    assertThat(drone.takeReplies()).isEmpty();
    verify(drone.observer).ignored(any(), any(), saying("own reply"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      ignoreLeadingAndTrailingWhitespace = false,
      textBlock =
          """
           land|it begins with a blank
          Land|this command is written `land`
          ext tof?|there is no such command
          motoron|this drone does not know it, it came with SDK 3.0
          fly|there is no such command
          forward|expected `forward x`
          Command|this command is written `command`
          foward 50|there is no such command, did you mean `forward 50`?
          forward100|there is no such command, did you mean `forward 100`?
          Foward-5 x|there is no such command, did you mean `forward -5 x`?
          battery|there is no such command, did you mean `battery?`?
          take off|there is no such command
          cw90|there is no such command, did you mean `cw 90`?
          xyzzy 1 2|there is no such command
          """)
  void anUnknownCommandIsExplained(String text, String reason) {
    HandlerFixture drone = HandlerFixture.flying(Profile.EDU, Behavior.REPORT);

    drone.handle(text);

    verify(drone.observer).refused(request(text), any(), saying(reason));
  }

  /** The lone `x` of the guide would be mistaken for a coordinate. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          up 600          | the distance is 600, but must be from 20 to 500 cm
          back 19         | the distance is 19, but must be from 20 to 500 cm
          speed 101       | the speed is 101, but must be from 10 to 100 cm/s
          flip x          | the direction is x, but must be one of b, back, f
          go 501 0 0 50   | x is 501, but must be from -500 to 500 cm
          go 50 0 -501 50 | z is -501, but must be from -500 to 500 cm
          go 50 0 0 101   | the speed is 101, but must be from 10 to 100 cm/s
          curve 50 50 0 100 0 0 61 | the speed is 61, but must be from 10 to 60 cm/s
          mdirection 3    | the direction is 3, but must be from 0 to 2
          mdirection 0.5  | the direction is 0.5, but must be a whole number
          wifisetchannel 15 | the channel is 15, but must be from 1 to 14
          setfps most     | the frame rate is most, but must be one of high, middle, low
          setbitrate 6    | the bit rate is 6, but must be from 0 to 5
          setresolution 5 | the resolution is 5, but must be one of high, low
          downvision 2    | the camera is 2, but must be from 0 to 1
          EXT mled sl 256 | the brightness is 256, but must be from 0 to 255
          """)
  void aValueOutOfRangeIsCalledWhatItIs(String text, String reason) {
    HandlerFixture drone = HandlerFixture.flying(Profile.TT, Behavior.REPORT);

    drone.handle(text);

    verify(drone.observer).refused(request(text), any(), saying(reason));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      nullValues = "-",
      textBlock =
          """
          takeoff\\r            | takeoff
          takeoff\\n            | takeoff
          takeoff\\r\\n         | takeoff
          takeoff\\r\\n\\r\\n   | takeoff
          takeoff\\0            | takeoff
          takeoff\\0\\0\\r\\n\\0 | takeoff
          takeoff\\s            | takeoff
          takeoff\\s\\r\\n      | takeoff
          takeoff\\r\\n\\s\\r   | takeoff
          takeoff\\s\\s         | -
          takeoff\\s\\r\\s      | -
          takeoff\\t            | -
          \\stakeoff            | -
          \\ntakeoff            | -
          take\\0off            | -
          """)
  void lineEndsNulsAndOneBlankAtTheEndAreDropped(String escaped, String method) {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle(escaped.strip().translateEscapes());

    if (method == null) {
      assertThat(drone.carriedOut()).isEmpty();
      assertThat(drone.takeReplies()).hasSize(1).allMatch(reply -> reply.startsWith(UNKNOWN));
    } else {
      assertThat(drone.carriedOut()).containsExactly("Takeoff[]");
      assertThat(drone.takeReplies()).isEmpty();
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          takeoff\\s\\s            | takeoff\\s
          takeoff\\s\\r\\s\\n      | takeoff\\s
          takeof\\r\\n             | takeof
          \\stakeoff               | \\stakeoff
          \\0                      | ''
          \\r\\n                   | ''
          \\s                      | ''
          \\s\\s                   | \\s
          \\1\\2\\177\\r           | \\1\\2\\177
          """)
  void whatIsDroppedIsNotEchoed(String escaped, String echoEscaped) {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle(escaped.strip().translateEscapes());

    assertThat(drone.takeReplies())
        .containsExactly(UNKNOWN + echoEscaped.strip().translateEscapes());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Takeoff",
        "TAKEOFF",
        "takeOff",
        "Battery?",
        "takeofff",
        "takeof",
        "take off",
        "takeoff now",
        "forward",
        "forward 50 50",
        "forward  50",
        "forward 50  x",
        "forward\t50",
        "forward,50",
        "cw",
        "rc 0 0 0",
        "rc 0 0 0 0 0",
        "rc 0 0  0",
        "rc 0,0,0,0",
        "rc a b c d",
        "go 100 0 0",
        "curve 1 2 3 4 5 6",
        "flip",
        "speed",
        "speed?x",
        "speed ?",
        "battery",
        "wifi ssid",
        "ap ssid",
        "mon 1",
        "mdirection",
        "mdirection  ",
        "flip  ",
        "wifi  password",
        "wifi ssid  ",
        "?",
        "Re",
        "\u00ff\u00fe\u0080",
        "{\"command\": \"takeoff\"}"
      })
  void whatIsNoCommandIsEchoedInFull(String text) {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle(text);

    // One blank at the end is dropped before everything else; of two blanks, one remains.
    String echo = text.endsWith(" ") ? text.substring(0, text.length() - 1) : text;
    assertThat(drone.takeReplies()).containsExactly(UNKNOWN + echo);
    assertThat(drone.carriedOut()).isEmpty();
    verify(drone.observer, never()).replied(any(), any());
    verify(drone.observer).refused(request(echo), eq(new Reply(UNKNOWN + echo)), any(Phrase.class));
  }

  @Test
  void anEmptyDatagramIsUnknown() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("");

    assertThat(drone.takeReplies()).containsExactly(UNKNOWN);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "NaN",
        "nan",
        "Infinity",
        "-Infinity",
        "inf",
        "1e309",
        "1e2",
        "1E2",
        "0x10",
        "0x1p3",
        "+5",
        "+50",
        ".5",
        "5.",
        "50.",
        "-",
        "--50",
        "-.5",
        "5.0.0",
        "50f",
        "50d",
        "50L",
        "1_000",
        "50,5",
        "٥٠",
        "５０",
        "۵۰",
        "½",
        "50\u00a0",
        "1234567890123456",
        "0000000000000050",
        "50.0000000000000"
      })
  void whatIsNoPlainNumberMakesTheCommandUnknown(String number) {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    String word = wire(number);
    List<String> texts =
        List.of(
            "forward " + word,
            "cw " + word,
            "speed " + word,
            "rc 0 0 0 " + word,
            "rc " + word + " 0 0 0",
            "go 100 " + word + " 0 50",
            "curve 25 -25 0 25 -75 0 " + word);

    texts.forEach(drone::handle);

    assertThat(drone.takeReplies())
        .containsExactlyElementsOf(texts.stream().map(text -> UNKNOWN + text).toList());
    assertThat(drone.carriedOut()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          50,              0.5
          50.0,            0.5
          050,             0.5
          35.234234,       0.35234234000000003
          20.000000000000, 0.2
          000000000000050, 0.5
          499.99999999999, 4.9999999999999
          """)
  void plainNumbersOfUpTo15CharactersAreTaken(String number, double meters) {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("forward " + number);

    assertThat(number).hasSizeLessThanOrEqualTo(15);
    assertThat(drone.carriedOut())
        .containsExactly("Move[direction=FORWARD, distance=" + meters + "]");
  }

  // --- length ---

  @Test
  void aDatagramOf1024BytesMayStillBeACommand() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    String text = "wifi name " + "p".repeat(1024 - "wifi name ".length());

    drone.handle(text);

    assertThat(text).hasSize(1024);
    assertThat(drone.carriedOut()).containsExactly("SetNetwork[done=Reply[text=ok]]");
  }

  @ParameterizedTest
  @ValueSource(ints = {1025, 1031, 1500, 2048, 60_000})
  void aLongerDatagramIsUnknownAndItsEchoIsCut(int length) {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    String text = "wifi name " + "p".repeat(length - "wifi name ".length());

    drone.handle(text);

    assertThat(drone.takeReplies()).containsExactly(UNKNOWN + text.substring(0, 1024));
    assertThat(drone.carriedOut()).isEmpty();
  }

  @Test
  void lineEndsBeyond1024BytesMakeACommandTooLong() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    String text = "takeoff" + "\r\n".repeat(600);

    drone.handle(text);

    assertThat(drone.takeReplies()).containsExactly(UNKNOWN + text.substring(0, 1024));
    assertThat(drone.carriedOut()).isEmpty();
  }

  @Test
  void nulBytesFillingADatagramAreAnEmptyCommand() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("\0".repeat(1000));

    assertThat(drone.takeReplies()).containsExactly(UNKNOWN);
  }

  // --- echo ---

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          EDU,   REPORT,   setbitrate 2,   setbitrate 2
          EDU,   MEASURED, setbitrate 2,   setbitrate 2
          TELLO, REPORT,   setbitrate 2,   setbitrate 2
          TELLO, MEASURED, setbitrate 2,   setbitrate
          TELLO, MEASURED, mon,            mon
          TELLO, MEASURED, Re0101 takeoff, Re0101
          TELLO, MEASURED, ' takeoff',     ''
          TT,    MEASURED, foo bar,        foo bar
          """)
  void onlyTheMeasuredWhiteTelloEchoesTheFirstWord(
      Profile profile, Behavior behavior, String text, String echo) {
    HandlerFixture drone = HandlerFixture.flying(profile, behavior);

    drone.handle(text);

    assertThat(drone.takeReplies()).containsExactly(UNKNOWN + echo);
  }

  @Test
  void aFirstWordThatIsTooLongIsCutAsWell() {
    HandlerFixture drone = HandlerFixture.flying(TELLO, MEASURED);

    drone.handle("x".repeat(3000) + " 1");

    assertThat(drone.takeReplies()).containsExactly(UNKNOWN + "x".repeat(1024));
  }

  // --- the order of checks: syntax, busy, range, motors ---

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # text,          busy,  flying, reply
          forward,         true,  true,   unknown command: forward
          forward x,       true,  false,  unknown command: forward x
          Forward 50,      true,  true,   unknown command: Forward 50
          forward 5,       true,  true,   error Not joystick
          forward 5,       true,  false,  error Not joystick
          forward 5,       false, false,  out of range
          forward 5,       false, true,   out of range
          forward 50,      true,  false,  error Not joystick
          forward 50,      false, false,  error Motor stop
          go 0 0 0 50,     true,  true,   error Not joystick
          go 0 0 0 50,     false, false,  out of range
          go 100 0 0 50,   false, false,  error Motor stop
          flip x,          true,  true,   error Not joystick
          flip x,          false, false,  out of range
          flip l,          false, false,  error Motor stop
          speed 5,         true,  true,   error Not joystick
          speed 5,         false, true,   error
          rc 0 0 0 101,    true,  true,   out of range
          rc 0 0 0,        true,  true,   unknown command: rc 0 0 0
          mdirection 3,    true,  true,   error Not joystick
          mdirection 3,    false, true,   error
          go 0 0 0 50 m9,  true,  true,   error Not joystick
          go 0 0 0 50 m9,  false, true,   out of range
          land,            true,  true,   error Not joystick
          land,            false, false,  error Motor stop
          cw 90,           false, false,  error Motor stop
          """)
  void formIsCheckedFirstThenBusyThenRangeThenMotors(
      String text, boolean busy, boolean flying, String reply) {
    HandlerFixture drone =
        flying ? HandlerFixture.flying(EDU, REPORT) : HandlerFixture.grounded(EDU, REPORT);
    if (busy) {
      drone.busyWith("`up 100` is still running");
    }

    drone.handle(text);

    assertThat(drone.takeReplies()).containsExactly(reply);
    assertThat(drone.carriedOut()).isEmpty();
  }

  @Test
  void aRefusalWhileBusySaysWhatIsRunning() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT).busyWith("`up 100` is still running");

    drone.handle("cw 90");

    verify(drone.observer)
        .refused(
            new Request(1, OPERATOR, "cw 90"),
            Reply.NOT_JOYSTICK,
            HandlerFixture.phrase("`up 100` is still running"));
  }

  @Test
  void everyDatagramShowsThatTheLinkIsAliveButOnlyKnownCommandsEndASafetyLanding() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("foo");
    verify(drone.target).linkAlive();
    verify(drone.target, never()).commandArrived();

    drone.handle("forward 5");
    verify(drone.target).commandArrived();
    assertThat(drone.takeReplies()).containsExactly(UNKNOWN + "foo", "out of range");
  }

  // --- replies ---

  @Test
  void anAnswerGoesToTheSenderOfTheCommandOnly() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    Peer restarted = peer(1, 50_000);

    drone.handle(restarted, "forward 50");
    drone.after(2);
    drone.responder().reply(Reply.OK);
    drone.after(0);

    assertThat(drone.sent).containsExactly(new HandlerFixture.Sent(restarted, "ok"));
    verify(drone.observer).received(new Request(1, restarted, "forward 50"));
    verify(drone.observer).replied(new Request(1, restarted, "forward 50"), Reply.OK);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "takeoff",
        "land",
        "emergency",
        "stop",
        "rc 0 0 0 0",
        "forward 50",
        "flip l",
        "speed 50",
        "streamon",
        "streamoff",
        "mon",
        "ap a b",
        "wifi a b",
        "port 9000 9001",
        "keepalive",
        "EXT led 1 2 3",
        "foo",
        "",
        "forward",
        "battery? ?"
      })
  void ofAnotherHostNothingHasAnEffectOrAnAnswer(String text) {
    HandlerFixture drone = HandlerFixture.flying(Profile.TT, REPORT);
    Peer stranger = peer(3, 50_000);

    drone.handle(stranger, text);
    drone.after(1);

    assertThat(drone.carriedOut()).isEmpty();
    assertThat(drone.sent).isEmpty();
    verify(drone.observer)
        .turnedAway(
            eq(stranger),
            eq(text),
            argThat(
                reason -> reason.english().startsWith("the drone is operated by 127.0.0.1 until")));
    verify(drone.target, never()).linkAlive();
    verify(drone.target, never()).commandArrived();
  }

  @ParameterizedTest
  @ValueSource(strings = {"battery?", "sn?", "EXT tof?", "Re0101 height?", "command"})
  void everyHostMayReadWithoutKeepingTheDroneInTheAir(String text) {
    HandlerFixture drone = HandlerFixture.flying(Profile.TT, REPORT);

    drone.handle(peer(3, 50_000), text);

    assertThat(drone.carriedOut()).hasSize(1);
    verify(drone.target, never()).linkAlive();
    verify(drone.target, never()).commandArrived();
  }

  @Test
  void aCommandMayBeAnsweredTwice() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("stop");
    drone.responder().reply(Reply.OK);
    drone.after(1);
    drone.responder().reply(Reply.FORCED_STOP);
    drone.after(0);

    assertThat(drone.takeReplies()).containsExactly("ok", "forced stop");
  }

  @Test
  void aTargetThatNeverAnswersLeavesTheOperatorWaiting() {
    HandlerFixture drone = HandlerFixture.flying(TT, REPORT);

    drone.handle("emergency");
    drone.after(60);

    assertThat(drone.carriedOut()).containsExactly("Emergency[]");
    assertThat(drone.takeReplies()).isEmpty();
  }

  private static Phrase saying(String part) {
    return argThat(phrase -> phrase.english().contains(part));
  }

  private static Request request(String text) {
    return argThat(request -> request.peer().equals(OPERATOR) && request.text().equals(text));
  }
}
