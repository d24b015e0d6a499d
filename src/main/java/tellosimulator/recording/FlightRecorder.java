package tellosimulator.recording;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.command.Peer;
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
 * Records the flights of a simulation, each into a folder of its own. Where one begins and ends
 * decides {@link FlightDetector}; the simulation ends it, too, when it begins anew or is over.
 *
 * <p>It is told on the threads of simulation, network and video, on which it only puts records into
 * a queue; {@link #setRecording} and {@link #close} are for any thread.
 */
public final class FlightRecorder implements SimListener, WireTap, AutoCloseable {

  /** Steps from sample to sample: 20 a simulated second. Decided. */
  private static final long SAMPLE_STEPS = Math.round(0.05 / SimTime.STEP);

  /** Weight of what is only remembered. Decided: 35 MB, and half an hour of one drone. */
  private static final long MOST_REMEMBERED = 100_000;

  private final EntryQueue queue;
  private final RecordingWriter.Sources sources;
  private final Subject subject;

  /** Writes when it is told to; empty if a worker writes, or nobody yet. */
  private final Optional<RecordingWriter> writer;

  private final Optional<Worker> worker;
  private final GoalWatch goals;
  private volatile Supplier<SimTime> clock = () -> SimTime.ZERO;
  private volatile Supplier<SimSnapshot> snapshots = () -> null;
  private volatile boolean recording;
  private volatile boolean flown;

  /** What the simulation began from; empty if that is not known. */
  private final AtomicReference<Optional<InitialConditions>> start =
      new AtomicReference<>(Optional.empty());

  /** Whether something was done since the simulation began. */
  private volatile boolean begun;

  /** This and all that follows is for the simulation thread. */
  private final FlightDetector detector = new FlightDetector();

  /** Whether there was an input that is not recorded. */
  private boolean missed;

  private long steps;

  /** The end of the last step [ns]; a number, as it changes in each. */
  private long lastNanos;

  private Progress progress;
  private long attemptNanos;

  /**
   * What is recorded.
   *
   * @param title of the scenario, or the name of its file
   * @param scenario that is flown; room and starts may be changed in between
   * @param options words of the command line, as far as they are known
   * @param goals judges the drones, and is told of each step before the recorder
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
   * Waits for a first takeoff, once it is attached to a simulation.
   *
   * @param folder in which there will be a folder for each flight
   * @param told takes a sentence for people when a flight, or a drone's film, cannot be recorded
   *     any more; on the recorder's thread or a drone's video thread
   */
  public static FlightRecorder start(
      RecordingFolder folder, Subject subject, Consumer<Phrase> told) {
    return start(folder, subject, told, new EntryQueue());
  }

  static FlightRecorder start(
      RecordingFolder folder, Subject subject, Consumer<Phrase> told, EntryQueue queue) {
    VideoRecorders films = new VideoRecorders(subject.scenario().config().drones().size());
    var sources = new RecordingWriter.Sources(queue, films, new InputHistory());
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
   * One that writes when it is told to ({@link #writeWaiting}), for somebody who steps a simulation
   * faster than any disk, and waits for it. It keeps no film.
   *
   * @param told takes a sentence for people when a flight cannot be recorded any more
   */
  public static FlightRecorder stepped(
      RecordingFolder folder, Subject subject, Consumer<Phrase> told) {
    var sources =
        new RecordingWriter.Sources(
            new EntryQueue(Long.MAX_VALUE), new VideoRecorders(0), new InputHistory());
    RecordingWriter writer = writer(sources, folder, subject, told);
    return new FlightRecorder(subject, sources, Optional.of(writer), Optional.empty());
  }

  /**
   * One that only remembers, for somebody who decides afterwards whether anything is written, by
   * {@link #writeTo}. It keeps no film, and no more than half an hour of one drone.
   */
  public static FlightRecorder inMemory(Subject subject) {
    var sources =
        new RecordingWriter.Sources(
            new EntryQueue(MOST_REMEMBERED), new VideoRecorders(0), new InputHistory());
    return new FlightRecorder(subject, sources, Optional.empty(), Optional.empty());
  }

  /** Looks at a simulation from now on, with its wire and its drones' films. */
  public void attach(OnlineSimulation simulation, VideoStreams streams) {
    attach(simulation);
    sources.films().watch(streams, simulation::time);
  }

  /**
   * Looks at a simulation from now on, with its wire, but without films. Flights can be flown again
   * if nothing was done to it before.
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
   * Looks at a simulation that its owner steps, and to which nothing was done yet; the owner hands
   * over what is on its wire.
   *
   * @param replyPort port to which all replies go; empty for the port each command came from
   */
  public void attach(Simulation simulation, OptionalInt replyPort) {
    follow(simulation::time, simulation::snapshot);
    begin(simulation.config(), replyPort);
    simulation.listen(this);
  }

  private void begin(SimConfig config, OptionalInt replyPort) {
    start.set(Optional.of(new InitialConditions(config, goals.progress().challenge(), replyPort)));
    begun = false;
    queue.add(new Entry.Anew(start.get()));
  }

  /**
   * Whom to ask for the time and for the newest snapshot, where somebody else hands over steps,
   * events and datagrams. Its flights cannot be flown again.
   */
  public void follow(Supplier<SimTime> newClock, Supplier<SimSnapshot> newSnapshots) {
    clock = newClock;
    snapshots = newSnapshots;
    begun = true;
    recording = true;
  }

  /** Whether flights are recorded; if not, one that has begun ends with the next step. */
  public void setRecording(boolean wanted) {
    recording = wanted;
  }

  /**
   * Something else is asked of the drones, as {@link GoalWatch#ask} says it: while none flies, and
   * before all of them are put back if one has flown. For any thread.
   */
  public void ask(Challenge challenge) {
    start.updateAndGet(from -> from.map(before -> before.withChallenge(challenge)));
    queue.add(new Entry.Asked(challenge));
  }

  // --- what is only remembered ---

  /** Whether a drone has taken off since the start, or since {@link #forget}. For any thread. */
  public boolean hasFlown() {
    return flown;
  }

  /** Forgets all flights until now. When the simulation has just begun anew; for any thread. */
  public void forget() {
    queue.takeEarlier(sources.inputs()::take);
    flown = false;
  }

  /**
   * Writes all flights until now, and forgets them. For one that only remembers, on any thread that
   * has waited for the simulation ({@link OnlineSimulation#settle}).
   *
   * @param told takes a sentence if something cannot be written
   */
  public void writeTo(RecordingFolder folder, Consumer<Phrase> told) {
    queue.add(new Entry.End(clock.get(), new GoalResult(progress, attemptNanos)));
    writer(sources, folder, subject, told).onClose();
    flown = false;
  }

  // --- network ---

  @Override
  public void received(int drone, Peer peer, String text) {
    if (takes()) {
      Ends ends = new Ends(peer.address(), peer.via());
      queue.add(new Entry.Received(clock.get(), WallTime.nanoTime(), drone, ends, text));
    }
  }

  @Override
  public void sent(
      int drone, Kind kind, InetSocketAddress from, InetSocketAddress to, byte[] bytes) {
    if (recording) {
      Ends ends = new Ends(from, to);
      queue.add(new Entry.Sent(clock.get(), WallTime.nanoTime(), drone, kind, ends, bytes));
    }
  }

  // --- simulation ---

  /** Whether an input is taken; if not, those who come later know that one is missing. */
  private boolean takes() {
    begun = true;
    if (!recording) {
      end(last()); // before the gap, which would otherwise be within the flight
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
  public void taken(SimTime now, SimInput input) {
    if (input instanceof SimInput.Act act && act.control() instanceof Control.Restart restart) {
      start.updateAndGet(
          from ->
              from.map(
                  before ->
                      new InitialConditions(
                          restart.config(), before.challenge(), before.replyPort())));
    } else if (!(input instanceof SimInput.Datagram) && takes()) { // those come from the wire
      queue.add(new Entry.Taken(now, input));
    }
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.Restarted) {
      end(last());
      lastNanos = event.time().nanos();
      missed = false;
      begun = start.get().isEmpty();
      queue.add(new Entry.Anew(start.get()));
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
      miss(); // the rest of this flight, for those that follow
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

  /** Notes how far the goals are, and when the try at them began. */
  @SuppressWarnings("ReferenceEquality") // it is asked in each step
  private void judge(Progress now) {
    if (now == progress) {
      return; // such as without goals
    }
    progress = now;
    if (now.status() == Progress.Status.RUNNING) {
      attemptNanos = lastNanos - Math.round(now.elapsed() * 1e9);
    }
  }

  private void end(SimTime time) {
    if (detector.flying()) {
      detector.end();
      queue.add(new Entry.End(time, new GoalResult(progress, attemptNanos)));
    }
  }

  /** Writes all that waits, on the thread that calls it; for one that is stepped. */
  public void writeWaiting() {
    writer.ifPresent(RecordingWriter::writeWaiting);
  }

  /**
   * Ends the flight that is recorded, and writes what waits. After the simulation, or the last
   * things may be missing.
   */
  @Override
  public void close() {
    end(last());
    recording = false;
    worker.ifPresent(Worker::end);
    queue.wake();
    worker.ifPresent(Worker::close);
    writer.ifPresent(RecordingWriter::onClose);
  }
}
