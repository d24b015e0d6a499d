package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.files.IoReason;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimInput;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.words.Phrase;

/**
 * Writes the entries of the recorder. An error ends the recording of the current flight, and is
 * reported to users in one sentence. Recording resumes with the next flight. Runs on its own
 * thread, unless the recorder is stepped or keeps flights in memory.
 */
final class RecordingWriter implements Agent {

  private static final Logger LOG = LoggerFactory.getLogger(RecordingWriter.class);

  /**
   * Interval between writes [ns]. Decided: if the program is killed, at most half a second of data
   * is lost.
   */
  private static final long PERIOD = 250_000_000;

  /**
   * Maximum weight of the entries written between flushes. Decided: these make a few megabytes of
   * text.
   */
  private static final int AT_ONCE = 20_000;

  /** Maximum number of entries before the takeoff that are included in the flight. Decided. */
  private static final int MOST_BEFORE = 1000;

  private final ErrorPolicy failed = ErrorPolicy.goOn("A recording failed");
  private final EntryQueue queue;
  private final VideoRecorders films;
  private final InputHistory inputs;
  private final RecordingFolder folder;
  private final FlightSource source;
  private final Consumer<Phrase> told;
  private final RecordingFormat lines = new RecordingFormat();
  private final Deque<Entry> before = new ArrayDeque<>();
  private final List<FlightRowState> rows = new ArrayList<>();
  private Optional<FlightFiles> files = Optional.empty();

  /** Whether a flight is in progress, even if it cannot be recorded. */
  private boolean flight;

  /**
   * The objects from which a writer gets its data.
   *
   * @param queue the entries to be written
   * @param films the recorders of the drones' videos
   * @param inputs the inputs of the simulation that are earlier than the inputs in the queue
   */
  record Sources(EntryQueue queue, VideoRecorders films, InputHistory inputs) {

    /** Creates the sources of a writer, with recorders for the videos of a number of drones. */
    Sources(EntryQueue queue, int filmed) {
      this(queue, new VideoRecorders(filmed), new InputHistory());
    }
  }

  RecordingWriter(
      Sources sources, RecordingFolder folder, FlightSource source, Consumer<Phrase> told) {
    this.queue = sources.queue();
    this.films = sources.films();
    this.inputs = sources.inputs();
    this.folder = folder;
    this.source = source;
    this.told = told;
    for (int drone = 1; drone <= source.drones(); drone++) {
      rows.add(new FlightRowState());
    }
  }

  @Override
  public Outcome doWork() {
    if (flight) {
      queue.awaitTick(PERIOD);
    } else {
      queue.rest();
    }
    work();
    return Outcome.WORKED;
  }

  /**
   * Writes waiting entries until {@link #AT_ONCE} is reached, and flushes the files. Returns
   * whether more entries may be waiting.
   */
  private boolean work() {
    boolean more = true;
    for (int weight = 0; more && weight < AT_ONCE; ) {
      Optional<Entry> next = queue.poll();
      more = next.isPresent();
      weight += next.map(Entry::weight).orElse(0);
      next.ifPresent(this::take);
    }
    flush();
    return more;
  }

  private void take(Entry entry) {
    try {
      Optional<String> input = inputs.take(entry);
      if (files.isPresent() && input.isPresent()) {
        files.get().add(RecordingFile.INPUTS, input.get());
      }
      if (entry instanceof Entry.Begin begin) {
        begin(begin);
      } else if (entry instanceof Entry.End end) {
        end(end);
      } else if (entry instanceof Entry.Overrun) {
        overrun();
      } else if (entry instanceof Entry.NewRun) {
        before.clear();
        rows.replaceAll(row -> new FlightRowState());
      } else if (files.isPresent()) {
        write(files.get(), entry);
      } else {
        keep(entry);
      }
    } catch (IOException e) {
      fail(e);
    }
  }

  private void begin(Entry.Begin begin) throws IOException {
    flight = true;
    Path made = folder.create(begin.wall(), source.title());
    files = Optional.of(source.begin(made, folder.disk(), begin));
    films.begin(made, this::tell);
    for (Entry entry : before) {
      line(files.get(), entry);
    }
    before.clear();
    LOG.debug("The flight is recorded in {}", made);
    folder.deleteOld();
  }

  /** Buffers an entry that may belong to the next flight. */
  private void keep(Entry entry) {
    learn(entry);
    boolean line =
        entry instanceof Entry.Happened
            || entry instanceof Entry.Input
            || (entry instanceof Entry.Sent sent && sent.kind() == Kind.REPLY);
    if (line && !flight) {
      before.addLast(entry);
      if (before.size() > MOST_BEFORE) {
        before.removeFirst();
      }
    }
  }

  /** Updates the values that later rows of the table contain. */
  private void learn(Entry entry) {
    if (entry instanceof Entry.Happened happened
        && happened.event() instanceof SimEvent.ForDrone event) {
      rows.get(event.drone() - 1).take(event);
    } else if (entry instanceof Entry.Sent sent && sent.kind() == Kind.STATE) {
      rows.get(sent.drone() - 1).report(sent.text());
    }
  }

  private void write(FlightFiles to, Entry entry) {
    learn(entry);
    if (entry instanceof Entry.Sampled sampled) {
      for (DroneSnapshot drone : sampled.snapshot().drones()) {
        FlightRowState row = rows.get(drone.state().drone() - 1);
        if (drone.state().phase() == FlightPhase.OFF) {
          row.forgetCommands();
        }
        Sample sample = RecordingFormat.sample(sampled.snapshot().time(), drone, row);
        to.add(
            RecordingFile.FLIGHT,
            RecordingFormat.row(drone.state().drone(), sample, row.sticks(), row.sensors()));
      }
    } else {
      line(to, entry);
    }
  }

  private void line(FlightFiles to, Entry entry) {
    if (entry instanceof Entry.Happened happened) {
      to.add(RecordingFile.EVENTS, RecordingFormat.line(happened));
    } else if (entry instanceof Entry.Input input
        && input.input() instanceof SimInput.Datagram datagram) {
      to.add(RecordingFile.WIRE, RecordingFormat.line(input, datagram, to.begun()));
    } else if (entry instanceof Entry.Sent sent) {
      source.sent(sent, to, films);
      to.add(RecordingFile.WIRE, lines.line(sent, to.begun()));
    }
  }

  private void end(Entry.End end) throws IOException {
    flight = false;
    List<VideoRecorders.RecordedVideo> kept = films.end();
    if (files.isPresent()) {
      files.get().finish(end, kept);
      folder.finished(files.get().folder());
      files = Optional.empty();
    }
  }

  private void flush() {
    try {
      if (files.isPresent()) {
        files.get().flush();
      }
    } catch (IOException e) {
      fail(e);
    }
  }

  private void overrun() {
    if (files.isPresent()) {
      Phrase reason =
          Phrase.of(
              "the recording %s ended, because too much waited to be written",
              files.get().folder());
      giveUp(reason);
    }
  }

  private void fail(IOException e) {
    Path where = files.map(FlightFiles::folder).orElse(folder.path());
    giveUp(
        Phrase.of(
            "the recording %s ended, because it cannot be written: %s", where, IoReason.of(e)));
  }

  private void giveUp(Phrase reason) {
    films.end();
    if (files.isPresent()) {
      closeQuietly(files.get());
      folder.finished(files.get().folder());
      files = Optional.empty();
    }
    tell(reason);
  }

  private void closeQuietly(FlightFiles left) {
    try {
      left.close();
    } catch (IOException e) {
      LOG.debug("Closing {} failed: {}", left.folder(), e.toString());
    }
  }

  private void tell(Phrase reason) {
    LOG.warn("{}", reason.english());
    told.accept(reason);
  }

  @Override
  public ErrorPolicy onError(Throwable failure) {
    return failed;
  }

  /** Writes all waiting entries. */
  void writeWaiting() {
    boolean more = true;
    while (more) {
      more = work();
    }
  }

  /** Writes the remaining entries. */
  @Override
  public void onClose() {
    writeWaiting();
    films.end();
    files.ifPresent(this::closeQuietly);
  }
}
