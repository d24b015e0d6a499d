package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.controller.FlightEvent;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;

/**
 * Remembers where drones touched something or crashed, until they are put back to their starts.
 * Written on the simulation thread; to be read on any.
 */
public final class ContactLog implements SimListener {

  /** Most marks of all drones. Decided: more than can be told apart in a room. */
  static final int MOST = 200;

  /** Contacts that are nearer are one [m]. Decided: so that who rubs along a wall has few. */
  static final double SPACING = 0.1;

  private volatile List<ContactMark> marks = List.of();

  /** The marks, the oldest first; the same list until there are other ones. */
  public List<ContactMark> marks() {
    return marks;
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.Restarted) {
      marks = List.of();
    } else if (event instanceof SimEvent.DroneFlight flight) {
      happened(flight.drone(), flight.event());
    }
  }

  private void happened(int drone, FlightEvent event) {
    if (event instanceof FlightEvent.Touched touch) {
      add(drone, touch.position(), false);
    } else if (event instanceof FlightEvent.Crashed crash) {
      add(drone, crash.position(), true);
    } else if (event instanceof FlightEvent.PutBack) {
      marks = marks.stream().filter(mark -> mark.drone() != drone).toList();
    }
  }

  private void add(int drone, Vec3 place, boolean crash) {
    ContactMark mark = new ContactMark(drone, place, crash);
    marks = with(marks, mark);
  }

  /** Marks with one more, unless one of the same kind is there; the oldest ones give way. */
  static List<ContactMark> with(List<ContactMark> before, ContactMark mark) {
    boolean known =
        before.stream()
            .anyMatch(
                other ->
                    other.drone() == mark.drone()
                        && other.crash() == mark.crash()
                        && other.place().distanceTo(mark.place()) < SPACING);
    if (known) {
      return before;
    }
    List<ContactMark> all = new ArrayList<>(before);
    all.add(mark);
    return List.copyOf(all.subList(Math.max(0, all.size() - MOST), all.size()));
  }
}
