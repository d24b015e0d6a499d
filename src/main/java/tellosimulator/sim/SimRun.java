package tellosimulator.sim;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.IntFunction;
import tellosimulator.command.DronePort;
import tellosimulator.command.PhotoCamera;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimDrone.Neighborhood;
import tellosimulator.sim.SimSnapshot.Clock;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.time.TimeFactor;
import tellosimulator.words.Phrase;
import tellosimulator.world.Arena;
import tellosimulator.world.Room;

/**
 * One run of a simulation, from time 0 with all drones off: the state of the room, the drones, the
 * faults and the clock, the effects of inputs on them, and the phases of a step. Confined to the
 * simulation thread, except for {@link #config} and {@link #now}.
 */
final class SimRun {

  private static final String COMMAND_FAILED = "A command could not be handled";

  private final SimConfig config;
  private final EventDispatcher events;
  private final List<SimDrone> drones = new ArrayList<>();
  private final CollisionWorld collisionWorld;
  private final FaultInjection faults;
  private final TimeDemand demand = new TimeDemand(drones);
  private final SilenceHint hint = new SilenceHint();
  private Clock clock;
  private volatile SimTime now = SimTime.ZERO;

  /**
   * Begins a run.
   *
   * @param ports supplies the port of the drone with a given number
   * @param camera takes the drones' photos
   * @param events receives all events
   */
  SimRun(
      SimConfig config, IntFunction<DronePort> ports, PhotoCamera camera, EventDispatcher events) {
    this.config = config;
    this.events = events;
    collisionWorld = new CollisionWorld(config.arena(), drones, config.seed());
    clock = new Clock(config.timeFactor(), false);
    Neighborhood neighborhood =
        new Neighborhood(config.seed(), config.rules(), collisionWorld, camera, this::happened);
    for (DroneSetup setup : config.drones()) {
      int number = drones.size() + 1;
      drones.add(new SimDrone(number, setup, ports.apply(number), neighborhood));
    }
    faults = new FaultInjection(config.rules().faults(), drones, () -> now, events::add);
    faults.begin();
  }

  /** Returns the initial configuration. Thread-safe. */
  SimConfig config() {
    return config;
  }

  /** Returns the end of the current step or, between steps, of the last one. Thread-safe. */
  SimTime now() {
    return now;
  }

  Clock clock() {
    return clock;
  }

  TimeDemand demand() {
    return demand;
  }

  /** Sets the time lost since the start [simulated s]. */
  void noteLost(double seconds) {
    clock = clock.withLost(seconds);
  }

  /** Switches all drones off, which ends their sessions. */
  void end() {
    for (SimDrone drone : drones) {
      drone.apply(new Control.Power(drone.number(), false), collisionWorld.arena().room());
    }
  }

  /** Performs a step, except for the output that follows from its result. */
  void advance() {
    for (SimDrone drone : drones) {
      if (drone.link().brings()) {
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
      drone.body().integrate(wind);
    }
    for (SimDrone drone : drones) {
      drone.body().collide(collisionWorld);
    }
    DroneCollisions.resolve(drones);
    for (SimDrone drone : drones) {
      drone.consume();
      drone.sense(collisionWorld);
    }
    for (SimDrone drone : drones) {
      drone.finish();
    }
  }

  /** Sends the output that is due at the end of a step. */
  void output() {
    for (SimDrone drone : drones) {
      drone.output();
    }
  }

  SimSnapshot snapshot() {
    List<DroneSnapshot> states = new ArrayList<>(drones.size());
    for (SimDrone drone : drones) {
      states.add(drone.publish());
    }
    return new SimSnapshot(
        now, clock, config.seed(), collisionWorld.arena(), Collections.unmodifiableList(states));
  }

  void receive(SimInput.Datagram datagram) {
    demand.taken(now);
    drone(datagram.drone()).link().receive(datagram.peer(), datagram.bytes());
  }

  void unreachable(SimInput.Unreachable gone) {
    drone(gone.drone()).protocols().unreachable(gone.destination());
  }

  /** Applies a control, other than one that begins a new run. */
  void apply(Control control) {
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
      changed(
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
      changed(Phrase.of("the link is %s now", change.link().option()));
    } else if (control instanceof Control.EndAttempt) {
      changed(Phrase.of("the attempt at the goals is over"));
    } else if (control instanceof Control.PassTime passing) {
      demand.passUntil(now.plus(passing.seconds()));
    } else if (control instanceof Control.Pause pause) {
      clock = clock.withPaused(pause.paused());
      changed(pause.paused() ? Phrase.of("time stands still") : Phrase.of("time goes on"));
    } else if (control instanceof Control.SetTimeFactor change) {
      TimeFactor factor = change.factor();
      clock = clock.withFactor(factor);
      changed(Phrase.of("the time factor is %s now", factor));
    }
  }

  /**
   * Lets time pass until the end of the next step. Some effects occur only in a step, such as a
   * landing because the battery is empty.
   */
  private void passStep() {
    demand.passUntil(now.next());
  }

  private void furnish(Arena arena) {
    collisionWorld.change(arena);
    drones.forEach(drone -> drone.lookAround(collisionWorld));
  }

  private void happened(SimEvent event) {
    events.add(event);
    faults.observe(event);
    hint.after(event, clock.factor().unlimited()).ifPresent(this::changed);
  }

  private void changed(Phrase phrase) {
    events.add(new SimEvent.WorldChanged(now, phrase));
  }

  private SimDrone drone(int number) {
    return drones.get(number - 1);
  }
}
