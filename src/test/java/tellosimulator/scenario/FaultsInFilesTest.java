package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultPlan;
import tellosimulator.fault.LinkPreset;

/** Tests the keys {@code link} and {@code faults} of scenario files. */
class FaultsInFilesTest {

  @TempDir private Path folder;

  @Test
  void aFileWithoutThemHasNothingThatGoesWrong() throws Exception {
    assertThat(plan("{}")).isEqualTo(FaultPlan.NONE);
  }

  @Test
  void aLinkIsAPreset() throws Exception {
    assertThat(plan("link: crowded").link()).isEqualTo(Optional.of(LinkPreset.CROWDED));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          cut                                                    | cut
          loss state 20% drone 2 at 5s for 10s                   | loss state 20% drone 2 at 5s for 10s
          'cut after "forward 100"'                              | cut after "forward 100"
          {fault: loss, share: 12.5}                             | loss 12.5%
          {fault: loss, direction: state, share: 20%, burst: 2}  | loss state 20% burst 2
          {fault: delay, direction: [replies, state], time: 1 s} | delay replies state 1s
          {fault: cut, drone: 2, after: forward 100, nth: 2}     | cut drone 2 after 2nd "forward 100"
          {fault: cut, at: 1.5, for: 2min}                       | cut at 1.5s for 2min
          """)
  void aFaultIsALineOrAMapping(String item, String text) throws Exception {
    String file = "drones: [{start: [0, 0]}, {start: [0, 99]}]\nfaults:\n  - " + item + "\n";

    assertThat(plan(file).faults()).containsExactly(Fault.of(text));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          xyz                                   | 2:5: expected one of bandwidth
          los 20%                               | 2:5: there is no "los", did you mean loss?
          loss 120%                             | 2:5: share is 120%, but must be from 0% to 100%
          cut drone 2                           | 2:5: there is no drone 2, the drones are 1 to 1
          [cut]                                 | 2:5: expected a fault such as loss state 20%, found a list of 1
          {fault: loss, share: 120}             | 2:26: share is 120%, but must be from 0% to 100%
          {fault: loss, time: 5s}               | 2:25: loss has no time
          {fault: loss, share: many}            | 2:26: share is a number in %, but "many" was found
          {fault: lost}                         | 2:13: expected one of bandwidth
          {fault: loss, direction: [stat]}      | 2:31: expected one of commands, replies, state, video, found "stat", did you mean state?
          {fault: stranger, direction: state}   | 2:34: stranger does not concern state
          {fault: cut, drone: 2}                | 2:5: there is no drone 2, the drones are 1 to 1
          {fault: cut, for: 0}                  | 2:23: for needs a time such as 5s
          {fault: cut, nth: 2}                  | 2:23: the key nth goes only with after
          {fault: cut, at: 1, after: up}        | 2:22: the key at does not go with after
          {fault: delay, time: 1ms, least: 2ms} | 2:13: the delay must be from its least to its most
          {fault: cut, tme: 3}                  | 2:18: a fault has no key "tme", did you mean time?
          """)
  void aMistakeIsToldAtItsPlace(String item, String diagnostic) {
    ScenarioException wrong =
        catchThrowableOfType(ScenarioException.class, () -> plan("faults:\n  - " + item + "\n"));

    assertThat(wrong).hasMessageContaining("room.yaml:" + diagnostic);
  }

  @Test
  void whatIsWrittenIsReadAsTheSame() throws Exception {
    String text =
        "# of my own\nlink: lab\nfaults:\n  - {fault: loss, share: 20}\n  - cut for 3s # short\n";
    ScenarioDocument read = ScenarioFile.open(file(text));

    Scenario fewer =
        read.scenario()
            .withConfig(read.scenario().config().withFaults(List.of(Fault.of("cut for 3s"))));
    Path written = folder.resolve("written.yaml");
    Files.write(written, read.changedTo(fewer, folder).bytes().orElseThrow());

    assertThat(Files.readString(written)).contains("# of my own", "cut for 3s");
    assertThat(ScenarioFile.read(written)).isEqualTo(fewer);
    Scenario none = fewer.withConfig(fewer.config().withFaults(List.of()));
    Files.write(written, read.changedTo(none, folder).bytes().orElseThrow());
    assertThat(ScenarioFile.read(written)).isEqualTo(none);
  }

  private FaultPlan plan(String text) throws Exception {
    return ScenarioFile.read(file(text)).config().rules().faults();
  }

  private Path file(String text) throws Exception {
    return Files.writeString(folder.resolve("room.yaml"), text);
  }
}
