package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.controller.FlightEvent;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;

/**
 * Records where drones touched something or crashed, until they are put back at their starts.
 * Written on the simulation thread; readable from any thread.
 */
public final class ContactLog implements SimListener {

  /**
   * Maximum number of contacts, for all drones together. Decided: more than are distinguishable in
   * a room.
   */
  static final int MOST = 200;

  /**
   * Minimum distance between two contacts of the same kind and drone [m]; a nearer contact is not
   * recorded. Decided: a drone that scrapes along a wall causes only a few contacts.
   */
  static final double SPACING = 0.1;

  private volatile List<ContactDecal> marks = List.of();

  /**
   * Returns the contacts in chronological order. The list stays the same object until the contacts
   * change.
   */
  public List<ContactDecal> marks() {
    return marks;
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.RunStarted) {
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
    ContactDecal mark = new ContactDecal(drone, place, crash);
    marks = with(marks, mark);
  }

  /**
   * Returns the contacts with another one added, unless the same drone already has a contact of the
   * same kind within {@link #SPACING}. If there are too many contacts, the oldest are dropped.
   */
  static List<ContactDecal> with(List<ContactDecal> before, ContactDecal mark) {
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
    List<ContactDecal> all = new ArrayList<>(before);
    all.add(mark);
    return List.copyOf(all.subList(Math.max(0, all.size() - MOST), all.size()));
  }
}
