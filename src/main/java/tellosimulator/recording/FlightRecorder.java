package tellosimulator.recording;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.concurrent.Worker;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.math.Vec3;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.WireTap;
import tellosimulator.recording.Entry.Ends;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimInput;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.time.SimTime;
import tellosimulator.time.WallTime;
import tellosimulator.video.VideoStreams;
import tellosimulator.words.Phrase;

/**
 * Records the flights of a simulation. Each flight is recorded into its own folder. {@link
 * FlightDetector} decides when a flight begins and ends. A flight also ends when the simulation
 * starts a new run or closes.
 *
 * <p>The simulation, network and video threads call the recorder, which only adds records to a
 * queue. {@link #setRecording} and {@link #close} are thread-safe.
 */
public final class FlightRecorder implements SimListener, WireTap, AutoCloseable {

  /** Number of steps between samples. Decided: 20 samples per simulated second. */
  private static final long SAMPLE_STEPS = Math.round(0.05 / SimTime.STEP);

  /**
   * Maximum weight of the entries that a recorder keeps in memory. Decided: 35 MB, enough for half
   * an hour of flight of one drone.
   */
  private static final long MOST_REMEMBERED = 100_000;

  private final EntryQueue queue;
  private final RecordingWriter.Sources sources;
  private final Subject subject;

  /**
   * The writer of a stepped recorder; empty if a worker writes, or if flights are kept in memory.
   */
  private final Optional<RecordingWriter> writer;

  private final Optional<Worker> worker;
  private final GoalWatch goals;
  private volatile Supplier<SimTime> clock = () -> SimTime.ZERO;
  private volatile Supplier<SimSnapshot> snapshots = () -> null;
  private volatile boolean recording;
  private volatile boolean flown;

  /** The initial conditions of the simulation; empty if unknown. */
  private final AtomicReference<Optional<InitialConditions>> start =
      new AtomicReference<>(Optional.empty());

  /** Whether the simulation has received any input since it began. */
  private volatile boolean begun;

  /** Detects flights. This field and all fields below it are confined to the simulation thread. */
  private final FlightDetector detector = new FlightDetector();

  /** Whether an input of the current run has not been recorded. */
  private boolean missed;

  private long steps;

  /**
   * The end of the last step [ns]. It is stored as a primitive value, because it changes with each
   * step.
   */
  private long lastNanos;

  private Progress progress;
  private long attemptNanos;

  /**
   * The subject of a recording.
   *
   * @param title title of the scenario, or the name of its file
   * @param scenario the scenario flown; its room and starting poses may be changed between flights
   * @param options the command-line arguments, as far as they are known
   * @param goals evaluates the goals; must be notified of each step before the recorder
   */
  public record Subject(String title, Scenario scenario, List<String> options, GoalWatch goals) {

    public Subject {
      options = List.copyOf(options);
    }
  }

  private FlightRecorder(
      Subject subject,
      RecordingWriter.Sources sources,
      Optional<RecordingWriter> writer,
      Optional<Worker> worker) {
    this.subject = subject;
    this.sources = sources;
    this.queue = sources.queue();
    this.goals = subject.goals();
    this.progress = goals.progress();
    this.writer = writer;
    this.worker = worker;
  }

  /**
   * Starts a recorder. Once attached to a simulation, it waits for the first takeoff.
   *
   * @param folder the folder that will contain a folder for each flight
   * @param told receives a sentence for users when recording a flight or a drone's video fails;
   *     called on the recorder's thread or on a drone's video thread
   */
  public static FlightRecorder start(
      RecordingFolder folder, Subject subject, Consumer<Phrase> told) {
    return start(folder, subject, told, new EntryQueue());
  }

  static FlightRecorder start(
      RecordingFolder folder, Subject subject, Consumer<Phrase> told, EntryQueue queue) {
    int drones = subject.scenario().config().drones().size();
    var sources = new RecordingWriter.Sources(queue, drones);
    RecordingWriter writer = writer(sources, folder, subject, told);
    return new FlightRecorder(
        subject, sources, Optional.empty(), Optional.of(Worker.start("recorder", writer)));
  }

  private static RecordingWriter writer(
      RecordingWriter.Sources sources,
      RecordingFolder folder,
      Subject subject,
      Consumer<Phrase> told) {
    var source = new FlightSource.Simulated(subject, sources.inputs());
    return new RecordingWriter(sources, folder, source, told);
  }

  /**
   * Creates a recorder that writes only on request ({@link #writeWaiting}). It is meant for callers
   * that step a simulation faster than a disk can write: they wait while the recorder writes. It
   * records no video.
   *
   * @param told receives a sentence for users when recording a flight fails
   */
  public static FlightRecorder stepped(
      RecordingFolder folder, Subject subject, Consumer<Phrase> told) {
    var sources = new RecordingWriter.Sources(new EntryQueue(Long.MAX_VALUE), 0);
    RecordingWriter writer = writer(sources, folder, subject, told);
    return new FlightRecorder(subject, sources, Optional.of(writer), Optional.empty());
  }

  /**
   * Creates a recorder that keeps flights in memory, for callers that decide afterwards whether to
   * write them with {@link #writeTo}. It records no video, and keeps at most half an hour of flight
   * of one drone.
   */
  public static FlightRecorder inMemory(Subject subject) {
    var sources = new RecordingWriter.Sources(new EntryQueue(MOST_REMEMBERED), 0);
    return new FlightRecorder(subject, sources, Optional.empty(), Optional.empty());
  }

  /** Starts to observe a simulation, its datagrams and its drones' videos. */
  public void attach(OnlineSimulation simulation, VideoStreams streams) {
    attach(simulation);
    sources.films().watch(streams, simulation::time);
  }

  /**
   * Starts to observe a simulation and its datagrams, but no video. Flights can be replayed only if
   * the simulation has not received any input yet.
   */
  public void attach(OnlineSimulation simulation) {
    follow(simulation::time, simulation::snapshot);
    begin(simulation.config(), simulation.replyPort());
    simulation.listen(this);
    simulation.setTap(this);
    if (!simulation.untouched()) {
      queue.add(new Entry.Missed());
    }
  }

  /**
   * Starts to observe a simulation that has received no input yet. The owner of the simulation
   * steps it, and must also pass all sent datagrams to {@link #sent}.
   *
   * @param replyPort port to which all replies go; if empty, each reply goes to the port that its
   *     command came from
   */
  public void attach(Simulation simulation, OptionalInt replyPort) {
    follow(simulation::time, simulation::snapshot);
    begin(simulation.config(), replyPort);
    simulation.listen(this);
  }

  private void begin(SimConfig config, OptionalInt replyPort) {
    start.set(Optional.of(new InitialConditions(config, goals.progress().challenge(), replyPort)));
    begun = false;
    queue.add(new Entry.NewRun(start.get()));
  }

  /**
   * Sets the sources of the time and of the latest snapshot, for callers that pass on steps, events
   * and datagrams themselves. Flights recorded in this way cannot be replayed.
   */
  public void follow(Supplier<SimTime> newClock, Supplier<SimSnapshot> newSnapshots) {
    clock = newClock;
    snapshots = newSnapshots;
    begun = true;
    recording = true;
  }

  /**
   * Sets whether flights are recorded; when recording is switched off, a flight in progress ends
   * with the next step.
   */
  public void setRecording(boolean wanted) {
    recording = wanted;
  }

  /**
   * Records a new challenge, which the caller must also pass to {@link GoalWatch#ask}. Must be
   * called while no drone is flying and, if a drone has flown, before all drones are put back.
   * Thread-safe.
   */
  public void ask(Challenge challenge) {
    start.updateAndGet(from -> from.map(before -> before.withChallenge(challenge)));
    queue.add(new Entry.Asked(challenge));
  }

  // --- recorders in memory ---

  /** Whether a drone has taken off since the start, or since {@link #forget}. Thread-safe. */
  public boolean hasFlown() {
    return flown;
  }

  /**
   * Discards all flights recorded until now. Must be called immediately after a new run has begun.
   * Thread-safe.
   */
  public void forget() {
    queue.takeEarlier(sources.inputs()::take);
    flown = false;
  }

  /**
   * Writes all flights recorded until now and then discards them. Only for a recorder in memory;
   * must be called on a thread that has waited for the simulation ({@link
   * OnlineSimulation#settle}).
   *
   * @param told receives a sentence if writing fails
   */
  public void writeTo(RecordingFolder folder, Consumer<Phrase> told) {
    queue.add(new Entry.End(clock.get(), progress, attemptNanos));
    writer(sources, folder, subject, told).onClose();
    flown = false;
  }

  // --- network ---

  @Override
  public void sent(
      int drone, Kind kind, InetSocketAddress from, InetSocketAddress to, byte[] bytes) {
    if (recording) {
      Ends ends = new Ends(from, to);
      queue.add(new Entry.Sent(clock.get(), WallTime.nanoTime(), drone, kind, ends, bytes));
    }
  }

  // --- simulation ---

  /** Returns whether inputs are recorded now; if not, marks the gap for later flights. */
  private boolean takes() {
    begun = true;
    if (!recording) {
      end(last()); // ends before the gap, so that the flight does not contain it
      miss();
    }
    return recording;
  }

  private void miss() {
    if (!missed) {
      missed = true;
      queue.add(new Entry.Missed());
    }
  }

  @Override
  public void onInput(SimTime now, SimInput input) {
    if (input instanceof SimInput.Act act && act.control() instanceof Control.NewRun restart) {
      start.updateAndGet(
          from ->
              from.map(
                  before ->
                      new InitialConditions(
                          restart.config(), before.challenge(), before.replyPort())));
    } else if (takes()) {
      queue.add(new Entry.Input(now, WallTime.nanoTime(), input));
    }
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.RunStarted) {
      end(last());
      lastNanos = event.time().nanos();
      missed = false;
      begun = start.get().isEmpty();
      queue.add(new Entry.NewRun(start.get()));
      return;
    }
    if (!recording || !begun) {
      return;
    }
    SimSnapshot snapshot = snapshots.get();
    if (detector.begins(event)) {
      flown = true;
      steps = 0;
      queue.add(new Entry.Begin(WallTime.now(), snapshot));
    }
    queue.add(new Entry.Happened(event, place(event, snapshot)));
    if (detector.ends(event, snapshot)) {
      end(event.time());
    }
  }

  private static Optional<Vec3> place(SimEvent event, SimSnapshot snapshot) {
    return event instanceof SimEvent.ForDrone one
        ? Optional.of(snapshot.drones().get(one.drone() - 1).state().motion().position())
        : Optional.empty();
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    lastNanos = snapshot.time().nanos();
    if (!detector.flying()) {
      return;
    }
    if (!recording) {
      end(last());
      miss(); // later flights lack the inputs of the rest of this one
      return;
    }
    judge(goals.progress());
    if (steps++ % SAMPLE_STEPS == 0) {
      queue.add(new Entry.Sampled(snapshot));
      if (detector.ends(snapshot)) {
        end(last());
      }
    }
  }

  private SimTime last() {
    return new SimTime(lastNanos);
  }

  /** Updates the progress of the goals and the start of the attempt. */
  @SuppressWarnings("ReferenceEquality") // compared in each step
  private void judge(Progress now) {
    if (now == progress) {
      return; // for example, if there are no goals
    }
    progress = now;
    if (now.status() == Progress.Status.RUNNING) {
      attemptNanos = lastNanos - Math.round(now.elapsed() * 1e9);
    }
  }

  private void end(SimTime time) {
    if (detector.flying()) {
      detector.end();
      queue.add(new Entry.End(time, progress, attemptNanos));
    }
  }

  /** Writes all queued records on the calling thread; only for a stepped recorder. */
  public void writeWaiting() {
    writer.ifPresent(RecordingWriter::writeWaiting);
  }

  /**
   * Ends the current flight and writes all queued records. Must be called after the simulation has
   * closed; otherwise the last records may be missing.
   */
  @Override
  public void close() {
    progress = goals.progress(); // a drone that is still in the air may have cost points
    end(last());
    recording = false;
    worker.ifPresent(Worker::end);
    queue.wake();
    worker.ifPresent(Worker::close);
    writer.ifPresent(RecordingWriter::onClose);
  }
}
