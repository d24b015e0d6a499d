package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordedCommand.Outcome;
import tellosimulator.testing.AppPackets;

/**
 * Events match replies to commands by a number; without them, as in recordings of a real drone's
 * proxy, the datagrams alone must be enough.
 */
class CommandPairingTest {

  @TempDir private Path folder;

  @Test
  void aStopWithTwoRepliesIsOneCommand() throws Exception {
    List<RecordedCommand> commands =
        told(
            """
            {"t":1,"drone":1,"kind":"command","command":"stop","number":7}
            {"t":1.5,"drone":1,"kind":"reply","command":"stop","number":7,"reply":"ok"}
            {"t":2,"drone":1,"kind":"command","command":"stop","number":8}
            {"t":2.25,"drone":1,"kind":"reply","command":"stop","number":8,"reply":"ok"}
            {"t":3,"drone":1,"kind":"reply","command":"stop","number":7,"reply":"forced stop"}
            """);

    assertThat(commands)
        .extracting(each -> each.text() + " " + each.reply() + " " + each.duration().getAsDouble())
        .containsExactly("stop ok 0.5", "stop ok 0.25");
  }

  @Test
  void equalCommandsAreToldApartByTheirNumbers() throws Exception {
    List<RecordedCommand> commands =
        told(
            """
            {"t":1,"drone":1,"kind":"command","command":"up 50","number":1}
            {"t":1,"drone":2,"kind":"command","command":"up 50","number":1}
            {"t":2,"drone":1,"kind":"command","command":"up 50","number":2}
            {"t":2,"drone":1,"kind":"refused","command":"up 50","number":2,"reply":"error"}
            {"t":3,"drone":1,"kind":"reply","command":"up 50","number":1,"reply":"ok"}
            {"t":4,"drone":1,"kind":"lost","command":"land","reason":"the fault loss"}
            """);

    assertThat(commands)
        .extracting(each -> each.drone() + " " + each.text() + " " + each.outcome())
        .containsExactly(
            "1 up 50 ANSWERED", "2 up 50 UNANSWERED", "1 up 50 REFUSED", "1 land LOST");
  }

  @Test
  void readsAndRefusalsAreAnsweredBeforeTheCommandThatRuns() throws Exception {
    List<RecordedCommand> commands =
        commands(
            """
            {"t":1,"drone":1,"dir":"in","kind":"command","text":"forward 100"}
            {"t":1.5,"drone":1,"dir":"in","kind":"command","text":"battery?"}
            {"t":1.6,"drone":1,"dir":"out","kind":"reply","text":"87\\r\\n"}
            {"t":2,"drone":1,"dir":"in","kind":"command","text":"cw 90"}
            {"t":2.1,"drone":1,"dir":"out","kind":"reply","text":"error Not joystick"}
            {"t":2.2,"drone":1,"dir":"out","kind":"state","text":"pitch:0;"}
            {"t":3,"drone":1,"dir":"out","kind":"reply","text":"ok"}
            """);

    assertThat(commands)
        .extracting(each -> each.text() + " " + each.outcome() + " " + each.reply())
        .containsExactly(
            "forward 100 ANSWERED ok", "battery? ANSWERED 87", "cw 90 REFUSED error Not joystick");
    assertThat(commands.get(0).duration()).hasValue(2);
  }

  @Test
  void aBoardRefusesInWordsOfItsOwn() throws Exception {
    List<RecordedCommand> commands =
        commands(
            """
            {"t":1,"drone":1,"kind":"command","text":"EXT led 300 0 0"}
            {"t":1.1,"drone":1,"kind":"reply","text":"led error"}
            {"t":2,"drone":1,"kind":"command","text":"EXT mled s x A"}
            {"t":2.1,"drone":1,"kind":"reply","text":"matrix error"}
            {"t":3,"drone":1,"kind":"command","text":"EXT led 30 0 0"}
            {"t":3.1,"drone":1,"kind":"reply","text":"led ok"}
            """);

    assertThat(commands)
        .extracting(RecordedCommand::outcome)
        .containsExactly(Outcome.REFUSED, Outcome.REFUSED, Outcome.ANSWERED);
  }

  @Test
  void steeringIsNeverAnswered() throws Exception {
    List<RecordedCommand> commands =
        commands(
            """
            {"t":1,"drone":1,"kind":"command","text":"takeoff"}
            {"t":2,"drone":1,"kind":"command","text":"rc 0 0 0 0"}
            {"t":5,"drone":1,"kind":"reply","text":"ok"}
            """);

    assertThat(commands)
        .extracting(RecordedCommand::outcome)
        .containsExactly(Outcome.ANSWERED, Outcome.UNANSWERED);
  }

  @Test
  void eachDroneAnswersForItself() throws Exception {
    List<RecordedCommand> commands =
        commands(
            """
            {"t":1,"drone":1,"kind":"command","text":"takeoff"}
            {"t":1,"drone":2,"kind":"command","text":"takeoff"}
            {"t":4,"drone":2,"kind":"reply","text":"ok"}
            {"t":5,"drone":1,"kind":"reply","text":"error"}
            {"t":6,"drone":1,"kind":"reply","text":"to nothing"}
            """);

    assertThat(commands)
        .extracting(each -> each.drone() + " " + each.reply())
        .containsExactly("1 error", "2 ok");
  }

  @Test
  void aLostReplyDoesNotShiftThoseThatFollow() throws Exception {
    List<RecordedCommand> commands =
        commands(
            """
            {"t":1,"drone":1,"kind":"command","text":"forward 100"}
            {"t":8,"drone":1,"kind":"command","text":"cw 90"}
            {"t":10,"drone":1,"kind":"reply","text":"ok"}
            {"t":11,"drone":1,"kind":"command","text":"battery?"}
            {"t":14,"drone":1,"kind":"command","text":"time?"}
            {"t":14.1,"drone":1,"kind":"reply","text":"24s\\r\\n"}
            {"t":15,"drone":1,"kind":"command","text":"up 50"}
            {"t":17,"drone":1,"kind":"reply","text":"ok"}
            """);

    assertThat(commands)
        .extracting(each -> each.text() + " " + each.outcome() + " " + each.reply())
        .containsExactly(
            "forward 100 UNANSWERED ",
            "cw 90 ANSWERED ok",
            "battery? UNANSWERED ",
            "time? ANSWERED 24s",
            "up 50 ANSWERED ok");
  }

  @Test
  void anEmergencyIsNeverAnswered() throws Exception {
    List<RecordedCommand> commands =
        commands(
            """
            {"t":1,"drone":1,"kind":"command","text":"emergency"}
            {"t":2,"drone":1,"kind":"command","text":"takeoff"}
            {"t":2.1,"drone":1,"kind":"reply","text":"error Motor stop"}
            """);

    assertThat(commands)
        .extracting(RecordedCommand::outcome)
        .containsExactly(Outcome.UNANSWERED, Outcome.REFUSED);
  }

  @Test
  void stopIsAnsweredAtOnceAndOnceMoreWhenTheDroneStands() throws Exception {
    List<RecordedCommand> commands =
        commands(
            """
            {"t":1,"drone":1,"kind":"command","text":"forward 300"}
            {"t":2,"drone":1,"kind":"command","text":"stop"}
            {"t":2.05,"drone":1,"kind":"reply","text":"ok"}
            {"t":2.8,"drone":1,"kind":"reply","text":"forced stop"}
            {"t":4,"drone":1,"kind":"command","text":"land"}
            {"t":6,"drone":1,"kind":"reply","text":"ok"}
            """);

    assertThat(commands)
        .extracting(each -> each.text() + " " + each.outcome() + " " + each.reply())
        .containsExactly("forward 300 UNANSWERED ", "stop ANSWERED ok", "land ANSWERED ok");
  }

  @Test
  void readsInARowAreAnsweredInTheirOrder() throws Exception {
    List<RecordedCommand> commands =
        commands(
            """
            {"t":1,"drone":1,"kind":"command","text":"streamon"}
            {"t":1.01,"drone":1,"kind":"command","text":"battery?"}
            {"t":1.02,"drone":1,"kind":"command","text":"takeoff"}
            {"t":1.05,"drone":1,"kind":"reply","text":"ok"}
            {"t":1.06,"drone":1,"kind":"reply","text":"87"}
            {"t":6,"drone":1,"kind":"reply","text":"ok"}
            """);

    assertThat(commands)
        .extracting(each -> each.text() + " " + each.reply())
        .containsExactly("streamon ok", "battery? 87", "takeoff ok");
  }

  @Test
  void aDayOfSticksAndReadsIsPairedAtOnce() throws Exception {
    CommandPairing pairing = new CommandPairing();
    int all = 200_000; // a quadratic algorithm would take hours
    for (int i = 0; i < all; i++) {
      pairing.take(line(i, "command", i % 20 == 0 ? "battery?" : "rc 0 0 0 0"));
      if (i % 20 == 0) {
        pairing.take(line(i, "reply", "87"));
      }
    }

    assertThat(pairing.commands())
        .hasSize(all)
        .filteredOn(command -> command.outcome() == Outcome.ANSWERED)
        .hasSize(all / 20);
  }

  private static Fields line(int time, String kind, String text) {
    return Fields.of("{\"t\":%d,\"kind\":\"%s\",\"text\":\"%s\"}".formatted(time, kind, text));
  }

  private List<RecordedCommand> told(String events) throws UnreadableRecordingException {
    new RecordingFixture(folder).run("{\"format\":1,\"ended\":9}").with("events.jsonl", events);
    return RecordedFlight.read(folder).commands();
  }

  private List<RecordedCommand> commands(String wire) throws UnreadableRecordingException {
    new RecordingFixture(folder).run("{\"format\":1,\"ended\":9}").with("wire.jsonl", wire);
    return RecordedFlight.read(folder).commands();
  }

  @Test
  void packetsOfTheAppAreMatchedByTheirNumbers() throws Exception {
    List<RecordedCommand> commands =
        commands(
            line("command", AppPackets.CONNECT)
                + line("command", AppPackets.TAKEOFF)
                + line("command", "battery?")
                + line("command", AppPackets.LAND)
                + line("command", AppPackets.STICKS)
                + line("command", AppPackets.KEY_PICTURE)
                + line("reply", AppPackets.LAND_DONE)
                + line("reply", AppPackets.FLIGHT_DATA)
                + line("reply", "87\r\n")
                + line("reply", AppPackets.TAKEOFF_REFUSED)
                + line("reply", AppPackets.ACKNOWLEDGEMENT));

    assertThat(commands)
        .extracting(each -> each.words() + " " + each.outcome() + " " + each.reply())
        .containsExactly(
            "conn_req (app) ANSWERED conn_ack",
            "takeoff (app) REFUSED error",
            "battery? ANSWERED 87",
            "land (app) ANSWERED ok",
            "rc 0 50 0 -100 (app) UNANSWERED ");
    assertThat(commands.get(1).text()).as("as sent").isEqualTo(AppPackets.TAKEOFF);
  }

  private static String line(String kind, String text) {
    return Json.text(Map.of("t", 1, "drone", 1, "kind", kind, "text", text)) + "\n";
  }
}
