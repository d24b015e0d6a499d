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
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.words.Phrase;

/**
 * Writes what the recorder saw. An error ends the recording of the flight, with a sentence; the
 * next flight is tried anew. For a thread of its own.
 */
final class RecordingWriter implements Agent {

  private static final Logger LOG = LoggerFactory.getLogger(RecordingWriter.class);

  /**
   * From writing to writing [ns]. Decided: a program that is killed loses half a second at most.
   */
  private static final long PERIOD = 250_000_000;

  /** What is taken before it is handed to the system, however much waits. */
  private static final int AT_ONCE = 20_000;

  /** Lines of what came before a takeoff that belong to the flight. Decided. */
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

  /** Whether a flight has begun, even if it cannot be recorded. */
  private boolean flight;

  /**
   * Where a recorder puts what it sees.
   *
   * @param queue what waits to be written
   * @param films what drones film
   * @param inputs what came to the simulation, until what waits
   */
  record Sources(EntryQueue queue, VideoRecorders films, InputHistory inputs) {}

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

  /** Takes what waits, but no more than may be lost. */
  private boolean work() {
    boolean more = true;
    for (int i = 0; more && i < AT_ONCE; i++) {
      Optional<Entry> next = queue.poll();
      more = next.isPresent();
      next.ifPresent(this::take);
    }
    flush();
    return more;
  }

  private void take(Entry entry) {
    try {
      Optional<String> input = inputs.take(entry);
      if (files.isPresent() && input.isPresent()) {
        files.get().input(input.get());
      }
      if (entry instanceof Entry.Begin begin) {
        begin(begin);
      } else if (entry instanceof Entry.End end) {
        end(end);
      } else if (entry instanceof Entry.Overrun) {
        overrun();
      } else if (entry instanceof Entry.Anew) {
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

  /** Keeps what may belong to the next flight. */
  private void keep(Entry entry) {
    learn(entry);
    boolean line =
        entry instanceof Entry.Happened
            || entry instanceof Entry.Received
            || (entry instanceof Entry.Sent sent && sent.kind() == Kind.REPLY);
    if (line && !flight) {
      before.addLast(entry);
      if (before.size() > MOST_BEFORE) {
        before.removeFirst();
      }
    }
  }

  /** What later rows of the table tell. */
  private void learn(Entry entry) {
    if (entry instanceof Entry.Happened happened
        && happened.event() instanceof SimEvent.ForDrone event) {
      rows.get(event.drone() - 1).take(event);
    } else if (entry instanceof Entry.Sent sent && sent.kind() == Kind.STATE) {
      rows.get(sent.drone() - 1).report(RecordingFormat.text(sent));
    }
  }

  private void write(FlightFiles to, Entry entry) throws IOException {
    learn(entry);
    if (entry instanceof Entry.Sampled sampled) {
      for (DroneSnapshot drone : sampled.snapshot().drones()) {
        FlightRowState row = rows.get(drone.state().drone() - 1);
        if (drone.state().phase() == FlightPhase.OFF) {
          row.forgetCommands();
        }
        RecordingFormat.write(to.table().row(), sampled.snapshot().time(), drone, row);
      }
      to.flushIfLarge(to.table());
    } else {
      line(to, entry);
    }
  }

  private void line(FlightFiles to, Entry entry) throws IOException {
    if (entry instanceof Entry.Happened happened) {
      RecordingFormat.write(to.events().row(), happened);
      to.flushIfLarge(to.events());
    } else if (entry instanceof Entry.Received received) {
      lines.write(to.wire().row(), received, to.begun());
      to.flushIfLarge(to.wire());
    } else if (entry instanceof Entry.Sent sent) {
      source.sent(sent, films);
      lines.write(to.wire().row(), sent, to.begun());
      to.flushIfLarge(to.wire());
    }
  }

  private void end(Entry.End end) throws IOException {
    flight = false;
    List<VideoRecorders.Kept> kept = films.end();
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

  /** Writes all that waits. */
  void writeWaiting() {
    boolean more = true;
    while (more) {
      more = work();
    }
  }

  /** Writes what still waits. */
  @Override
  public void onClose() {
    writeWaiting();
    films.end();
    files.ifPresent(this::closeQuietly);
  }
}
