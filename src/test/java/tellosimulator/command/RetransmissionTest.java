package tellosimulator.command;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.command.HandlerFixture.OPERATOR;
import static tellosimulator.command.HandlerFixture.peer;
import static tellosimulator.profile.Behavior.REPORT;
import static tellosimulator.profile.Profile.EDU;
import static tellosimulator.profile.Profile.TELLO;
import static tellosimulator.profile.Profile.TT;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.profile.Profile;

/** The header of repeated commands: each is executed once, and each copy is answered. */
class RetransmissionTest {

  @ParameterizedTest
  @EnumSource(
      value = Profile.class,
      names = {"EDU", "TT"})
  void aHeaderOfDigitsPrecedesTheReply(Profile profile) {
    HandlerFixture drone = HandlerFixture.flying(profile, REPORT);

    drone.handle("Re0101 takeoff");
    drone.responder().reply(Reply.OK);
    drone.after(0);

    assertThat(drone.carriedOut()).containsExactly("Takeoff[]");
    assertThat(drone.takeReplies()).containsExactly("Re0101 ok");
  }

  @Test
  void aHeaderOfRawBytesComesBackByteForByte() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    String header = "Re\0\u00ff\1\2 ";

    drone.handle(header + "land\r\n");
    drone.responder().reply(Reply.OK);
    drone.after(0);

    assertThat(drone.carriedOut()).containsExactly("Land[]");
    assertThat(drone.takeReplies()).containsExactly(header + "ok");
  }

  @Test
  void rawBytesMayBeBlanks() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("Re     takeoff");
    drone.handle("Re    \1takeoff");

    assertThat(drone.carriedOut()).containsExactly("Takeoff[]");
    assertThat(drone.takeReplies()).containsExactly("unknown command: Re    \1takeoff");
  }

  @Test
  void copiesThatArriveWhileTheCommandRunsAreAnsweredWithIt() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("Re0101 forward 50");
    drone.busyWith("`forward 50` is still running");
    drone.handle("Re0102 forward 50");
    drone.handle("Re0103 forward 50");
    assertThat(drone.takeReplies()).isEmpty();
    drone.after(2);
    drone.responder().reply(Reply.OK);
    drone.after(0);

    assertThat(drone.carriedOut()).containsExactly("Move[direction=FORWARD, distance=0.5]");
    assertThat(drone.takeReplies()).containsExactly("Re0101 ok", "Re0102 ok", "Re0103 ok");
  }

  @Test
  void aCopyThatArrivesAfterTheAnswerGetsTheSameAnswerAtOnce() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("Re0101 forward 50");
    drone.after(2);
    drone.responder().reply(Reply.OK);
    drone.after(1);
    drone.handle("Re0102 forward 50");

    assertThat(drone.carriedOut()).hasSize(1);
    assertThat(drone.takeReplies()).containsExactly("Re0101 ok", "Re0102 ok");
  }

  @Test
  void aCopyBetweenTheTwoAnswersOfStopGetsBoth() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("Re0701 stop");
    drone.responder().reply(Reply.OK);
    drone.after(0.1);
    drone.handle("Re0702 stop");
    drone.responder().reply(Reply.FORCED_STOP);
    drone.after(0);

    assertThat(drone.takeReplies())
        .containsExactly("Re0701 ok", "Re0702 ok", "Re0701 forced stop", "Re0702 forced stop");
  }

  @Test
  void aRefusalIsRepeatedForEachCopyWithoutANewCheck() {
    HandlerFixture drone = HandlerFixture.grounded(EDU, REPORT);

    drone.handle("Re0101 forward 50");
    drone.handle("Re0102 forward 50");

    assertThat(drone.takeReplies())
        .containsExactly("Re0101 error Motor stop", "Re0102 error Motor stop");
    org.mockito.Mockito.verify(drone.target).flying();
  }

  @Test
  void anUnknownCommandIsEchoedWithoutItsHeaderAfterIt() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("Re0101 foo 1");
    drone.handle("Re0102 foo 1");

    assertThat(drone.takeReplies())
        .containsExactly("Re0101 unknown command: foo 1", "Re0102 unknown command: foo 1");
  }

  @Test
  void anotherIndexOrAnotherTextIsAnotherCommand() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("Re0101 forward 50");
    drone.handle("Re0201 forward 50");
    drone.handle("Re0202 back 50");

    assertThat(drone.carriedOut())
        .containsExactly(
            "Move[direction=FORWARD, distance=0.5]",
            "Move[direction=FORWARD, distance=0.5]",
            "Move[direction=BACK, distance=0.5]");
  }

  @Test
  void aLateCopyOfAnOlderIndexIsAnsweredAsItWasAndNotFlownAgain() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    String forward = "Move[direction=FORWARD, distance=0.5]";
    String back = "Move[direction=BACK, distance=0.5]";

    drone.handle("Re0101 forward 50");
    drone.responder().reply(Reply.OK);
    drone.handle("Re0201 back 50");
    drone.responder().refuse(Reply.ERROR, HandlerFixture.phrase("for this test"));
    drone.after(0);
    drone.takeReplies();
    drone.handle("Re0102 forward 50");
    drone.handle("Re0202 back 50");
    drone.handle("Re0103 forward 50");

    assertThat(drone.carriedOut()).containsExactly(forward, back);
    assertThat(drone.takeReplies()).containsExactly("Re0102 ok", "Re0202 error", "Re0103 ok");
  }

  @Test
  void theLast64IndicesAreRemembered() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    IntStream.rangeClosed(1, 65).forEach(i -> drone.handle(header(i, 1) + "up 50"));

    drone.handle(header(2, 2) + "up 50");
    assertThat(drone.carriedOut()).hasSize(65);

    drone.handle(header(1, 2) + "up 50");
    assertThat(drone.carriedOut()).hasSize(66);
  }

  @Test
  void anIndexThatWrapsAroundIsTheNewestAgain() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    drone.handle(header(1, 1) + "up 50");
    IntStream.rangeClosed(2, 64).forEach(i -> drone.handle(header(i, 1) + "up 50"));
    drone.handle(header(1, 1) + "down 50");
    IntStream.rangeClosed(65, 70).forEach(i -> drone.handle(header(i, 1) + "up 50"));

    drone.handle(header(1, 2) + "down 50");

    assertThat(drone.carriedOut()).hasSize(71);
  }

  @ParameterizedTest
  @ValueSource(strings = {"command", "Re0101 command"})
  void aProgramThatStartsAnewFliesTheSameTextsAgain(String first) {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    for (int run = 0; run < 2; run++) {
      drone.handle(first);
      drone.handle("Re0201 takeoff");
      drone.handle("Re0301 land");
    }

    assertThat(drone.carriedOut())
        .containsExactly(
            "EnterSdkMode[]", "Takeoff[]", "Land[]", "EnterSdkMode[]", "Takeoff[]", "Land[]");
  }

  @Test
  void aLateCopyOfCommandForgetsNothing() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("Re0101 command");
    drone.handle("Re0201 takeoff");
    drone.handle("Re0102 command");
    drone.handle("Re0202 takeoff");

    assertThat(drone.carriedOut()).hasSize(2);
  }

  private static String header(int index, int repeat) {
    return String.format(java.util.Locale.ROOT, "Re%02d%02d ", index, repeat);
  }

  @Test
  void twoPeersMayUseTheSameIndex() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    Peer other = peer(1, 40_002);

    drone.handle("Re0101 battery?");
    drone.responder().reply(Reply.line("76"));
    drone.handle(other, "Re0101 battery?");
    drone.responder().reply(Reply.line("75"));
    drone.after(0);

    assertThat(drone.sent)
        .containsExactly(
            new HandlerFixture.Sent(OPERATOR, "Re0101 76\r\n"),
            new HandlerFixture.Sent(other, "Re0101 75\r\n"));
  }

  @Test
  void theSameCommandWithoutHeaderIsNoCopy() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("Re0101 up 50");
    drone.handle("up 50");
    drone.handle("up 50");

    assertThat(drone.carriedOut()).hasSize(3);
  }

  @Test
  void theVendorsFiveTriesAreAllAnsweredAndAFloodOfCopiesIsNot() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    for (int i = 0; i < 1000; i++) {
      drone.handle("Re01" + (10 + i % 90) + " land");
    }
    drone.responder().reply(Reply.OK);
    drone.after(0);

    List<String> replies = drone.takeReplies();
    assertThat(drone.carriedOut()).hasSize(1);
    assertThat(replies).startsWith("Re0110 ok", "Re0111 ok", "Re0112 ok", "Re0113 ok", "Re0114 ok");
    assertThat(replies).hasSizeLessThan(20);
  }

  @Test
  void eachCopyOfAnAnsweredCommandIsAnswered() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    drone.handle("Re0110 land");
    drone.responder().reply(Reply.OK);
    drone.after(0);
    drone.takeReplies();

    for (int i = 0; i < 50; i++) {
      drone.handle("Re01" + (11 + i) + " land");
      assertThat(drone.takeReplies()).containsExactly("Re01" + (11 + i) + " ok");
    }
  }

  @Test
  void ofThousandsOfPeersTheLatestAreRemembered() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    IntStream.rangeClosed(1, 2000).forEach(i -> drone.handle(peer(1, i), "Re0101 land"));
    drone.handle(peer(1, 2000), "Re0102 land");
    assertThat(drone.carriedOut()).hasSize(2000);

    drone.handle(peer(1, 1), "Re0102 land");
    assertThat(drone.carriedOut()).hasSize(2001);
  }

  @Test
  void withoutPowerCopiesAreForgotten() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    drone.handle("Re0101 command");
    drone.handler.forgetCopies();

    drone.handle("Re0102 command");

    assertThat(drone.carriedOut()).hasSize(2);
  }

  @Test
  void theWhiteTelloKnowsNoHeader() {
    HandlerFixture drone = HandlerFixture.flying(TELLO, REPORT);

    drone.handle("Re0101 takeoff");

    assertThat(drone.carriedOut()).isEmpty();
    assertThat(drone.takeReplies()).containsExactly("unknown command: Re0101 takeoff");
  }

  @ParameterizedTest
  @ValueSource(strings = {"Re010 takeoff", "Re01011 takeoff", "re0101 takeoff", "Re0101takeoff"})
  void whatHasAnotherShapeIsNoHeader(String text) {
    HandlerFixture drone = HandlerFixture.flying(TT, REPORT);

    drone.handle(text);

    assertThat(drone.carriedOut()).isEmpty();
    assertThat(drone.takeReplies()).containsExactly("unknown command: " + text);
  }

  @Test
  void aHeaderAloneIsAnEmptyCommand() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);

    drone.handle("Re0101 ");

    assertThat(drone.takeReplies()).containsExactly("Re0101 unknown command: ");
  }

  @ParameterizedTest
  @ValueSource(ints = {1025, 1026, 1031, 1032})
  void aHeaderCountsForTheLengthOfADatagram(int length) {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    String text = "Re0101 wifi name ";
    String datagram = text + "p".repeat(length - text.length());

    drone.handle(datagram);

    assertThat(drone.carriedOut()).isEmpty();
    assertThat(drone.takeReplies())
        .containsExactly("unknown command: " + datagram.substring(0, 1024));
  }

  @Test
  void aDatagramOf1024BytesWithItsHeaderIsTaken() {
    HandlerFixture drone = HandlerFixture.flying(EDU, REPORT);
    String text = "Re0101 wifi name ";

    drone.handle(text + "p".repeat(1024 - text.length()));

    assertThat(drone.carriedOut()).containsExactly("SetNetwork[done=Reply[text=ok]]");
  }
}
