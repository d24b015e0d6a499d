package tellosimulator.sim;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.IntFunction;
import tellosimulator.command.OperatorRule;
import tellosimulator.command.Peer;
import tellosimulator.command.ReplyPort;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimDrone.Neighborhood;
import tellosimulator.sim.SimSnapshot.Clock;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.Demand;
import tellosimulator.time.SimTime;
import tellosimulator.time.TimeFactor;
import tellosimulator.words.Phrase;
import tellosimulator.world.Arena;
import tellosimulator.world.Room;

/**
 * The simulation: a room with drones that moves on in fixed steps. It knows no wall clock, no
 * sockets and no window.
 *
 * <p>One thread owns it and calls {@link #drain} and {@link #step}: a {@link SimulationLoop}, or a
 * test that steps it. {@link #submit}, {@link #control} and {@link #snapshot} are for any thread.
 */
public final class Simulation {

  /** Datagrams that are taken between two steps at the most, so that a flood never stops time. */
  private static final int MOST_AT_ONCE = 256;

  private static final String COMMAND_FAILED = "A command could not be handled";

  private final Inbox inbox = new Inbox();

  /** Whom to tell that the snapshot shows what they wanted. */
  private final List<Runnable> shown = new ArrayList<>();

  private final List<SimDrone> drones = new ArrayList<>();
  private final EventDispatcher events;
  private final IntFunction<ReplyPort> replies;
  private final StatePort states;

  /** What is run once nothing is left that anybody waits for. */
  private final List<Runnable> onceStill = new ArrayList<>();

  private CollisionWorld collisionWorld;
  private volatile OperatorRule operators;
  private FaultInjection faults;
  private TimeDemand demand;
  private SilenceHint hint;
  private Clock clock;
  private volatile SimTime now;
  private volatile SimConfig config;
  private volatile boolean untouched = true;
  private boolean commanded;

  private volatile SimSnapshot snapshot;

  /**
   * @param replies gives the way out for the replies of the drone of a number
   * @param states the way out for state lines
   * @param listeners are told what happens, in this order
   */
  public Simulation(
      SimConfig config,
      IntFunction<ReplyPort> replies,
      StatePort states,
      List<SimListener> listeners) {
    this.replies = replies;
    this.states = states;
    this.events = new EventDispatcher(listeners);
    begin(config);
    publish();
  }

  private void begin(SimConfig newConfig) {
    config = newConfig;
    drones.clear();
    collisionWorld = new CollisionWorld(config.arena(), drones, config.seed());
    clock = new Clock(config.timeFactor(), false);
    operators = config.rules().operators();
    now = SimTime.ZERO;
    demand = new TimeDemand(drones);
    hint = new SilenceHint();
    Neighborhood neighborhood =
        new Neighborhood(config.seed(), config.rules(), collisionWorld, states, this::happened);
    for (DroneSetup setup : config.drones()) {
      int number = drones.size() + 1;
      drones.add(new SimDrone(number, setup, replies.apply(number), neighborhood));
    }
    faults = new FaultInjection(config.rules().faults(), drones, () -> now, events::add);
    faults.begin();
  }

  private void restart(SimConfig newConfig) {
    for (SimDrone drone : drones) {
      drone.apply(new Control.Power(drone.number(), false), collisionWorld.arena().room());
    }
    events.clear();
    events.add(new SimEvent.Restarted(SimTime.ZERO)); // before the faults that begin with the run
    begin(newConfig);
  }

  /**
   * Hands over a datagram. For any thread; it is taken at the next step, or before it.
   *
   * @param drone its number, from 1
   * @param text one character a byte (ISO-8859-1)
   * @return false if the inbox is full and the datagram was lost
   */
  public boolean submit(int drone, Peer peer, String text) {
    checkNumber(drone);
    return inbox.offer(new SimInput.Datagram(drone, peer, text), operates(drone, peer));
  }

  private boolean operates(int drone, Peer peer) {
    return snapshot.drones().get(drone - 1).link().operator().stream()
        .anyMatch(operator -> operator.host().equals(peer.host()));
  }

  /** Hands over that nothing receives where a drone had sent something. For any thread. */
  public void unreachable(int drone, InetSocketAddress destination) {
    notice(new SimInput.Unreachable(drone, destination));
  }

  /** Hands over that datagrams of a host were turned away before they came here. For any thread. */
  public void dropped(int drone, InetAddress host, long count, Phrase reason) {
    notice(new SimInput.Dropped(drone, host.getHostAddress(), count, reason));
  }

  private void notice(SimInput.ForDrone input) {
    checkNumber(input.drone());
    inbox.add(
        new Inbox.Call("What the network said could not be handled", () -> take(input), () -> {}));
  }

  /** Who may operate the drones. For any thread. */
  public OperatorRule operators() {
    return operators;
  }

  /**
   * Hands over what a person does; it is taken after the commands that came before it. For any
   * thread.
   *
   * @throws IllegalArgumentException if there is no such drone, or another number of drones to
   *     begin anew with
   */
  public void control(Control control) {
    control(control, () -> {});
  }

  /**
   * The same.
   *
   * @param shown run on the owning thread when the snapshot shows it, or never will; must not throw
   */
  void control(Control control, Runnable shown) {
    check(control);
    SimInput input = new SimInput.Act(control);
    inbox.add(new Inbox.Call("A control could not be carried out", () -> take(input), shown));
  }

  /**
   * Hands over that somebody wants to know when everything is done and shown that came before it,
   * events included. For any thread.
   *
   * @param done run on the owning thread; must not throw
   */
  void afterAll(Runnable done) {
    inbox.add(new Inbox.Call("Nobody can wait for the simulation", () -> {}, done));
  }

  /**
   * Hands over something that is to be done once, when all commands that have come are carried out,
   * their answers are given and nothing moves any more. For any thread.
   *
   * @param work run on the owning thread; must be quick
   */
  void onceStill(Runnable work) {
    inbox.add(new Inbox.Call("Nobody can wait for rest", () -> onceStill.add(work), () -> {}));
  }

  private void tellStill() {
    if (!onceStill.isEmpty() && inbox.isEmpty() && demand() == Demand.NONE) {
      List<Runnable> told = List.copyOf(onceStill);
      onceStill.clear();
      told.forEach(work -> EventDispatcher.guarded("Who waits for rest cannot be told", work));
    }
  }

  /** Tells everybody whose control waits that it will not be taken. Makes nothing new. */
  void abandon() {
    for (Inbox.Item item = inbox.poll(); item != null; item = inbox.poll()) {
      if (item instanceof Inbox.Call call) {
        call.shown().run();
      }
    }
  }

  /** Tells one more listener what happens, after all others. For any thread. */
  public void listen(SimListener listener) {
    events.listen(listener);
  }

  /** What it began from, now or the last time that it began anew. For any thread. */
  public SimConfig config() {
    return config;
  }

  /**
   * Whether nothing was ever taken from outside that a flight depends on; that this machine is busy
   * does not count. For any thread.
   */
  public boolean untouched() {
    return untouched;
  }

  /** The latest completed step. For any thread. */
  public SimSnapshot snapshot() {
    return snapshot;
  }

  /** The end of the step that is being made, or of the last one. For any thread. */
  public SimTime time() {
    return now;
  }

  /** Why time must pass. For the owning thread. */
  Demand demand() {
    return demand.demand(now);
  }

  /** Sets what {@link #submit} and {@link #control} call to wake the owning thread. */
  void onSubmit(Runnable newWake) {
    inbox.onCome(newWake);
  }

  Clock clock() {
    return clock;
  }

  /** Whether a command has come since the start. For the owning thread. */
  boolean commanded() {
    return commanded;
  }

  /** The next snapshot shows how much time was lost since the start [simulated s]. */
  void noteLost(double seconds) {
    clock = clock.withLost(seconds);
  }

  /** People are told that time was lost since they were told the last time [simulated s]. */
  void tellLost(double seconds) {
    take(new SimInput.TimeLost(seconds, clock.lostSeconds()));
  }

  /** Whether something is left that {@link #drain} did not take. */
  boolean pending() {
    return !inbox.isEmpty();
  }

  /**
   * Takes what has arrived, in its order, between two steps; replies that need no time go out at
   * once.
   */
  public void drain() {
    try {
      int datagrams = 0;
      boolean changed = false;
      Inbox.Item next = inbox.peek();
      while (next instanceof Inbox.Call
          || (next != null && datagrams < MOST_AT_ONCE && demand.open(now, clock))) {
        if (next instanceof Inbox.Call call) {
          show(); // what happened until now happened where drones were before the call
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
    shown.add(call.shown()); // which may fail for want of memory: then it waits on
    inbox.poll();
    EventDispatcher.guarded(call.failure(), call.work());
  }

  /**
   * Takes what an earlier run took between the same two steps, at once. For the owning thread.
   *
   * @throws IllegalArgumentException if there is no such drone, or another number of drones to
   *     begin anew with
   */
  public void repeat(SimInput input) {
    if (input instanceof SimInput.ForDrone forDrone) {
      checkNumber(forDrone.drone());
    } else if (input instanceof SimInput.Act act) {
      check(act.control());
    }
    drain();
    show(); // as a call does: what happened until now happened before it
    EventDispatcher.guarded(COMMAND_FAILED, () -> take(input));
    show();
    tellStill();
  }

  /** Moves everything on by one step of {@link SimTime#STEP}. */
  public void step() {
    drain();
    for (SimDrone drone : drones) {
      if (drone.expectsCommands()) {
        EventDispatcher.guarded(COMMAND_FAILED, drone::receiveDelayed);
      }
    }
    now = now.next();
    faults.advance();
    for (SimDrone drone : drones) {
      drone.plan(now);
    }
    Vec3 wind = collisionWorld.wind(now);
    for (SimDrone drone : drones) {
      drone.integrate(wind);
    }
    for (SimDrone drone : drones) {
      drone.collide(collisionWorld);
    }
    DroneCollisions.resolve(drones);
    for (SimDrone drone : drones) {
      drone.consume();
      drone.sense(collisionWorld);
    }
    for (SimDrone drone : drones) {
      drone.finish();
    }
    publish();
    for (SimDrone drone : drones) {
      drone.output();
    }
    events.dispatch();
    events.stepped(snapshot);
    tellStill();
  }

  private void take(SimInput input) {
    untouched = untouched && input instanceof SimInput.TimeLost; // which is news alone
    events.taken(now, input);
    if (input instanceof SimInput.Datagram datagram) {
      demand.taken(now);
      commanded = true;
      drone(datagram.drone()).receive(datagram);
    } else if (input instanceof SimInput.Act act) {
      apply(act.control());
    } else if (input instanceof SimInput.Unreachable gone) {
      drone(gone.drone()).unreachable(gone.destination());
    } else if (input instanceof SimInput.Dropped dropped) {
      events.add(
          new SimEvent.DatagramsDropped(
              now, dropped.drone(), dropped.host(), dropped.count(), dropped.reason()));
    } else if (input instanceof SimInput.TimeLost lost) {
      noteLost(lost.all());
      events.add(new SimEvent.TimeLost(now, lost.seconds(), clock));
    }
  }

  private void apply(Control control) {
    if (control instanceof Control.Configure change) {
      drones.set(change.drone() - 1, drone(change.drone()).configured(change));
      faults.disturb(drone(change.drone()));
    } else if (control instanceof Control.ForDrone forDrone) {
      drone(forDrone.drone()).apply(forDrone, collisionWorld.arena().room());
      if (control instanceof Control.SetBattery) {
        passStep();
      }
    } else if (control instanceof Control.SetRoom change) {
      Room room = change.room();
      furnish(collisionWorld.arena().withRoom(room));
      tell(
          Phrase.of(
              "the room is %.0f cm wide, %.0f cm deep and %.0f cm high now",
              room.width() * 100, room.depth() * 100, room.height() * 100));
    } else if (control instanceof Control.Furnish change) {
      furnish(collisionWorld.arena().withObstacles(change.obstacles()).withPads(change.pads()));
    } else if (control instanceof Control.SetWind change) {
      furnish(collisionWorld.arena().withWind(change.wind()));
    } else if (control instanceof Control.Decorate change) {
      furnish(collisionWorld.arena().withDecor(change.decor()));
    } else if (control instanceof Control.InjectFault injected) {
      faults.inject(injected.fault());
      passStep();
    } else if (control instanceof Control.ClearFaults) {
      faults.clear();
    } else if (control instanceof Control.SetLink change) {
      faults.setLink(change.link());
      tell(Phrase.of("the link is %s now", change.link().option()));
    } else if (control instanceof Control.Restart anew) {
      restart(anew.config());
    } else if (control instanceof Control.PassTime passing) {
      demand.passUntil(now.plus(passing.seconds()));
    } else if (control instanceof Control.Pause pause) {
      clock = clock.withPaused(pause.paused());
      tell(pause.paused() ? Phrase.of("time stands still") : Phrase.of("time goes on"));
    } else if (control instanceof Control.SetTimeFactor change) {
      TimeFactor factor = change.factor();
      clock = clock.withFactor(factor);
      tell(Phrase.of("the time factor is %s now", factor));
    }
  }

  /** Time passes for what acts at the end of the next step, such as a landing without battery. */
  private void passStep() {
    demand.passUntil(now.next());
  }

  private void furnish(Arena arena) {
    collisionWorld.change(arena);
    drones.forEach(drone -> drone.lookAround(collisionWorld));
  }

  private void publish() {
    List<DroneSnapshot> states = new ArrayList<>(drones.size());
    for (SimDrone drone : drones) {
      states.add(drone.publish());
    }
    snapshot =
        new SimSnapshot(now, clock, collisionWorld.arena(), Collections.unmodifiableList(states));
  }

  private void happened(SimEvent event) {
    events.add(event);
    faults.observe(event);
    hint.after(event, clock.factor().unlimited()).ifPresent(this::tell);
  }

  private void tell(Phrase phrase) {
    events.add(new SimEvent.WorldChanged(now, phrase));
  }

  private SimDrone drone(int number) {
    return drones.get(number - 1);
  }

  private void check(Control control) {
    if (control instanceof Control.ForDrone forDrone) {
      checkNumber(forDrone.drone());
    } else if (control instanceof Control.InjectFault injected) {
      injected.fault().target().drone().ifPresent(this::checkNumber);
    } else if (control instanceof Control.Restart restart) {
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
