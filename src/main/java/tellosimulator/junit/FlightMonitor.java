package tellosimulator.junit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import tellosimulator.command.Reply;
import tellosimulator.controller.FlightEvent;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Terms;
import tellosimulator.junit.DroneTruth.Touch;
import tellosimulator.junit.JournalEntry.Answer;
import tellosimulator.junit.JournalEntry.Outcome;
import tellosimulator.math.Frames;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.RealTimer;
import tellosimulator.time.SimTime;
import tellosimulator.world.Collidable;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/**
 * Records the drones' flights and the datagrams that reach the drones. Each new run begins without
 * records. Notified on the simulation thread. All queries are thread-safe.
 */
final class FlightMonitor implements SimListener {

  /**
   * Maximum number of journal entries per drone. Decided: enough for one hour of {@code rc} at 20
   * commands per second.
   */
  private static final int MOST_ENTRIES = 72_000;

  /** Number of steps between two recorded positions of a path: a tenth of a second. */
  private static final long SAMPLE_STEPS = Math.round(0.1 / SimTime.STEP);

  private final List<Flight> flights = new ArrayList<>();
  private final GoalWatch gates;
  private final List<Goal> passages = new ArrayList<>();
  private volatile Supplier<SimSnapshot> snapshots = () -> null;
  private long run;
  private long steps;
  private int waiting;

  /** The recorded flight of one drone. */
  private static final class Flight {
    private final List<JournalEntry> journal = new ArrayList<>();

    /** Journal indexes of the commands, by command number. */
    private final Map<Integer, Integer> commands = new HashMap<>();

    private final List<Touch> touched = new ArrayList<>();
    private final List<Position> path = new ArrayList<>();
    private boolean crashed;
    private int takeoffs;
  }

  /**
   * Creates a monitor for the drones of a room.
   *
   * @param obstacles the obstacles of the room, including the gates
   * @param drones the number of drones
   */
  FlightMonitor(List<Obstacle> obstacles, int drones) {
    for (int drone = 1; drone <= drones; drone++) {
      flights.add(new Flight());
      for (Obstacle obstacle : obstacles) {
        if (obstacle.shape() instanceof Shape.Gate) {
          passages.add(new Goal.Pass(Terms.of(drone), obstacle.name(), Goal.Direction.EITHER));
        }
      }
    }
    gates =
        new GoalWatch(new Challenge(passages, false, OptionalDouble.empty(), false), news -> {});
  }

  /** Sets the supplier of the newest snapshot. */
  void attach(Supplier<SimSnapshot> newSnapshots) {
    snapshots = newSnapshots;
  }

  @Override
  public synchronized void event(SimEvent event) {
    take(event);
    notifyAll();
  }

  private void take(SimEvent event) {
    if (event instanceof SimEvent.RunStarted) {
      run++;
      flights.replaceAll(flight -> new Flight());
      steps = 0;
      gates.event(event);
    } else if (event instanceof SimEvent.DroneFlight flown) {
      happened(flights.get(flown.drone() - 1), flown);
    } else if (event instanceof SimEvent.FromPeer said) {
      write(flights.get(said.drone() - 1), said);
    }
  }

  private static void happened(Flight flight, SimEvent.DroneFlight flown) {
    double now = flown.time().seconds();
    if (flown.event() instanceof FlightEvent.TookOff) {
      flight.takeoffs++;
    } else if (flown.event() instanceof FlightEvent.Touched touch) {
      flight.touched.add(touch(touch.touched(), now, touch.speed(), false));
    } else if (flown.event() instanceof FlightEvent.Crashed crash) {
      flight.crashed = true;
      flight.touched.add(touch(crash.touched(), now, crash.speed(), true));
    }
  }

  private static Touch touch(Collidable touched, double now, double speed, boolean crash) {
    return new Touch(touched.phrase().english(), now, Frames.centimeters(speed), crash);
  }

  private static void write(Flight flight, SimEvent.FromPeer said) {
    double now = said.time().seconds();
    if (said instanceof SimEvent.ReplySent sent) {
      answer(flight, sent, Outcome.ANSWERED, sent.reply(), "");
    } else if (said instanceof SimEvent.CommandRefused refused) {
      answer(flight, refused, Outcome.REFUSED, refused.reply(), refused.reason().english());
    } else if (said instanceof SimEvent.CommandFailed failed) {
      answer(flight, failed, Outcome.FAILED, failed.reply(), failed.reason().english());
    } else if (said instanceof SimEvent.ReplyLost lost) {
      explainLost(flight.journal, lost);
    } else if (flight.journal.size() < MOST_ENTRIES) {
      Outcome outcome = Outcome.TAKEN;
      String explanation = "";
      if (said instanceof SimEvent.CommandReceived received) {
        flight.commands.put(received.request().number(), flight.journal.size());
      } else if (said instanceof SimEvent.CommandLost lost) {
        outcome = Outcome.LOST;
        explanation = lost.cause().english();
      } else if (said instanceof SimEvent.CommandIgnored ignored) {
        outcome = Outcome.IGNORED;
        explanation = ignored.reason().english();
      } else if (said instanceof SimEvent.TurnedAway turned) {
        outcome = Outcome.TURNED_AWAY;
        explanation = turned.reason().english();
      }
      flight.journal.add(
          new JournalEntry(
              said.text(), said.peer().address(), now, outcome, List.of(), explanation));
    }
  }

  /** Explains in the command's entry that the reply was sent but never arrived. */
  private static void explainLost(List<JournalEntry> journal, SimEvent.ReplyLost lost) {
    for (int i = journal.size() - 1; i >= 0; i--) {
      JournalEntry entry = journal.get(i);
      if (entry.sender().equals(lost.peer().address())
          && entry.reply().equals(lost.text().stripTrailing())) {
        String words = "the answer was lost by " + lost.cause().english();
        journal.set(
            i,
            entry.explained(
                entry.explanation().isEmpty() ? words : entry.explanation() + "; " + words));
        return;
      }
    }
  }

  private static void answer(
      Flight flight, SimEvent.OfCommand said, Outcome outcome, Reply reply, String explanation) {
    Integer index = flight.commands.get(said.request().number());
    if (index != null) { // null: the journal was full when the command arrived
      JournalEntry entry = flight.journal.get(index);
      double delay = said.time().seconds() - entry.seconds();
      Answer answer = new Answer(reply.text().stripTrailing(), delay);
      flight.journal.set(index, entry.answered(outcome, answer, explanation));
    }
  }

  @Override
  public synchronized void stepped(SimSnapshot snapshot) {
    follow(snapshot);
    if (waiting > 0) {
      notifyAll();
    }
  }

  private void follow(SimSnapshot snapshot) {
    if (steps % SAMPLE_STEPS == 0) {
      for (int i = 0; i < flights.size(); i++) {
        DroneSnapshot drone = snapshot.drones().get(i);
        if (drone.state().phase().flying()) {
          flights.get(i).path.add(Position.of(drone.state().motion().position()));
        }
      }
    }
    steps++;
    if (!passages.isEmpty()) {
      gates.stepped(snapshot);
    }
  }

  /** Returns the number of runs started so far. */
  synchronized long run() {
    return run;
  }

  /** Returns the journal of a drone: the texts that were sent to it, with their outcomes. */
  synchronized List<JournalEntry> journal(int drone) {
    return List.copyOf(flights.get(drone - 1).journal);
  }

  /** Returns the current true state of a drone. */
  synchronized DroneTruth truth(int drone) {
    return present(drone);
  }

  private DroneTruth present(int drone) {
    Flight flight = flights.get(drone - 1);
    DroneSnapshot now = snapshots.get().drones().get(drone - 1);
    Position position = Position.of(now.state().motion().position());
    List<Position> path = new ArrayList<>(flight.path);
    path.add(position);
    double heading = Frames.wrapped(now.state().motion().attitude().heading());
    return new DroneTruth(
        position,
        Frames.yawOfHeading(heading) + 0.0, // no negative zero
        now.state().energy().battery().percent(),
        now.state().phase().flying(),
        flight.crashed,
        flight.takeoffs,
        flight.touched,
        visited(drone),
        Position.of(now.start().position()),
        path);
  }

  /** Returns the gates that a drone flew through, in the order of the first passage. */
  private List<String> visited(int drone) {
    List<OptionalDouble> reached = gates.progress().reached();
    List<Integer> passed = new ArrayList<>();
    for (int i = 0; i < passages.size(); i++) {
      if (reached.get(i).isPresent() && passages.get(i).drone().orElse(0) == drone) {
        passed.add(i);
      }
    }
    passed.sort(Comparator.comparingDouble(i -> reached.get(i).getAsDouble()));
    return passed.stream().map(i -> ((Goal.Pass) passages.get(i)).gate()).toList();
  }

  /** Returns the names of all gates. */
  List<String> gates() {
    return passages.stream().map(pass -> ((Goal.Pass) pass).gate()).distinct().toList();
  }

  /**
   * Waits until a condition holds.
   *
   * @param timeout the maximum wait, in wall clock time
   * @param wanted the condition, evaluated after each event and step
   * @return the result of the condition; empty on timeout
   */
  synchronized <T> Optional<T> await(Duration timeout, Supplier<Optional<T>> wanted) {
    RealTimer timer = new RealTimer();
    double limit = timeout.toNanos() * 1e-9;
    waiting++;
    try {
      Optional<T> found = wanted.get();
      for (double left = limit; found.isEmpty() && left > 0; left = limit - timer.seconds()) {
        TimeUnit.NANOSECONDS.timedWait(this, (long) Math.ceil(left * 1e9));
        found = wanted.get();
      }
      return found;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    } finally {
      waiting--;
    }
  }
}
