package tellosimulator.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tellosimulator.fault.Fault.AfterCommand;
import tellosimulator.fault.Fault.AfterTakeoff;
import tellosimulator.fault.Fault.AtOnce;
import tellosimulator.fault.Fault.Begin;
import tellosimulator.time.SimTime;

/**
 * Tracks which faults are active on each drone, and when they begin and end. For the simulation
 * thread.
 *
 * <p>The clock of {@code at} starts with the first takeoff of any drone, and anew when a person
 * puts a drone back: then the faults of the plan begin again in their turn.
 */
public final class FaultSchedule {

  /** Is told what begins and ends. */
  public interface Observer {

    /** A fault acts from now on. */
    void began(int drone, Fault fault);

    /** A fault acts no more. */
    void ended(int drone, Fault fault);
  }

  private enum State {
    WAITING,
    ACTING,
    OVER
  }

  /** A fault of one drone. */
  private static final class Entry {
    private final Fault fault;
    private final int drone;
    private final boolean planned;
    private State state = State.WAITING;
    private int commands;
    private SimTime begun = SimTime.ZERO;

    Entry(Fault fault, int drone, boolean planned) {
      this.fault = fault;
      this.drone = drone;
      this.planned = planned;
    }

    private Begin begin() {
      return fault.span().begin();
    }

    /** Whether it acts from the start to the end. */
    private boolean lasting() {
      return begin() instanceof AtOnce && fault.span().seconds().isEmpty();
    }
  }

  private final int drones;
  private final Observer observer;
  private final List<Entry> entries = new ArrayList<>();

  /** Those that act, in the order in which they began. */
  private final List<Entry> acting = new ArrayList<>();

  private Optional<SimTime> takeoff = Optional.empty();

  /** Nothing acts yet; {@link #advance} begins. */
  public FaultSchedule(FaultPlan plan, int drones, Observer observer) {
    this.drones = drones;
    this.observer = observer;
    plan.faults().forEach(fault -> add(fault, true));
  }

  private void add(Fault fault, boolean planned) {
    for (int drone = 1; drone <= drones; drone++) {
      if (fault.concerns(drone)) {
        entries.add(new Entry(fault, drone, planned));
      }
    }
  }

  /** What acts on a drone, in the order in which it began. */
  public List<Fault> acting(int drone) {
    return acting.stream().filter(entry -> entry.drone == drone).map(entry -> entry.fault).toList();
  }

  /** One more fault, which begins at once unless it waits for something. */
  public void inject(Fault fault, SimTime now) {
    entries.removeIf(entry -> entry.state == State.OVER && !entry.planned);
    add(fault, false);
    advance(now);
  }

  /** No fault any more. */
  public void clear() {
    List.copyOf(acting).forEach(this::end);
    entries.clear();
  }

  /** Lets the faults of the plan begin in their turn again. */
  public void restart(SimTime now) {
    takeoff = Optional.empty();
    for (Entry entry : entries) {
      if (entry.planned && !entry.lasting()) {
        if (entry.state == State.ACTING) {
          end(entry);
        }
        entry.state = State.WAITING;
        entry.commands = 0;
      }
    }
    advance(now);
  }

  /** A drone took off. */
  public void tookOff(SimTime now) {
    if (takeoff.isEmpty()) {
      takeoff = Optional.of(now);
      advance(now);
    }
  }

  /** A drone takes a command, and has not carried it out yet. */
  public void commanded(int drone, String text, SimTime now) {
    for (Entry entry : entries) {
      if (entry.drone == drone
          && entry.state == State.WAITING
          && entry.begin() instanceof AfterCommand after
          && text.startsWith(after.text())
          && ++entry.commands == after.nth()) {
        begin(entry, now);
      }
    }
  }

  /** Begins and ends what is due. */
  public void advance(SimTime now) {
    if (entries.isEmpty()) {
      return;
    }
    for (Entry entry : entries) {
      if (entry.state == State.WAITING && due(entry.begin(), now)) {
        begin(entry, now);
      } else if (entry.state == State.ACTING
          && now.since(entry.begun)
              >= entry.fault.span().seconds().orElse(Double.POSITIVE_INFINITY)) {
        end(entry);
      }
    }
  }

  private boolean due(Begin begin, SimTime now) {
    return begin instanceof AtOnce
        || (begin instanceof AfterTakeoff after
            && takeoff.isPresent()
            && now.since(takeoff.get()) >= after.seconds());
  }

  private void begin(Entry entry, SimTime now) {
    entry.state = State.ACTING;
    entry.begun = now;
    acting.add(entry);
    observer.began(entry.drone, entry.fault);
  }

  private void end(Entry entry) {
    entry.state = State.OVER;
    acting.remove(entry);
    observer.ended(entry.drone, entry.fault);
  }
}
