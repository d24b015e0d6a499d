package tellosimulator.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.words.Translation;

class ReportEntriesTest {

  private static final ReportTexts ENGLISH = new ReportTexts(Translation.ENGLISH);

  @TempDir private Path folder;

  @Test
  void steeringAndPollingAreOneEntryUntilSomethingElseComes() throws Exception {
    List<ReportEntry> entries =
        entries(
            """
            {"t":1,"drone":1,"kind":"command","command":"rc 0 0 0 0"}
            {"t":1.1,"drone":1,"kind":"command","command":"rc 0 9 0 0"}
            {"t":1.1,"drone":2,"kind":"command","command":"land"}
            {"t":1.2,"drone":1,"kind":"command","command":"rc 0 9 0 0"}
            {"t":2,"drone":1,"kind":"touched","severity":"warning","text":"touched the floor"}
            {"t":3,"drone":1,"kind":"command","command":"rc 0 0 0 0"}
            {"t":4,"drone":1,"kind":"command","command":"time?","number":5}
            {"t":4,"drone":1,"kind":"reply","command":"time?","number":5,"reply":"1s"}
            {"t":5,"drone":1,"kind":"command","command":"time?","number":6}
            {"t":5,"drone":1,"kind":"reply","command":"time?","number":6,"reply":"2s"}
            """);

    assertThat(entries)
        .extracting(each -> each.words().text() + " " + each.words().count())
        .containsExactly(
            "rc 0 0 0 0 3", "land 1", "touched the floor 1", "rc 0 0 0 0 1", "time? 2");
    assertThat(entries).last().extracting(each -> each.words().reply()).isEqualTo("2s");
  }

  @Test
  void whatWentWrongSaysWhy() throws Exception {
    List<ReportEntry> entries =
        entries(
            """
            {"t":1,"drone":1,"kind":"command","command":"up 9","number":1}
            {"t":1,"drone":1,"kind":"refused","command":"up 9","number":1,"reply":"out of range","reason":"too low"}
            {"t":2,"drone":1,"kind":"lost","command":"land","reason":"the fault loss"}
            {"t":3,"drone":1,"kind":"crashed","severity":"error","text":"crashed"}
            """);

    assertThat(entries).allMatch(ReportEntry::wrong);
    assertThat(entries)
        .extracting(each -> each.kind() + ": " + each.words().why())
        .containsExactly("refused: too low", "lost: the fault loss", "crashed: ");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          forward 50       | fly 50 cm forward
          go 1 2 3 4       | fly by x 1, y 2, z 3 cm at 4 cm/s
          go 1 2 3 4 m5    | fly to x 1, y 2, z 3 cm from pad m5 at 4 cm/s
          battery?         | how full is the battery?
          flip b (app)     | flip (b)
          height limit 10 (app) | climb no higher than 10 m
          throw and go (app) | take off from a throw
          forward          | ''
          nonsense 4       | ''
          go               | ''
          """)
  void commandsAreSaidInPlainWords(String command, String words) {
    assertThat(new CommandWords(ENGLISH).of(command)).isEqualTo(words);
  }

  private List<ReportEntry> entries(String events) throws Exception {
    new RecordingFixture(folder).run("{\"format\":1,\"ended\":9}").with("events.jsonl", events);
    return new ReportEntries(ENGLISH).of(RecordedFlight.read(folder));
  }

  @Test
  void packetsOfTheAppAreEntriesAsTextsAre() throws Exception {
    List<ReportEntry> entries =
        entries(
            """
            {"t":1,"drone":1,"kind":"command","command":"takeoff (app)","number":1}
            {"t":1,"drone":1,"kind":"reply","command":"takeoff (app)","number":1,"reply":"ok"}
            {"t":2,"drone":1,"kind":"command","command":"rc 0 5 0 0 (app)","number":2}
            {"t":2.1,"drone":1,"kind":"command","command":"rc 0 9 0 0 (app)","number":3}
            {"t":3,"drone":1,"kind":"command","command":"ssid? (app)","number":4}
            {"t":3.1,"drone":1,"kind":"command","command":"ssid? (app)","number":5}
            """);

    assertThat(entries)
        .extracting(each -> each.words().text() + " " + each.words().count())
        .containsExactly("takeoff (app) 1", "rc 0 5 0 0 (app) 2", "ssid? (app) 2");
    assertThat(entries)
        .extracting(each -> each.words().why())
        .containsExactly(
            "take off",
            "steer: right 0, forward 5, up 0, turn 0",
            "what is the name of its Wi-Fi?");
  }
}
