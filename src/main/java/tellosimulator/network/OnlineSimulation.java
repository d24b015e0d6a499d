package tellosimulator.network;

import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import tellosimulator.command.Peer;
import tellosimulator.command.PhotoCamera;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.sim.SimulationLoop;
import tellosimulator.time.SimTime;
import tellosimulator.time.Ticker;

/**
 * A simulation that runs at the pace of its clock. Programs can reach each drone over UDP while the
 * drone is on. Thread-safe, but must not be called on the simulation thread.
 */
public final class OnlineSimulation implements AutoCloseable {

  /**
   * Interval at which rejected datagrams are reported and the machine's addresses are looked up
   * [ns]. Decided.
   */
  private static final long WATCH_NANOS = 1_000_000_000;

  private final DroneNetwork network;
  private final OptionalInt replyPort;
  private final Simulation simulation;
  private final SimulationLoop loop;
  private final Ticker clock = new Ticker();
  private final Worker watch;
  private volatile Optional<SilenceWatch> silence = Optional.empty();
  private volatile Optional<VideoWatch> video = Optional.empty();
  private boolean closed;

  /**
   * Creates and starts a simulation with all drones off and all sockets closed.
   *
   * @param replyPort the port to which all replies go; empty for the port from which each command
   *     came
   * @param listeners notified on the simulation thread
   */
  public OnlineSimulation(
      SimConfig config, AddressPlan plan, OptionalInt replyPort, List<SimListener> listeners) {
    network = DroneNetwork.of(plan);
    this.replyPort = replyPort;
    simulation = new Simulation(config, network.senders(replyPort), listeners);
    loop = new SimulationLoop(simulation);
    network.listen(simulation);
    watch = Worker.start("network", new Watch());
  }

  /** Checks the network periodically. */
  private final class Watch implements Agent {

    private final ErrorPolicy failed = ErrorPolicy.goOn("The network could not be looked after");

    @Override
    public Outcome doWork() {
      if (clock.awaitTick(WATCH_NANOS)) {
        network.reportDropped();
        network.refresh();
        silence.ifPresent(SilenceWatch::look);
        video.ifPresent(VideoWatch::look);
      }
      return Outcome.WORKED;
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return failed;
    }
  }

  /** Returns the reach of the drones that listen on the machine's own addresses. */
  public Reach reach() {
    return network.reach();
  }

  /** Sets the reach. This takes effect immediately, even for drones that are on. */
  public void setReach(Reach reach) {
    network.setReach(reach);
  }

  /**
   * Switches all drones on. If the address or port of one of them cannot be opened, all sockets are
   * closed.
   *
   * @throws PortTakenException if an address or port cannot be opened
   */
  public synchronized void switchAllOn() throws PortTakenException {
    int drones = snapshot().drones().size();
    try {
      for (int drone = 1; drone <= drones; drone++) {
        network.open(drone);
      }
    } catch (PortTakenException e) {
      network.close();
      throw e;
    }
    for (int drone = 1; drone <= drones; drone++) {
      loop.carryOut(new Control.Power(drone, true));
    }
  }

  /**
   * Submits a control and waits until the snapshot includes its effect. {@link Control.Power} also
   * opens or closes the drone's sockets, so that a drone listens only while it is on.
   *
   * @throws IllegalArgumentException if there is no drone with that number
   * @throws PortTakenException if a drone cannot be switched on because one of its addresses or
   *     ports cannot be opened
   */
  public void carryOut(Control control) throws PortTakenException {
    if (control instanceof Control.Power power) {
      switchPower(power);
    } else {
      loop.carryOut(control);
    }
  }

  /**
   * Submits that the attempt at the goals ends, and does not wait. May also be called on the
   * simulation thread.
   */
  public void endAttempt() {
    simulation.control(new Control.EndAttempt());
  }

  /**
   * Lets a duration of simulated time [s] pass even if nothing is moving; at time factor {@code
   * max}, time would otherwise stand still. Does not wait for the duration to pass.
   */
  public void letPass(double seconds) {
    loop.carryOut(new Control.PassTime(seconds));
  }

  /**
   * Starts a new run with all drones on. The sockets of drones that were on remain open.
   *
   * @param config a configuration with as many drones as before
   * @throws PortTakenException if a drone was off and one of its addresses or ports cannot be
   *     opened
   */
  public synchronized void restart(SimConfig config) throws PortTakenException {
    loop.carryOut(new Control.NewRun(config));
    switchAllOn();
  }

  /**
   * Passes to the simulation all datagrams that have arrived at the sockets, then waits like {@link
   * SimulationLoop#settle}.
   */
  public void settle() {
    network.settle();
    loop.settle();
  }

  /**
   * Passes to the simulation all datagrams that have arrived at the sockets, then waits like {@link
   * SimulationLoop#awaitStill}.
   */
  public boolean awaitStill(Duration limit) throws InterruptedException {
    network.settle();
    return loop.awaitStill(limit);
  }

  /**
   * Switches a drone on or off. Synchronized, so that the last call determines the state of both
   * the drone and its sockets.
   */
  private synchronized void switchPower(Control.Power power) throws PortTakenException {
    if (closed) {
      return; // otherwise, sockets would be opened and never closed
    }
    if (power.on()) {
      network.open(power.drone());
      loop.carryOut(power);
    } else {
      loop.carryOut(power);
      network.close(power.drone());
    }
  }

  /** Sets the camera with which drones take photos. */
  public void setCamera(PhotoCamera camera) {
    simulation.setCamera(camera);
  }

  /** Adds a listener. It is notified on the simulation thread. */
  public void listen(SimListener listener) {
    simulation.listen(listener);
  }

  /**
   * Sets a listener for silence. It is notified once if drones are on and receive nothing for a
   * while, and once if a program listens for video that was not requested.
   *
   * @param listener called on a network thread
   */
  public void onSilence(Consumer<Silence> listener) {
    InetSocketAddress operators =
        new InetSocketAddress(AddressPlan.loopback(1), AddressPlan.REAL_COMMAND_PORT);
    silence = Optional.of(new SilenceWatch(operators, network::silent, listener));
    video =
        Optional.of(
            new VideoWatch(this::unaskedVideo, () -> listener.accept(Silence.VIDEO_NOT_ASKED)));
  }

  /**
   * Returns the video address of the first drone that a local program operates without requesting
   * the drone's video, if any.
   */
  private Optional<InetSocketAddress> unaskedVideo() {
    return snapshot().drones().stream()
        .filter(drone -> drone.state().video().starts() == 0)
        .flatMap(drone -> drone.link().at(drone.link().videoPort()).stream())
        .filter(Peer::local)
        .map(Peer::address)
        .findFirst();
  }

  /** Sets the tap that is notified of every datagram that the drones send. */
  public void setTap(WireTap tap) {
    network.setTap(tap);
  }

  /** Returns the tap that is notified of every datagram that the drones send. */
  public WireTap tap() {
    return network.tap();
  }

  /** Returns the initial configuration of the current run. */
  public SimConfig config() {
    return simulation.config();
  }

  /** Returns the port to which all replies go; empty for the port from which each command came. */
  public OptionalInt replyPort() {
    return replyPort;
  }

  /**
   * Returns whether the simulation has not received any input yet, neither a command nor a control.
   */
  public boolean untouched() {
    return simulation.untouched();
  }

  /**
   * Returns the time that the simulation has reached: the end of the step in progress, or of the
   * last step.
   */
  public SimTime time() {
    return simulation.time();
  }

  /** Returns the snapshot of the latest completed step. */
  public SimSnapshot snapshot() {
    return simulation.snapshot();
  }

  /**
   * Sets the port on which a drone listens when it is next switched on.
   *
   * @param port the port; 0 lets the system choose
   */
  public void setCommandPort(int drone, int port) {
    network.setPort(drone, port);
  }

  /** Returns the addresses where a drone listens while it is on. */
  public List<InetSocketAddress> addresses(int drone) {
    return network.addresses(drone);
  }

  /**
   * Returns the line that lists the address of each drone. Scripts and users wait for this line.
   */
  public String ready() {
    List<String> drones = new ArrayList<>();
    for (int drone = 1; drone <= snapshot().drones().size(); drone++) {
      String where =
          addresses(drone).stream()
              .map(address -> address.getAddress().getHostAddress() + ":" + address.getPort())
              .collect(Collectors.joining(", "));
      drones.add("drone " + drone + " at " + where);
    }
    return "ready: " + String.join("; ", drones);
  }

  /** Returns the datagram counts of a drone. */
  public Traffic traffic(int drone) {
    return network.traffic(drone);
  }

  @Override
  public void close() {
    watch.end();
    clock.wake();
    watch.close();
    synchronized (this) {
      closed = true;
    }
    loop.close(); // before the sockets, so that its last datagrams are still sent
    network.close();
  }
}
