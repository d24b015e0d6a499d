package tellosimulator.sim;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import tellosimulator.command.DronePort;
import tellosimulator.command.OperatorRule;
import tellosimulator.command.Peer;
import tellosimulator.command.PhotoCamera;
import tellosimulator.sim.SimSnapshot.Clock;
import tellosimulator.time.PendingWork;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The simulation: a room with drones, advanced in fixed steps. This class uses no wall clock, no
 * sockets and no window.
 *
 * <p>One thread owns the simulation and calls {@link #drain} and {@link #step}: a {@link
 * SimulationLoop}, or a test that steps it. {@link #submit}, {@link #control} and {@link #snapshot}
 * are thread-safe.
 */
public final class Simulation {

  /** Maximum number of datagrams handled between two steps, so that a flood cannot stop time. */
  private static final int MOST_AT_ONCE = 256;

  private static final String COMMAND_FAILED = "A command could not be handled";

  private final Inbox inbox = new Inbox();

  /** Callbacks to run once the published snapshot includes their change. */
  private final List<Runnable> shown = new ArrayList<>();

  private final EventDispatcher events;
  private final IntFunction<DronePort> ports;

  /** Callbacks to run when the simulation becomes idle. */
  private final List<Runnable> onceStill = new ArrayList<>();

  private volatile PhotoCamera camera = PhotoCamera.NONE;
  private volatile SimRun run;
  private volatile boolean untouched = true;
  private boolean commanded;

  private volatile SimSnapshot snapshot;

  /**
   * Creates a simulation at time 0 with all drones off.
   *
   * @param ports supplies the port through which the drone with a given number sends
   * @param listeners in order of notification
   */
  public Simulation(SimConfig config, IntFunction<DronePort> ports, List<SimListener> listeners) {
    this.ports = ports;
    this.events = new EventDispatcher(listeners);
    run = new SimRun(config, ports, this::photo, events);
    publish();
  }

  private Optional<Supplier<byte[]>> photo(int drone, float quality) {
    return camera.take(drone, quality);
  }

  /** Sets the camera with which drones take photos. Thread-safe. */
  public void setCamera(PhotoCamera newCamera) {
    camera = newCamera;
  }

  private void restart(SimConfig config) {
    run.end();
    events.clear();
    events.add(new SimEvent.RunStarted(SimTime.ZERO)); // before the faults that begin with the run
    run = new SimRun(config, ports, this::photo, events);
  }

  /**
   * Submits a datagram. It is handled between two steps, after all earlier inputs. Thread-safe.
   *
   * @param drone the number of the drone, from 1
   * @param bytes the content, which must not be modified afterwards
   * @return false if the inbox is full and the datagram was lost
   */
  public boolean submit(int drone, Peer peer, byte[] bytes) {
    checkNumber(drone);
    return inbox.offer(new SimInput.Datagram(drone, peer, bytes), operates(drone, peer));
  }

  private boolean operates(int drone, Peer peer) {
    return snapshot.drones().get(drone - 1).link().operator().stream()
        .anyMatch(operator -> operator.host().equals(peer.host()));
  }

  /** Reports that a destination of a drone is unreachable. Thread-safe. */
  public void unreachable(int drone, InetSocketAddress destination) {
    notice(new SimInput.Unreachable(drone, destination));
  }

  /** Reports that the network layer rejected datagrams from a host. Thread-safe. */
  public void dropped(int drone, InetAddress host, long count, Phrase reason) {
    notice(new SimInput.Dropped(drone, host.getHostAddress(), count, reason));
  }

  private void notice(SimInput.ForDrone input) {
    checkNumber(input.drone());
    inbox.add(
        new Inbox.Call(
            "An input from the network could not be handled", () -> take(input), () -> {}));
  }

  /** Returns the rule that determines who may operate the drones. Thread-safe. */
  public OperatorRule operators() {
    return run.config().rules().operators();
  }

  /**
   * Submits a control. It is applied after the commands that arrived before it. Thread-safe.
   *
   * @throws IllegalArgumentException if there is no such drone, or the configuration of a new run
   *     has another number of drones
   */
  public void control(Control control) {
    control(control, () -> {});
  }

  /**
   * Submits a control, like {@link #control(Control)}, with a callback.
   *
   * @param shown a callback to run once the snapshot includes the change, or once it is certain
   *     that it never will; run on the owning thread; must not throw
   */
  void control(Control control, Runnable shown) {
    check(control);
    SimInput input = new SimInput.Act(control);
    inbox.add(new Inbox.Call("A control could not be carried out", () -> take(input), shown));
  }

  /**
   * Submits a callback to run once everything submitted before it has been applied, published and
   * reported to listeners. Thread-safe.
   *
   * @param done run on the owning thread; must not throw
   */
  void afterAll(Runnable done) {
    inbox.add(new Inbox.Call("Nobody can wait for the simulation", () -> {}, done));
  }

  /**
   * Submits a callback to run once all received commands have been carried out and answered, and
   * nothing moves any more. Thread-safe.
   *
   * @param work run on the owning thread; must be quick
   */
  void onceStill(Runnable work) {
    inbox.add(new Inbox.Call("Nobody can wait for rest", () -> onceStill.add(work), () -> {}));
  }

  private void tellStill() {
    if (!onceStill.isEmpty() && inbox.isEmpty() && demand() == PendingWork.NONE) {
      List<Runnable> told = List.copyOf(onceStill);
      onceStill.clear();
      told.forEach(work -> EventDispatcher.guarded("Who waits for rest cannot be told", work));
    }
  }

  /**
   * Runs the callbacks of all queued calls without running the calls themselves. Allocates nothing.
   */
  void abandon() {
    for (Inbox.Item item = inbox.poll(); item != null; item = inbox.poll()) {
      if (item instanceof Inbox.Call call) {
        call.shown().run();
      }
    }
  }

  /** Adds a listener after all others. Thread-safe. */
  public void listen(SimListener listener) {
    events.listen(listener);
  }

  /** Returns the configuration of the current run. Thread-safe. */
  public SimConfig config() {
    return run.config();
  }

  /**
   * Whether no input has been applied so far. Reports of lost time do not count, because they
   * affect no flight. Thread-safe.
   */
  public boolean untouched() {
    return untouched;
  }

  /** Returns the latest published state. Thread-safe. */
  public SimSnapshot snapshot() {
    return snapshot;
  }

  /** Returns the end of the current step or, between steps, of the last one. Thread-safe. */
  public SimTime time() {
    return run.now();
  }

  /** Returns the reason why simulated time must pass. Called on the owning thread. */
  PendingWork demand() {
    return run.demand().demand(run.now());
  }

  /** Sets the callback with which {@link #submit} and {@link #control} wake the owning thread. */
  void onSubmit(Runnable newWake) {
    inbox.onCome(newWake);
  }

  Clock clock() {
    return run.clock();
  }

  /** Whether a command has arrived since the start. Called on the owning thread. */
  boolean commanded() {
    return commanded;
  }

  /** Sets the time lost since the start [simulated s]. The next snapshot will contain it. */
  void noteLost(double seconds) {
    run.noteLost(seconds);
  }

  /** Reports the time lost since the last report [simulated s]. */
  void tellLost(double seconds) {
    take(new SimInput.TimeLost(seconds, run.clock().lostSeconds()));
  }

  /** Whether inputs remain that {@link #drain} has not handled. */
  boolean pending() {
    return !inbox.isEmpty();
  }

  /**
   * Handles the waiting inputs in order, between two steps. Sends at once the replies to commands
   * that take no time.
   */
  public void drain() {
    try {
      int datagrams = 0;
      boolean changed = false;
      Inbox.Item next = inbox.peek();
      while (next instanceof Inbox.Call
          || (next != null
              && datagrams < MOST_AT_ONCE
              && run.demand().open(run.now(), run.clock()))) {
        if (next instanceof Inbox.Call call) {
          show(); // earlier events refer to the state before the call
          take(call);
          show();
        } else {
          inbox.poll();
          SimInput datagram = (SimInput.Datagram) next;
          EventDispatcher.guarded(COMMAND_FAILED, () -> take(datagram));
          datagrams++;
        }
        changed = true;
        next = inbox.peek();
      }
      if (changed) {
        show();
        tellStill();
      }
    } finally {
      shown.forEach(Runnable::run);
      shown.clear();
    }
  }

  private void show() {
    publish();
    events.dispatch();
  }

  private void take(Inbox.Call call) {
    shown.add(call.shown()); // first: if this runs out of memory, the call stays queued
    inbox.poll();
    EventDispatcher.guarded(call.failure(), call.work());
  }

  /**
   * Immediately applies an input that an earlier run received between the same two steps. Called on
   * the owning thread.
   *
   * @throws IllegalArgumentException if there is no such drone, or the configuration of a new run
   *     has another number of drones
   */
  public void repeat(SimInput input) {
    if (input instanceof SimInput.ForDrone forDrone) {
      checkNumber(forDrone.drone());
    } else if (input instanceof SimInput.Act act) {
      check(act.control());
    }
    drain();
    show(); // as for a call, publishes the events from before the input
    EventDispatcher.guarded(COMMAND_FAILED, () -> take(input));
    show();
    tellStill();
  }

  /** Advances everything by one step of {@link SimTime#STEP}. */
  public void step() {
    drain();
    run.advance();
    publish();
    run.output();
    events.dispatch();
    events.stepped(snapshot);
    tellStill();
  }

  private void take(SimInput input) {
    untouched = untouched && input instanceof SimInput.TimeLost; // such a report has no effect
    SimTime now = run.now();
    events.onInput(now, input);
    if (input instanceof SimInput.Datagram datagram) {
      commanded = true;
      run.receive(datagram);
    } else if (input instanceof SimInput.Act act) {
      apply(act.control());
    } else if (input instanceof SimInput.Unreachable gone) {
      run.unreachable(gone);
    } else if (input instanceof SimInput.Dropped dropped) {
      events.add(
          new SimEvent.DatagramsDropped(
              now, dropped.drone(), dropped.host(), dropped.count(), dropped.reason()));
    } else if (input instanceof SimInput.TimeLost lost) {
      noteLost(lost.all());
      events.add(new SimEvent.TimeLost(now, lost.seconds(), clock()));
    }
  }

  private void apply(Control control) {
    if (control instanceof Control.NewRun newRun) {
      restart(newRun.config());
    } else {
      run.apply(control);
    }
  }

  private void publish() {
    snapshot = run.snapshot();
  }

  private void check(Control control) {
    if (control instanceof Control.ForDrone forDrone) {
      checkNumber(forDrone.drone());
    } else if (control instanceof Control.InjectFault injected) {
      injected.fault().target().drone().ifPresent(this::checkNumber);
    } else if (control instanceof Control.NewRun restart) {
      int given = restart.config().drones().size();
      int most = snapshot.drones().size();
      if (given != most) {
        throw new IllegalArgumentException(
            "config has " + given + " drones, but must have " + most);
      }
    }
  }

  private void checkNumber(int drone) {
    int most = snapshot.drones().size();
    if (drone < 1 || drone > most) {
      throw new IllegalArgumentException(
          "there is no drone " + drone + ", the drones are 1 to " + most);
    }
  }
}
