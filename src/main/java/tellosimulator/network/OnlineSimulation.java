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
 * A simulation that runs at the pace of its clock, with drones that programs reach over UDP while
 * they are on. For any thread but that of the simulation.
 */
public final class OnlineSimulation implements AutoCloseable {

  /**
   * How often the network is looked at: what was turned away is told, and new addresses of the
   * machine are served [ns]. Decided.
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
   * Starts with all drones off and all sockets closed.
   *
   * @param replyPort port to which all replies go; empty for the port each command came from
   * @param listeners are told what happens, on the simulation thread
   */
  public OnlineSimulation(
      SimConfig config, AddressPlan plan, OptionalInt replyPort, List<SimListener> listeners) {
    network = DroneNetwork.of(plan);
    this.replyPort = replyPort;
    simulation = new Simulation(config, network.replies(replyPort), network.states(), listeners);
    loop = new SimulationLoop(simulation);
    network.listen(simulation);
    watch = Worker.start("network", new Watch());
  }

  /** Looks after the sockets now and then. */
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

  /** From where the drones that listen on the machine's own addresses can be reached. */
  public Reach reach() {
    return network.reach();
  }

  /** Changes it at once, also for drones that are on. */
  public void setReach(Reach reach) {
    network.setReach(reach);
  }

  /**
   * Switches all drones on, or none.
   *
   * @throws PortTakenException if an address or port cannot be had
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
   * Hands over what a person does, and waits until the snapshot shows it. The power switch also
   * opens and closes the drone's sockets, so that only a drone that is on listens.
   *
   * @throws IllegalArgumentException if there is no such drone
   * @throws PortTakenException if a drone cannot be switched on, because one of its addresses or
   *     ports cannot be had
   */
  public void carryOut(Control control) throws PortTakenException {
    if (control instanceof Control.Power power) {
      switchPower(power);
    } else {
      loop.carryOut(control);
    }
  }

  /** Lets simulated time pass where it would stand still, because nothing moves [s]. */
  public void letPass(double seconds) {
    loop.carryOut(new Control.PassTime(seconds));
  }

  /**
   * Begins anew with all drones on; the sockets stay as they are.
   *
   * @param config with as many drones as before
   * @throws PortTakenException if a drone was off, and one of its addresses or ports cannot be had
   */
  public synchronized void restart(SimConfig config) throws PortTakenException {
    loop.carryOut(new Control.Restart(config));
    switchAllOn();
  }

  /** As {@link SimulationLoop#settle}; what programs have sent until now has arrived, too. */
  public void settle() {
    network.settle();
    loop.settle();
  }

  /** As {@link SimulationLoop#awaitStill}; what programs have sent until now has arrived, too. */
  public boolean awaitStill(Duration limit) throws InterruptedException {
    network.settle();
    return loop.awaitStill(limit);
  }

  /** One at a time, so that whoever is last decides on drone and sockets. */
  private synchronized void switchPower(Control.Power power) throws PortTakenException {
    if (closed) {
      return; // or sockets would be opened that nobody closes
    }
    if (power.on()) {
      network.open(power.drone());
      loop.carryOut(power);
    } else {
      loop.carryOut(power);
      network.close(power.drone());
    }
  }

  /** Tells one more listener what happens, on the simulation thread. */
  public void listen(SimListener listener) {
    simulation.listen(listener);
  }

  /**
   * Sets a listener that is notified once if drones are on and nothing comes to them for a while,
   * and once if a program listens for video that was not asked for.
   *
   * @param listener is called on a thread of the network
   */
  public void onSilence(Consumer<Silence> listener) {
    InetSocketAddress operators =
        new InetSocketAddress(AddressPlan.loopback(1), AddressPlan.REAL_COMMAND_PORT);
    silence = Optional.of(new SilenceWatch(operators, network::silent, listener));
    video =
        Optional.of(
            new VideoWatch(this::unaskedVideo, () -> listener.accept(Silence.VIDEO_NOT_ASKED)));
  }

  /** Where the video of the first drone would go that a program on loopback operates without it. */
  private Optional<InetSocketAddress> unaskedVideo() {
    return snapshot().drones().stream()
        .filter(drone -> drone.state().video().starts() == 0)
        .flatMap(
            drone ->
                drone
                    .link()
                    .operator()
                    .filter(Peer::local)
                    .map(
                        peer ->
                            new InetSocketAddress(
                                peer.address().getAddress(), drone.link().videoPort()))
                    .stream())
        .findFirst();
  }

  /** Shows somebody what comes to the drones and what leaves them, from now on. */
  public void setTap(WireTap tap) {
    network.setTap(tap);
  }

  /** Who sees what comes to the drones and what leaves them. */
  public WireTap tap() {
    return network.tap();
  }

  /** What it began from, now or the last time that it began anew. */
  public SimConfig config() {
    return simulation.config();
  }

  /** Port to which all replies go; empty for the port each command came from. */
  public OptionalInt replyPort() {
    return replyPort;
  }

  /** Whether nothing has come to it from outside yet, neither commands nor what people do. */
  public boolean untouched() {
    return simulation.untouched();
  }

  /** Until when the simulation has come: the end of the step that is being made, if one is. */
  public SimTime time() {
    return simulation.time();
  }

  /** The latest completed step. */
  public SimSnapshot snapshot() {
    return simulation.snapshot();
  }

  /**
   * Lets a drone listen on another port from the next time it is switched on.
   *
   * @param port 0 for one that the system chooses
   */
  public void setCommandPort(int drone, int port) {
    network.setPort(drone, port);
  }

  /** Where a drone listens while it is on. */
  public List<InetSocketAddress> addresses(int drone) {
    return network.addresses(drone);
  }

  /** The line that says which drone listens where, for scripts and people who wait for it. */
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

  /** What a drone received and sent. */
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
    loop.close(); // before the sockets, so that what it sends until then does leave
    network.close();
  }
}
