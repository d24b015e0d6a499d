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

/**
 * A simulator for tests: drones that are on and listen on loopback, whose time runs as fast as the
 * machine can unless it is told otherwise.
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

  /** How long a fall may take by the wall clock. Decided: longer than from any ceiling. */
  private static final Duration LONGEST_FALL = Duration.ofSeconds(5);

  private final FlightMonitor monitor;
  private final GoalWatch goals;

  /** Remembers the flights of a test. */
  private final FlightRecorder recorder;

  private final SimConfig config;
  private final OnlineSimulation online;

  /** Programs that a test has named and not run yet. */
  private final List<OperatorProgram> unstarted = new CopyOnWriteArrayList<>();

  private final List<SimulatedDrone> drones = new ArrayList<>();
  private final TelloSimulation simulation = new TelloSimulation(this);

  /** What is done at the end. */
  private final Runnable end;

  private volatile boolean closed;

  /** What is simulated, and the way to start it. */
  public static final class Builder extends SimulatorSettings<Builder> {

    private Builder() {}

    @Override
    Builder self() {
      return this;
    }

    /**
     * Starts with all drones on.
     *
     * @throws IllegalArgumentException with a sentence, if the settings make no sense
     * @throws IllegalStateException with a sentence, if the ports cannot be had
     */
    public TelloSimulator start() {
      return new TelloSimulator(this);
    }
  }

  /** What can be said before the start. */
  public static Builder builder() {
    return new Builder();
  }

  /** Starts one drone in an empty room. */
  public static TelloSimulator start() {
    return builder().start();
  }

  /** Starts a scenario: a file, or one of those that come with the program. */
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
            List.of(goals, monitor)); // who waits on the monitor then finds the goals judged
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
   * For a simulation that runs already, such as that of the program without a window; closing what
   * is returned does not end it.
   *
   * @param goals listens to the simulation
   * @hidden for the program itself, and of no use to tests
   */
  @SuppressWarnings("InvalidBlockTag") // it is allowed on methods
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

  /** All on 127.0.0.1 where ports are free ones, since some systems have no other address. */
  private static AddressPlan plan(PortChoice ports, int count) {
    return ports == PortChoice.REAL
        ? AddressPlan.ofMachine(count, AddressPlan.REAL_COMMAND_PORT)
        : AddressPlan.portPerDrone(count, List.of(InetAddress.getLoopbackAddress()), 0);
  }

  /** The only drone, or the first one. */
  public SimulatedDrone drone() {
    return drones.get(0);
  }

  /**
   * A drone.
   *
   * @param number from 1
   * @throws IllegalArgumentException if there is no such drone
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

  /** All drones, in the order of their numbers. */
  public List<SimulatedDrone> drones() {
    return List.copyOf(drones);
  }

  /** Time, goals and weather. */
  public TelloSimulation simulation() {
    return simulation;
  }

  /**
   * Begins anew: drones stand at their starts as at first, nobody commands them, their journals are
   * empty, and the same commands have the same effects as before.
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
   * What happened, for people: the last command of each drone, where it is and what it did, what is
   * left to be reached, and below all that came to it.
   */
  public String explanation() {
    return FlightExplanation.of(this);
  }

  /**
   * Ends it; its ports are free afterwards.
   *
   * @throws IllegalStateException if it was closed already
   */
  @Override
  public void close() {
    checkOpen();
    closeOnce();
  }

  /** Ends it, unless it was closed already. */
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

  // --- for the kit ---

  /** Remembers what drones fly, once it is told to. */
  FlightRecorder recorder() {
    return recorder;
  }

  /** Remembers what drones fly from now on. */
  void remember() {
    recorder.attach(online);
  }

  FlightMonitor monitor() {
    return monitor;
  }

  /** Lets the monitor know all that programs have seen; nothing changes after the end. */
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

  /** A program was named that is to be run. */
  void named(OperatorProgram program) {
    unstarted.add(program);
  }

  /** It is run. */
  void started(OperatorProgram program) {
    unstarted.remove(program);
  }

  /** Programs that were named since the last reset and never run. */
  List<OperatorProgram> unstarted() {
    return List.copyOf(unstarted);
  }

  /** Waits until drones that fall lie on the ground, so that it is known whether they crashed. */
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

  /** What is thrown when something did not come about. */
  AssertionError failure(String what) {
    return new FlightFailure(what, explanation());
  }
}
