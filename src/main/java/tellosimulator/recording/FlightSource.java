package tellosimulator.recording;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioDocument;
import tellosimulator.time.SimTime;
import tellosimulator.video.ReceivedStream;

/** Whose flights are recorded, which decides what there is to write. For the writer's thread. */
sealed interface FlightSource {

  /** What the names of folders end with; may be empty. */
  String title();

  /** How many drones there are. */
  int drones();

  /**
   * Begins the files of a flight.
   *
   * @throws IOException if one cannot be written
   */
  FlightFiles begin(Path folder, RecordingFolder.Disk disk, Entry.Begin begin) throws IOException;

  /** A datagram of a flight left the drone. */
  void sent(Entry.Sent datagram, VideoRecorders films);

  /**
   * A simulation, of which all is known.
   *
   * @param inputs what came to it until the flight begins
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
      RunText run = RunText.of(subject, begin, inputs);
      FlightFiles files = new FlightFiles(folder, disk, run, begin.wall());
      Scenario flown = subject.scenario().asIn(begin.snapshot().orElseThrow());
      files.addTruth(flown, ScenarioDocument.of(subject.scenario()), inputs);
      return files;
    }

    /** Its films are kept as they are made. */
    @Override
    public void sent(Entry.Sent datagram, VideoRecorders films) {}
  }

  /** A real drone. */
  final class Real implements FlightSource {

    private final InetAddress address;
    private final List<String> options;

    private Optional<ReceivedStream> stream = Optional.empty();
    private SimTime now = SimTime.ZERO;

    /**
     * @param options words of the command line, as far as they are known
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
      stream = Optional.empty(); // a film begins with its own parameter sets
      return new FlightFiles(folder, disk, RunText.of(address, options, begin), begin.wall());
    }

    @Override
    public void sent(Entry.Sent datagram, VideoRecorders films) {
      if (datagram.kind() == Kind.VIDEO) {
        now = datagram.time();
        if (stream.isEmpty()) {
          stream = Optional.of(new ReceivedStream(picture -> films.filmed(drones(), picture, now)));
        }
        stream.get().take(datagram.bytes(), datagram.nanos());
      }
    }
  }
}
