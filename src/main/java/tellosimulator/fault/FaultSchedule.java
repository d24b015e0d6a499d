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
 * Tracks which faults are active on each drone, and when they begin and end. Confined to the
 * simulation thread.
 *
 * <p>Times given with {@code at} count from the first takeoff of any drone. When a drone is put
 * back at its start, this count is reset, and the faults of the plan begin again when they are due.
 */
public final class FaultSchedule {

  /** A listener that is notified when faults begin and end. */
  public interface Observer {

    /** Called when a fault begins to affect a drone. */
    void began(int drone, Fault fault);

    /** Called when a fault no longer affects a drone. */
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

    /** Whether the fault begins at once and never ends. */
    private boolean lasting() {
      return begin() instanceof AtOnce && fault.span().seconds().isEmpty();
    }
  }

  private final int drones;
  private final Observer observer;
  private final List<Entry> entries = new ArrayList<>();

  /** The active faults, in the order in which they began. */
  private final List<Entry> acting = new ArrayList<>();

  private Optional<SimTime> takeoff = Optional.empty();

  /**
   * Creates a schedule in which no fault is active yet. The first call of {@link #advance} begins
   * the faults that are due at the start.
   */
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

  /** Returns the faults that are active on a drone, in the order in which they began. */
  public List<Fault> acting(int drone) {
    return acting.stream().filter(entry -> entry.drone == drone).map(entry -> entry.fault).toList();
  }

  /** Adds a fault. It begins at once unless it has a later trigger. */
  public void inject(Fault fault, SimTime now) {
    entries.removeIf(entry -> entry.state == State.OVER && !entry.planned);
    add(fault, false);
    advance(now);
  }

  /** Ends and removes all faults. */
  public void clear() {
    List.copyOf(acting).forEach(this::end);
    entries.clear();
  }

  /** Resets the faults of the plan, so that they begin again when they are due. */
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

  /** Records that a drone has taken off. */
  public void tookOff(SimTime now) {
    if (takeoff.isEmpty()) {
      takeoff = Optional.of(now);
      advance(now);
    }
  }

  /** Records that a drone has received a command. Called before the command is carried out. */
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

  /** Begins and ends the faults that are due. */
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
