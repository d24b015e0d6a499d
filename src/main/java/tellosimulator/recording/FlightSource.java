package tellosimulator.recording;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioDocument;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.time.SimTime;
import tellosimulator.video.ReceivedStream;

/**
 * The kind of drones whose flights are recorded: simulated or real. The kind determines which files
 * are written. Confined to the writer's thread.
 */
sealed interface FlightSource {

  /** The title that is appended to folder names; may be empty. */
  String title();

  /** The number of drones. */
  int drones();

  /**
   * Creates the files of a flight.
   *
   * @throws IOException if a file cannot be written
   */
  FlightFiles begin(Path folder, RecordingFolder.Disk disk, Entry.Begin begin) throws IOException;

  /** Processes a datagram that a drone sent during a flight. */
  void sent(Entry.Sent datagram, FlightFiles files, VideoRecorders films);

  /**
   * A simulation; its whole state is known.
   *
   * @param inputs the inputs up to the start of the flight
   */
  record Simulated(FlightRecorder.Subject subject, InputHistory inputs) implements FlightSource {

    @Override
    public String title() {
      return subject.title();
    }

    @Override
    public int drones() {
      return subject.scenario().config().drones().size();
    }

    @Override
    public FlightFiles begin(Path folder, RecordingFolder.Disk disk, Entry.Begin begin)
        throws IOException {
      Scenario flown = subject.scenario().asIn(begin.snapshot().orElseThrow());
      ScenarioFile.write(
          ScenarioDocument.of(subject.scenario()).changedTo(flown, folder),
          RecordingFile.SCENARIO.in(folder));
      List<RecordingFile> files =
          new ArrayList<>(List.of(RecordingFile.WIRE, RecordingFile.EVENTS, RecordingFile.FLIGHT));
      if (inputs.complete()) {
        files.add(RecordingFile.INPUTS);
      }
      RunText run = RunText.of(subject, begin, inputs);
      FlightFiles opened = new FlightFiles(folder, disk, run, begin.wall(), files);
      opened.add(RecordingFile.INPUTS, inputs.text());
      return opened;
    }

    /** Does nothing, because the videos of simulated drones are recorded while they are encoded. */
    @Override
    public void sent(Entry.Sent datagram, FlightFiles files, VideoRecorders films) {}
  }

  /** A real drone. */
  final class Real implements FlightSource {

    private static final String NO_STICKS = ",,,";

    private final InetAddress address;
    private final List<String> options;

    private Optional<ReceivedStream> stream = Optional.empty();
    private SimTime now = SimTime.ZERO;
    private EstimatedTrack track = new EstimatedTrack();
    private final FlightRowState row = new FlightRowState();

    /**
     * Creates a source for the flights of one real drone.
     *
     * @param options the command-line arguments, as far as they are known
     */
    Real(InetAddress address, List<String> options) {
      this.address = address;
      this.options = List.copyOf(options);
    }

    @Override
    public String title() {
      return "drone";
    }

    @Override
    public int drones() {
      return 1;
    }

    @Override
    public FlightFiles begin(Path folder, RecordingFolder.Disk disk, Entry.Begin begin)
        throws IOException {
      stream = Optional.empty(); // each flight's video begins with its own parameter sets
      track = new EstimatedTrack();
      RunText run = RunText.of(address, options, begin);
      return new FlightFiles(
          folder, disk, run, begin.wall(), List.of(RecordingFile.WIRE, RecordingFile.FLIGHT));
    }

    @Override
    public void sent(Entry.Sent datagram, FlightFiles files, VideoRecorders films) {
      if (datagram.kind() == Kind.STATE) {
        state(datagram, files);
      } else if (datagram.kind() == Kind.VIDEO) {
        now = datagram.time();
        if (stream.isEmpty()) {
          stream = Optional.of(new ReceivedStream(picture -> films.filmed(drones(), picture, now)));
        }
        stream.get().take(datagram.bytes(), datagram.nanos());
      }
    }

    /** Writes a row of the table if the line contains motion data. */
    private void state(Entry.Sent datagram, FlightFiles files) {
      String text = datagram.text();
      Optional<Sample> sample = track.take(datagram.time().seconds(), drones(), text);
      if (sample.isPresent()) {
        row.report(text);
        files.add(
            RecordingFile.FLIGHT,
            RecordingFormat.row(drones(), sample.get(), NO_STICKS, row.sensors()));
      }
    }
  }
}
