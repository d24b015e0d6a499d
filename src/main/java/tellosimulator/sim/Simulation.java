package tellosimulator.sim;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.IntFunction;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.OperatorRule;
import tellosimulator.command.Peer;
import tellosimulator.command.ReplyPort;
import tellosimulator.concurrent.Exceptions;
import tellosimulator.controller.FlightEvent;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Drone.Neighbourhood;
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

  /**
   * How long a datagram waits at the most for what earlier ones have caused [s]. Decided: longer
   * than a drone takes to restart; some things never end, such as a landing on a hovering drone.
   */
  private static final double LONGEST_DEBT = 20;

  /** Commands that are taken between two steps at the most, so that a flood never stops time. */
  private static final int MOST_AT_ONCE = 256;

  private final Inbox inbox = new Inbox();
  private final Queue<Runnable> notices = new ConcurrentLinkedQueue<>();
  private final Queue<Control> controls = new ConcurrentLinkedQueue<>();
  private final List<Drone> drones = new ArrayList<>();
  private final List<SimEvent> events = new ArrayList<>();
  private final List<SimListener> listeners;
  private final StatePort states;
  private final Surroundings surroundings;
  private final OperatorRule operators;
  private Clock clock;
  private SimTime now = SimTime.ZERO;
  private SimTime lastTaken = SimTime.ZERO;
  private SimTime passUntil = SimTime.ZERO;

  /** Whether people were told why drones land by themselves as fast as possible. */
  private boolean explained;

  private volatile SimSnapshot snapshot;
  private volatile Runnable wake = () -> {};

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
    this.surroundings = new Surroundings(config.arena(), drones, config.seed());
    this.clock = new Clock(config.timeFactor(), false);
    this.states = states;
    this.operators = config.rules().operators();
    this.listeners = new CopyOnWriteArrayList<>(listeners);
    Neighbourhood neighbourhood =
        new Neighbourhood(config.seed(), config.rules(), surroundings, this::happened);
    for (DroneSetup setup : config.drones()) {
      int number = drones.size() + 1;
      drones.add(new Drone(number, setup, replies.apply(number), neighbourhood));
    }
    publish();
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
    boolean taken = inbox.offer(new Inbox.Datagram(drone, peer, text), operates(drone, peer));
    wake.run();
    return taken;
  }

  private boolean operates(int drone, Peer peer) {
    return snapshot.drones().get(drone - 1).link().operator().stream()
        .anyMatch(operator -> operator.host().equals(peer.host()));
  }

  /** Hands over that nothing receives where a drone had sent something. For any thread. */
  public void unreachable(int drone, InetSocketAddress destination) {
    checkNumber(drone);
    notices.add(() -> drone(drone).unreachable(destination));
    wake.run();
  }

  /** Hands over that datagrams of a host were turned away before they came here. For any thread. */
  public void dropped(int drone, InetAddress host, long count, Phrase reason) {
    checkNumber(drone);
    notices.add(
        () ->
            events.add(
                new SimEvent.DatagramsDropped(now, drone, host.getHostAddress(), count, reason)));
    wake.run();
  }

  /** Who may operate the drones. For any thread. */
  public OperatorRule operators() {
    return operators;
  }

  /**
   * Hands over what a person does. For any thread.
   *
   * @throws IllegalArgumentException if there is no such drone
   */
  public void control(Control control) {
    if (control instanceof Control.ForDrone forDrone) {
      checkNumber(forDrone.drone());
    }
    controls.add(control);
    wake.run();
  }

  /** Tells one more listener what happens, after all others. For any thread. */
  public void listen(SimListener listener) {
    listeners.add(listener);
  }

  /** The latest completed step. For any thread. */
  public SimSnapshot snapshot() {
    return snapshot;
  }

  /** Why time must pass. For the owning thread. */
  public Demand demand() {
    Demand demand = now.isBefore(passUntil) ? Demand.DEBT : Demand.NONE;
    for (Drone drone : drones) {
      demand = demand.or(drone.demand());
    }
    return demand == Demand.DEBT && late() ? Demand.MOTION : demand;
  }

  /** Whether what datagrams have caused takes longer than others can wait for. */
  private boolean late() {
    return now.since(lastTaken) >= LONGEST_DEBT && !answers() && !now.isBefore(passUntil);
  }

  private boolean answers() {
    for (Drone drone : drones) {
      if (drone.answers()) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether a datagram may be taken now. As fast as possible, when it comes tells nothing about
   * simulated time, which runs until everything is over that the datagrams before it have caused:
   * so the next one is taken at a moment that depends on these alone. Only while somebody waits for
   * an answer anything is taken at once, because it may be meant to interrupt.
   */
  private boolean open() {
    return !clock.factor().unlimited() || clock.paused() || demand() != Demand.DEBT || answers();
  }

  /** Sets what {@link #submit} and {@link #control} call to wake the owning thread. */
  void onSubmit(Runnable newWake) {
    wake = newWake;
  }

  Clock clock() {
    return clock;
  }

  /** The next snapshot shows how much time was lost since the start [simulated s]. */
  void noteLost(double seconds) {
    clock = clock.withLost(seconds);
  }

  /** People are told that time was lost since they were told the last time [simulated s]. */
  void tellLost(double seconds) {
    events.add(new SimEvent.TimeLost(now, seconds, clock));
  }

  /** Whether commands are left that {@link #drain} did not take. */
  boolean pending() {
    return !inbox.isEmpty();
  }

  /** Takes what has arrived, between two steps; replies that need no time go out at once. */
  public void drain() {
    boolean changed = false;
    for (Control control = controls.poll(); control != null; control = controls.poll()) {
      Control taken = control;
      guarded("A control could not be carried out", () -> apply(taken));
      changed = true;
    }
    for (Runnable notice = notices.poll(); notice != null; notice = notices.poll()) {
      guarded("What the network said could not be handled", notice);
      changed = true;
    }
    for (int i = 0; i < MOST_AT_ONCE && !inbox.isEmpty() && open(); i++) {
      Inbox.Datagram datagram = inbox.poll();
      lastTaken = now;
      guarded(
          "A command could not be handled",
          () -> drone(datagram.drone()).handle(datagram.peer(), datagram.text()));
      changed = true;
    }
    if (changed) {
      publish();
      tellEvents();
    }
  }

  /** Moves everything on by one step of {@link SimTime#STEP}. */
  public void step() {
    drain();
    now = now.next();
    for (Drone drone : drones) {
      drone.plan(now);
    }
    Vec3 wind = surroundings.wind(now);
    for (Drone drone : drones) {
      drone.integrate(wind);
    }
    for (Drone drone : drones) {
      drone.collide(surroundings);
    }
    Encounters.resolve(drones);
    for (Drone drone : drones) {
      drone.consume();
      drone.sense(surroundings);
    }
    for (Drone drone : drones) {
      drone.finish();
    }
    publish();
    for (Drone drone : drones) {
      drone.output(states);
    }
    tellEvents();
    for (SimListener listener : listeners) {
      guarded("A listener failed", () -> listener.stepped(snapshot));
    }
  }

  private void apply(Control control) {
    if (control instanceof Control.Configure change) {
      drones.set(change.drone() - 1, drone(change.drone()).configured(change));
    } else if (control instanceof Control.ForDrone forDrone) {
      drone(forDrone.drone()).apply(forDrone, surroundings.arena().room());
    } else if (control instanceof Control.SetRoom change) {
      Room room = change.room();
      furnish(surroundings.arena().withRoom(room));
      tell(
          Phrase.of(
              "the room is %.0f cm wide, %.0f cm deep and %.0f cm high now",
              room.width() * 100, room.depth() * 100, room.height() * 100));
    } else if (control instanceof Control.Furnish change) {
      furnish(change.arena());
    } else if (control instanceof Control.Decorate change) {
      furnish(surroundings.arena().withDecor(change.decor()));
    } else if (control instanceof Control.PassTime passing) {
      passUntil = now.plus(passing.seconds());
    } else if (control instanceof Control.Pause pause) {
      clock = clock.withPaused(pause.paused());
      tell(pause.paused() ? Phrase.of("time stands still") : Phrase.of("time goes on"));
    } else if (control instanceof Control.SetTimeFactor change) {
      TimeFactor factor = change.factor();
      clock = clock.withFactor(factor);
      tell(Phrase.of("the time factor is %s now", factor));
    }
  }

  private void furnish(Arena arena) {
    surroundings.change(arena);
    drones.forEach(drone -> drone.lookAround(surroundings));
  }

  private static void guarded(String failure, Runnable work) {
    try {
      work.run();
    } catch (Throwable e) { // a stack that overflowed, too, concerns this work alone
      Exceptions.throwIfFatal(e);
      log().error("{}; please report this: {}", failure, e.toString(), e);
    }
  }

  private void publish() {
    List<DroneSnapshot> states = new ArrayList<>(drones.size());
    for (Drone drone : drones) {
      states.add(drone.publish());
    }
    snapshot =
        new SimSnapshot(now, clock, surroundings.arena(), Collections.unmodifiableList(states));
  }

  private void happened(SimEvent event) {
    events.add(event);
    boolean silence =
        event instanceof SimEvent.DroneFlight flight
            && flight.event() instanceof FlightEvent.LandsByItself landing
            && landing.silence();
    if (silence && clock.factor().unlimited() && !explained) {
      explained = true;
      tell(
          Phrase.of(
              "with time factor max a drone is soon without commands for 15 s, because they pass"
                  + " in an instant while another one flies; --no-safety-landing keeps it in the"
                  + " air"));
    }
  }

  private void tell(Phrase phrase) {
    events.add(new SimEvent.WorldChanged(now, phrase));
  }

  private void tellEvents() {
    if (events.isEmpty()) {
      return;
    }
    List<SimEvent> happened = List.copyOf(events);
    events.clear();
    for (SimEvent event : happened) {
      for (SimListener listener : listeners) {
        guarded("A listener failed", () -> listener.event(event));
      }
    }
  }

  private Drone drone(int number) {
    return drones.get(number - 1);
  }

  private void checkNumber(int drone) {
    int most = snapshot.drones().size();
    if (drone < 1 || drone > most) {
      throw new IllegalArgumentException(
          "there is no drone " + drone + ", the drones are 1 to " + most);
    }
  }

  /** Not a constant: logging takes long to start, and the first picture does not wait for it. */
  private static Logger log() {
    return LoggerFactory.getLogger(Simulation.class);
  }
}
