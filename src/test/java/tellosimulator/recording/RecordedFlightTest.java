package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.math.Vec3;
import tellosimulator.recording.RecordedCommand.Outcome;
import tellosimulator.words.Phrase;

class RecordedFlightTest {

  @TempDir private Path folder;

  @Test
  void aWholeRecordingIsReadWithoutARemark() throws Exception {
    RecordedFlight flight = RecordedFlight.read(RecordingFixture.in(folder));

    assertThat(flight.remarks()).isEmpty();
    assertThat(flight.run().seed()).contains(7L);
    assertThat(flight.run().result()).isEqualTo("missed");
    assertThat(flight.run().setting().room().depth()).isEqualTo(6);
    RecordedRun.DroneEntry drone = flight.run().setting().drones().get(0);
    assertThat(drone.start().position()).isEqualTo(new Vec3(-1, 0.5, 0));
    // 90 degrees clockwise are a quarter turn to the right
    assertThat(drone.start().attitude().heading()).isCloseTo(-Math.PI / 2, within(1e-9));
    assertThat(flight.goals())
        .containsExactly(
            new RecordedGoal(Phrase.name("reach x 0, y 50, z 80 cm"), OptionalDouble.of(10.5)),
            new RecordedGoal(Phrase.name("land on the mission pad 3"), OptionalDouble.empty()));
    assertThat(flight.begin()).isEqualTo(1);
    assertThat(flight.end()).isEqualTo(15);
  }

  @Test
  void samplesHaveMetersAndTheCommandInProgress() throws Exception {
    Track track = RecordedFlight.read(RecordingFixture.in(folder)).tracks().get(0);

    Sample sample = track.at(9.02); // the sample of 9.0 s: 1 s at 50 cm/s from -100 cm on
    assertThat(sample.time()).isEqualTo(9);
    assertThat(sample.position()).isEqualTo(new Vec3(-0.5, 0.5, 0.8));
    assertThat(sample.velocity()).isEqualTo(new Vec3(0.5, 0, 0));
    assertThat(sample.angles()).isEqualTo(new Sample.Angles(1.5, -2, 0));
    assertThat(sample.phase()).isEqualTo("flying");
    assertThat(sample.batteryPercent()).isEqualTo(81);
    assertThat(sample.command()).isEqualTo("forward 100");
    assertThat(track.at(11).command()).isEmpty();
    assertThat(track.at(-1).time()).isEqualTo(4);
    assertThat(track.at(99).time()).isEqualTo(15);
  }

  @Test
  void aReplyBelongsToItsOwnCommand() throws Exception {
    List<RecordedCommand> commands = RecordedFlight.read(RecordingFixture.in(folder)).commands();

    assertThat(commands)
        .extracting(RecordedCommand::text, RecordedCommand::outcome, RecordedCommand::answered)
        .contains(
            org.assertj.core.groups.Tuple.tuple(
                "forward 100", Outcome.ANSWERED, OptionalDouble.of(10.5)),
            org.assertj.core.groups.Tuple.tuple(
                "battery?", Outcome.ANSWERED, OptionalDouble.of(8.5)),
            org.assertj.core.groups.Tuple.tuple("cw 90", Outcome.REFUSED, OptionalDouble.of(9.0)));
    assertThat(commands).extracting(RecordedCommand::text).contains(RecordingFixture.MARKUP);
    assertThat(commands.get(2).duration()).hasValue(2.5);
  }

  @Test
  void whatIsNoFolderIsOneSentence() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "");
    Path nowhere = folder.resolve("nowhere");

    assertRefused(nowhere, "There is no folder " + nowhere + "; name the folder of a recording.");
    assertRefused(file, file + " is no folder; name the folder of a recording.");
  }

  @Test
  void aFolderThatIsNoRecordingIsOneSentence() {
    assertRefused(folder, folder + " is no recording, because there is no run.json in it.");
  }

  @Test
  void aFolderWithRecordingsNamesOne() {
    RecordingFixture.in(folder.resolve("2"));
    RecordingFixture.in(folder.resolve("1"));

    assertRefused(
        folder,
        folder
            + " is no recording, because there is no run.json in it; name one of the recordings in"
            + " it, such as "
            + folder.resolve("1")
            + ".");
  }

  @Test
  void aDamagedRunIsOneSentence() {
    for (String text : List.of("", "{", "[1]", "\"text\"", "a: b", "\0", "{\"format\":1")) {
      new RecordingFixture(folder).run(text);

      assertRefused(
          folder,
          folder.resolve("run.json") + " is damaged, so that the recording cannot be read.");
    }
  }

  @Test
  void aRecordingThatWasCutOffIsReadUntilThere() throws Exception {
    new RecordingFixture(folder)
        .runWith("\"ended\":15.0,", "")
        .events()
        .samples(9)
        .with("goals.json", "[{\"text\":\"a");
    cut("events.jsonl", 40);
    cut("flight.csv", 5);

    RecordedFlight flight = RecordedFlight.read(folder);

    assertThat(flight.remarks())
        .extracting(Phrase::english)
        .containsExactly(
            "the recording was cut off before the flight was over; what was written until then"
                + " is shown",
            "goals.json cannot be read and is left out");
    assertThat(flight.tracks().get(0).samples()).last().extracting(Sample::time).isEqualTo(8.95);
    assertThat(flight.events()).last().extracting(RecordedEvent::kind).isEqualTo("landed");
  }

  @Test
  void aNewerRecordingIsReadAsFarAsItGoes() throws Exception {
    new RecordingFixture(folder).runWith("\"format\":1", "\"format\":2").events();

    RecordedFlight flight = RecordedFlight.read(folder);

    assertThat(flight.remarks())
        .extracting(Phrase::english)
        .containsExactly(
            "it is from a newer version of the program (format 2, here 1); what this version does"
                + " not know is not shown");
    assertThat(flight.commands()).hasSize(7);
    assertThat(flight.tracks()).isEmpty();
  }

  @Test
  void damagedLinesAreLeftOutAndCounted() throws Exception {
    new RecordingFixture(folder)
        .runWith("7", "8")
        .with("events.jsonl", "{\"t\":1}\nno JSON\n[]\n{\"t\":2,\"kind\":\"new kind\"}\n")
        .with(
            "flight.csv",
            "t_s,drone,x_cm,y_cm,z_cm\n1,1,0,0,x\n2,1,0,0,30\n3,0,0,0,30\n,,,,\n\"\n");

    RecordedFlight flight = RecordedFlight.read(folder);

    assertThat(flight.events()).extracting(RecordedEvent::time).containsExactly(1.0, 2.0);
    assertThat(flight.tracks().get(0).samples()).extracting(Sample::time).containsExactly(2.0);
    assertThat(flight.remarks())
        .extracting(Phrase::english)
        .containsExactly(
            "4 lines of flight.csv are damaged and left out",
            "2 lines of events.jsonl are damaged and left out");
  }

  @Test
  void aDroneWithAnImpossibleNumberIsLeftOut() throws Exception {
    new RecordingFixture(folder).runWith("\"number\":1", "\"number\":-2");

    assertThat(RecordedFlight.read(folder).run().setting().drones()).isEmpty();
  }

  @Test
  void anUnreadableScenarioIsLeftOut() throws Exception {
    RecordingFixture.in(folder);
    new RecordingFixture(folder).with("scenario.yaml", "room: {width: wide}\n");

    RecordedFlight flight = RecordedFlight.read(folder);

    assertThat(flight.scenario()).isEmpty();
    assertThat(flight.remarks())
        .extracting(Phrase::english)
        .containsExactly("scenario.yaml cannot be read and is left out");
  }

  private void cut(String name, int bytes) throws IOException {
    byte[] whole = Files.readAllBytes(folder.resolve(name));
    Files.write(folder.resolve(name), java.util.Arrays.copyOf(whole, whole.length - bytes));
  }

  private static void assertRefused(Path path, String sentence) {
    assertThatThrownBy(() -> RecordedFlight.read(path))
        .isInstanceOf(UnreadableRecordingException.class)
        .hasMessage(sentence);
  }
}
