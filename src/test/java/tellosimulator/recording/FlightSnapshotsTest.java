package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.extension.BoardLights;
import tellosimulator.extension.MatrixPicture;
import tellosimulator.model.DroneState;

/** Tests the lights of a drone's extension board in a recording. */
class FlightSnapshotsTest {

  private static final String EVENTS =
      """
      {"t":5.0,"drone":1,"kind":"command","severity":"information","text":"","command":"EXT led 255 0 64","number":1}
      {"t":5.1,"drone":1,"kind":"reply","severity":"information","text":"","command":"EXT led 255 0 64","number":1,"reply":"led ok"}
      {"t":6.0,"drone":1,"kind":"command","severity":"information","text":"","command":"EXT led 300 0 0","number":2}
      {"t":6.0,"drone":1,"kind":"refused","severity":"warning","text":"","command":"EXT led 300 0 0","number":2,"reply":"error","reason":"r is 300"}
      {"t":7.0,"drone":1,"kind":"command","severity":"information","text":"","command":"EXT mled s b A","number":3}
      {"t":7.1,"drone":1,"kind":"reply","severity":"information","text":"","command":"EXT mled s b A","number":3,"reply":"matrix ok"}
      {"t":8.0,"drone":1,"kind":"command","severity":"information","text":"","command":"forward 100","number":4}
      {"t":9.0,"drone":1,"kind":"reply","severity":"information","text":"","command":"forward 100","number":4,"reply":"ok"}
      """;

  @TempDir private Path folder;
  private FlightSnapshots snapshots;

  @BeforeEach
  void read() throws Exception {
    new RecordingFixture(RecordingFixture.in(folder)).with("events.jsonl", EVENTS);
    snapshots = new FlightSnapshots(RecordedFlight.read(folder));
  }

  @Test
  void theLampShinesFromTheCommandOnThatWasCarriedOut() {
    assertThat(lampRgb(4.9)).isEqualTo(0);
    assertThat(lampRgb(5.5)).isEqualTo(0xff0040);
    assertThat(lampRgb(6.5)).as("after a refused one").isEqualTo(0xff0040);
  }

  @Test
  void theMatrixShowsWhatItWasToldAndTheLampGoesOn() {
    assertThat(picture(6.9)).isEqualTo(MatrixPicture.DARK);
    assertThat(picture(7.5)).isNotEqualTo(MatrixPicture.DARK);
    assertThat(picture(14)).isEqualTo(picture(7.5));
    assertThat(lampRgb(14)).isEqualTo(0xff0040);
    assertThat(picture(6.9)).as("backwards in time").isEqualTo(MatrixPicture.DARK);
  }

  @Test
  void nothingShinesWhileTheDroneIsOff() throws Exception {
    Path samples = folder.resolve("flight.csv");
    Files.writeString(samples, Files.readString(samples).replace(",grounded,", ",off,"));
    snapshots = new FlightSnapshots(RecordedFlight.read(folder));

    assertThat(lampRgb(13)).as("landing").isEqualTo(0xff0040);
    assertThat(lampRgb(14.5)).isEqualTo(0);
    assertThat(picture(14.5)).isEqualTo(MatrixPicture.DARK);
  }

  private int lampRgb(double time) {
    return lights(time).lampRgb(state(time).time());
  }

  private MatrixPicture picture(double time) {
    return lights(time).picture(state(time).time());
  }

  private BoardLights lights(double time) {
    return state(time).lights();
  }

  private DroneState state(double time) {
    return snapshots.at(time).drones().get(0).state();
  }
}
