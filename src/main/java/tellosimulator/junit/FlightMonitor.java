package tellosimulator.junit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import tellosimulator.command.Peer;
import tellosimulator.controller.FlightEvent;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalWatch;
import tellosimulator.junit.DroneTruth.Touch;
import tellosimulator.junit.JournalEntry.Answer;
import tellosimulator.junit.JournalEntry.Outcome;
import tellosimulator.math.Frames;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.world.Collidable;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/**
 * Writes down what comes to the drones and what they do, since the simulation began anew. It is
 * told on the simulation thread; what it knows is for any thread.
 */
final class FlightMonitor implements SimListener {

  /** Texts that are kept of a drone. Decided: an hour of {@code rc} at 20 a second. */
  private static final int MOST_ENTRIES = 72_000;

  /** Steps from place to place of a path: a tenth of a second. */
  private static final long SAMPLE_STEPS = Math.round(0.1 / SimTime.STEP);

  private final List<Flight> flights = new ArrayList<>();
  private final GoalWatch gates;
  private final List<Goal> passages = new ArrayList<>();
  private final ReentrantLock lock = new ReentrantLock();

  /** Signalled after each event, and after each step while somebody waits. */
  private final Condition changed = lock.newCondition();

  private volatile Supplier<SimSnapshot> snapshots = () -> null;
  private long run;
  private long steps;
  private int waiting;

  /** One drone's. */
  private static final class Flight {
    private final List<JournalEntry> journal = new ArrayList<>();
    private final List<Touch> touched = new ArrayList<>();
    private final List<Position> path = new ArrayList<>();
    private boolean crashed;
    private int takeoffs;
  }

  /**
   * @param obstacles of the room, among them the gates
   * @param drones how many there are
   */
  FlightMonitor(List<Obstacle> obstacles, int drones) {
    for (int drone = 1; drone <= drones; drone++) {
      flights.add(new Flight());
      for (Obstacle obstacle : obstacles) {
        if (obstacle.shape() instanceof Shape.Gate) {
          passages.add(
              new Goal.Pass(OptionalInt.of(drone), obstacle.name(), Goal.Direction.EITHER));
        }
      }
    }
    gates =
        new GoalWatch(new Challenge(passages, false, OptionalDouble.empty(), false), news -> {});
  }

  /** Whom to ask for the newest snapshot. */
  void attach(Supplier<SimSnapshot> newSnapshots) {
    snapshots = newSnapshots;
  }

  @Override
  public void event(SimEvent event) {
    lock.lock();
    try {
      take(event);
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  private void take(SimEvent event) {
    if (event instanceof SimEvent.Restarted) {
      run++;
      flights.replaceAll(flight -> new Flight());
      steps = 0;
      gates.event(event);
    } else if (event instanceof SimEvent.DroneFlight flown) {
      happened(flights.get(flown.drone() - 1), flown);
    } else if (event instanceof SimEvent.FromPeer said) {
      write(flights.get(said.drone() - 1).journal, said);
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

  private static void write(List<JournalEntry> journal, SimEvent.FromPeer said) {
    double now = said.time().seconds();
    if (said instanceof SimEvent.ReplySent sent) {
      answer(journal, sent, Outcome.ANSWERED, sent.reply().text(), "");
    } else if (said instanceof SimEvent.CommandRefused refused) {
      answer(journal, said, Outcome.REFUSED, refused.reply().text(), refused.reason().english());
    } else if (said instanceof SimEvent.CommandFailed failed) {
      answer(journal, said, Outcome.FAILED, failed.reply().text(), failed.reason().english());
    } else if (said instanceof SimEvent.ReplyLost lost) {
      explainLost(journal, lost);
    } else if (journal.size() < MOST_ENTRIES) {
      Outcome outcome = Outcome.TAKEN;
      String explanation = "";
      if (said instanceof SimEvent.CommandLost lost) {
        outcome = Outcome.LOST;
        explanation = lost.cause().english();
      } else if (said instanceof SimEvent.CommandIgnored ignored) {
        outcome = Outcome.IGNORED;
        explanation = ignored.reason().english();
      } else if (said instanceof SimEvent.TurnedAway turned) {
        outcome = Outcome.TURNED_AWAY;
        explanation = turned.reason().english();
      }
      journal.add(
          new JournalEntry(
              said.text(), said.peer().address(), now, outcome, List.of(), explanation));
    }
  }

  /** Its answer was given, but never arrived. */
  private static void explainLost(List<JournalEntry> journal, SimEvent.ReplyLost lost) {
    for (int i = journal.size() - 1; i >= 0; i--) {
      JournalEntry entry = journal.get(i);
      if (from(lost.peer(), entry) && entry.reply().equals(lost.text().stripTrailing())) {
        String words = "the answer was lost by " + lost.cause().english();
        journal.set(
            i,
            entry.explained(
                entry.explanation().isEmpty() ? words : entry.explanation() + "; " + words));
        return;
      }
    }
  }

  /** Answers belong to the first such text that has none, or else to the last such text. */
  private static void answer(
      List<JournalEntry> journal,
      SimEvent.FromPeer said,
      Outcome outcome,
      String reply,
      String explanation) {
    int found = -1;
    for (int i = journal.size() - 1; i >= 0; i--) {
      JournalEntry entry = journal.get(i);
      if (entry.text().equals(said.text()) && from(said.peer(), entry)) {
        boolean open = entry.outcome() == Outcome.TAKEN;
        if (found < 0 || open) {
          found = i;
        }
        if (outcome == Outcome.REFUSED) {
          break; // at once, so it is the last one
        }
      }
    }
    if (found >= 0) {
      JournalEntry entry = journal.get(found);
      Answer answer = new Answer(reply.stripTrailing(), said.time().seconds() - entry.seconds());
      journal.set(found, entry.answered(outcome, answer, explanation));
    }
  }

  private static boolean from(Peer peer, JournalEntry entry) {
    return entry.sender().equals(peer.address());
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    lock.lock();
    try {
      follow(snapshot);
      if (waiting > 0) {
        changed.signalAll();
      }
    } finally {
      lock.unlock();
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

  /** How often the simulation began anew. */
  long run() {
    lock.lock();
    try {
      return run;
    } finally {
      lock.unlock();
    }
  }

  /** What came to a drone. */
  List<JournalEntry> journal(int drone) {
    lock.lock();
    try {
      return List.copyOf(flights.get(drone - 1).journal);
    } finally {
      lock.unlock();
    }
  }

  /** What is so about a drone now. */
  DroneTruth truth(int drone) {
    lock.lock();
    try {
      return present(drone);
    } finally {
      lock.unlock();
    }
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

  /** The gates that a drone flew through, in order. */
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

  /** The names of all gates. */
  List<String> gates() {
    return passages.stream().map(pass -> ((Goal.Pass) pass).gate()).distinct().toList();
  }

  /**
   * Waits for something.
   *
   * @param timeout how long at the most, by the wall clock
   * @param wanted what is waited for, asked after each event and step
   * @return empty if it did not come in time
   */
  <T> Optional<T> await(Duration timeout, Supplier<Optional<T>> wanted) {
    lock.lock();
    waiting++;
    try {
      long left = timeout.toNanos();
      Optional<T> found = wanted.get();
      while (found.isEmpty() && left > 0) {
        left = changed.awaitNanos(left);
        found = wanted.get();
      }
      return found;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    } finally {
      waiting--;
      lock.unlock();
    }
  }
}
