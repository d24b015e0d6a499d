package tellosimulator.junit;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import tellosimulator.goal.GoalEvent;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.words.Phrase;

/**
 * A simulator for tests. Its drones are switched on and listen on loopback. Simulated time passes
 * as fast as the machine allows, unless another time factor is set.
 *
 * <pre>{@code
 * try (TelloSimulator simulator = TelloSimulator.start("slalom")) {
 *   SimulatedDrone drone = simulator.drone();
 *   new MyProgram(drone.host(), drone.commandPort()).run();
 *   assertThat(drone).hasLanded().neverTouchedAnything();
 * }
 * }</pre>
 */
public final class TelloSimulator implements AutoCloseable {

  /**
   * Maximum wall clock time to wait until falling drones have reached the ground. Decided: longer
   * than a fall from any ceiling takes.
   */
  private static final Duration LONGEST_FALL = Duration.ofSeconds(5);

  private final FlightMonitor monitor;
  private final GoalWatch goals;

  /** Records the flights of the current test, so that recordings and reports can be published. */
  private final FlightRecorder recorder;

  private final SimConfig config;
  private final OnlineSimulation online;

  /** Programs that a test has created but not yet run. */
  private final List<OperatorProgram> unstarted = new CopyOnWriteArrayList<>();

  private final List<SimulatedDrone> drones = new ArrayList<>();
  private final TelloSimulation simulation = new TelloSimulation(this);

  /** Closes all parts of the simulator. */
  private final Runnable end;

  private volatile boolean closed;

  /** The settings of a simulator, with the method that starts it. */
  public static final class Builder extends SimulatorSettings<Builder> {

    private Builder() {}

    @Override
    Builder self() {
      return this;
    }

    /**
     * Starts a simulator with these settings and all drones switched on.
     *
     * @throws IllegalArgumentException if a setting is invalid; the message names the setting or
     *     lists the errors in the scenario file
     * @throws IllegalStateException if the ports are not available; the message is one sentence
     */
    public TelloSimulator start() {
      return new TelloSimulator(this);
    }
  }

  /** Returns a builder with default settings. */
  public static Builder builder() {
    return new Builder();
  }

  /** Starts a simulator with one drone in an empty room. */
  public static TelloSimulator start() {
    return builder().start();
  }

  /** Starts a simulator with a scenario: a file, or one of those that come with the program. */
  public static TelloSimulator start(String scenario) {
    return builder().scenario(scenario).start();
  }

  TelloSimulator(SimulatorSettings<?> settings) {
    Scenario scenario = settings.scenario();
    int count = scenario.config().drones().size();
    monitor = new FlightMonitor(scenario.config().arena().obstacles(), count);
    goals = new GoalWatch(scenario.challenge(), this::record);
    PortReservation reservation = PortReservation.of(settings.ports(), 2 * count);
    List<StreamPorts> streamPorts = streamPorts(settings.ports(), count, reservation.ports());
    config = SimulatorSettings.withStreamPorts(scenario.config(), streamPorts);
    online =
        new OnlineSimulation(
            config,
            plan(settings.ports(), count),
            OptionalInt.empty(),
            List.of(goals, monitor)); // goals first, so that they are up to date when waiters wake
    monitor.attach(online::snapshot);
    recorder = recorder(scenario, config, goals);
    Optional<VideoStreams> video =
        settings.video()
            ? Optional.of(
                VideoStreams.of(online, new SoftwareCameras(DroneOptics.DEFAULT), H264Encoder::new))
            : Optional.empty();
    end =
        () -> {
          video.ifPresent(VideoStreams::close);
          online.close();
          reservation.close();
        };
    try {
      online.switchAllOn();
    } catch (PortTakenException e) {
      close();
      throw new IllegalStateException(
          settings.ports() == PortChoice.REAL ? withoutRealPorts(e) : e.getMessage(), e);
    }
    addDrones();
  }

  private static FlightRecorder recorder(Scenario scenario, SimConfig config, GoalWatch goals) {
    return FlightRecorder.inMemory(
        new FlightRecorder.Subject(
            scenario.description().name().english(),
            scenario.withConfig(config),
            List.of(),
            goals));
  }

  private void record(GoalEvent news) {
    recorder.event(news);
  }

  private static String withoutRealPorts(PortTakenException taken) {
    return String.format(
        Locale.ROOT,
        "ports = REAL needs port %d of %s, which another program has: end that program, or use the"
            + " ports that ports = FREE gives",
        taken.address().getPort(),
        taken.address().getAddress().getHostAddress());
  }

  private TelloSimulator(OnlineSimulation online, Scenario scenario, GoalWatch goals) {
    this.online = online;
    this.goals = goals;
    config = scenario.config();
    monitor = new FlightMonitor(config.arena().obstacles(), config.drones().size());
    monitor.attach(online::snapshot);
    online.listen(monitor);
    recorder = recorder(scenario, config, goals);
    end = () -> {};
    addDrones();
  }

  /**
   * Wraps a running simulation, such as that of the program when it runs without a window. Closing
   * the returned simulator does not stop the simulation.
   *
   * @param goals the goals, already registered as a listener of the simulation
   * @hidden internal to the program, and of no use to tests
   */
  @SuppressWarnings("InvalidBlockTag") // this tag is allowed on methods
  public static TelloSimulator of(OnlineSimulation online, Scenario scenario, GoalWatch goals) {
    return new TelloSimulator(online, scenario, goals);
  }

  private void addDrones() {
    for (DroneSetup setup : config.drones()) {
      drones.add(new SimulatedDrone(this, drones.size() + 1, setup.streamPorts()));
    }
  }

  private static List<StreamPorts> streamPorts(PortChoice ports, int count, List<Integer> free) {
    List<StreamPorts> streamPorts = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      streamPorts.add(
          ports == PortChoice.REAL
              ? StreamPorts.DEFAULT
              : new StreamPorts(free.get(2 * i), free.get(2 * i + 1)));
    }
    return streamPorts;
  }

  /**
   * Returns the addresses on which the drones receive commands. With free ports, all drones share
   * 127.0.0.1, because some systems have no other loopback address.
   */
  private static AddressPlan plan(PortChoice ports, int count) {
    return ports == PortChoice.REAL
        ? AddressPlan.ofMachine(count, AddressPlan.REAL_COMMAND_PORT)
        : AddressPlan.portPerDrone(count, List.of(InetAddress.getLoopbackAddress()), 0);
  }

  /** Returns the first drone, which is the only one by default. */
  public SimulatedDrone drone() {
    return drones.get(0);
  }

  /**
   * Returns a drone.
   *
   * @param number the number of the drone, from 1
   * @throws IllegalArgumentException if there is no drone with that number
   */
  public SimulatedDrone drone(int number) {
    if (number < 1 || number > drones.size()) {
      throw new IllegalArgumentException(
          drones.size() == 1
              ? "there is no drone " + number + ", only drone 1"
              : "there is no drone " + number + ", the drones are 1 to " + drones.size());
    }
    return drones.get(number - 1);
  }

  /** Returns all drones, in the order of their numbers. */
  public List<SimulatedDrone> drones() {
    return List.copyOf(drones);
  }

  /** Returns the simulation, with its time, goals, faults and wind. */
  public TelloSimulation simulation() {
    return simulation;
  }

  /**
   * Resets the simulation. All drones stand at their initial starts, have no operator, and have an
   * empty journal. The same commands have the same effects as before the reset.
   */
  public void reset() {
    checkOpen();
    unstarted.clear();
    try {
      online.restart(config);
    } catch (PortTakenException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  /**
   * Explains in words what happened: the last command, state and history of each drone, the goals,
   * and finally the complete journals.
   */
  public String explanation() {
    return FlightExplanation.of(this);
  }

  /**
   * Stops the simulator and frees its ports.
   *
   * @throws IllegalStateException if the simulator has already been closed
   */
  @Override
  public void close() {
    checkOpen();
    closeOnce();
  }

  /** Stops the simulator, unless it has already been closed. */
  void closeOnce() {
    if (closed) {
      return;
    }
    closed = true;
    end.run();
  }

  private void checkOpen() {
    if (closed) {
      throw new IllegalStateException("this simulator was closed already; start another one");
    }
  }

  // --- internal to the test kit ---

  /** Returns the recorder. It records only after a call to {@link #remember}. */
  FlightRecorder recorder() {
    return recorder;
  }

  /** Starts recording the flights. */
  void remember() {
    recorder.attach(online);
  }

  FlightMonitor monitor() {
    return monitor;
  }

  /**
   * Waits until the monitor has recorded everything that programs may already have observed. Does
   * nothing if the simulator is closed.
   */
  void settle() {
    if (!closed) {
      online.settle();
    }
  }

  SimSnapshot snapshot() {
    return online.snapshot();
  }

  Progress progress() {
    return goals.progress();
  }

  InetSocketAddress address(int drone) {
    return online.addresses(drone).get(0);
  }

  void carryOut(Control control) {
    checkOpen();
    try {
      online.carryOut(control);
    } catch (PortTakenException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  void letPass(double seconds) {
    checkOpen();
    online.letPass(seconds);
  }

  boolean awaitStill(Duration timeout) {
    checkOpen();
    try {
      return online.awaitStill(timeout);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  boolean closed() {
    return closed;
  }

  /** Registers a program that must be run before the test ends. */
  void named(OperatorProgram program) {
    unstarted.add(program);
  }

  /** Marks a registered program as run. */
  void started(OperatorProgram program) {
    unstarted.remove(program);
  }

  /** Returns the programs that have been created since the last reset but have not been run. */
  List<OperatorProgram> unstarted() {
    return List.copyOf(unstarted);
  }

  /** Waits until falling drones have reached the ground, so that crashes are known. */
  void awaitFalls() {
    settle();
    if (!closed && monitor.await(LONGEST_FALL, this::nobodyFalls).isPresent()) {
      settle();
    }
  }

  private Optional<Boolean> nobodyFalls() {
    return snapshot().drones().stream()
            .anyMatch(drone -> drone.state().phase() == FlightPhase.FALLING)
        ? Optional.empty()
        : Optional.of(true);
  }

  /**
   * Returns the error for an expectation that failed.
   *
   * @param what a description of the failure, with format specifiers for the values
   */
  AssertionError failure(String what, Object... values) {
    return new FlightFailure(Phrase.format(Locale.ROOT, what, values), explanation());
  }

  /** A failed expectation, with an explanation of what happened instead. */
  static final class FlightFailure extends AssertionError {

    private static final long serialVersionUID = 1;

    FlightFailure(String what, String explanation) {
      super(what + System.lineSeparator() + explanation);
    }
  }
}
