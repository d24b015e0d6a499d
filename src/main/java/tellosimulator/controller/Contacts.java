package tellosimulator.controller;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import tellosimulator.controller.FlightEvent.Parted;
import tellosimulator.controller.FlightEvent.Touched;
import tellosimulator.math.Vec3;
import tellosimulator.time.SimTime;
import tellosimulator.world.Collidable;
import tellosimulator.world.Collision;
import tellosimulator.world.Surface;

/**
 * What a drone touches in a step, and what people are told of it: one event for the beginning of a
 * contact and one for its end. For one drone and the simulation thread.
 */
final class Contacts {

  /** So far away from what it touched, a drone has parted from it [m]. Decided. */
  private static final double CLEARANCE = 0.03;

  /** Past the edge of a thing it has parted from it when this far from the last touch [m], … */
  private static final double PASSED = 0.1;

  /** … and after this time without a touch [s]. Decided: a drone that leans shivers. */
  private static final double APART = 2;

  /**
   * A contact while it lasts.
   *
   * @param since the first touch
   * @param last the last touch
   */
  private record Contact(SimTime since, SimTime last, Collision collision) {

    boolean ended(SimTime now, Vec3 position) {
      Vec3 away = position.minus(collision.position());
      boolean clear = away.dot(collision.normal()) > CLEARANCE;
      return clear || (away.norm() > PASSED && now.since(last) >= APART);
    }
  }

  private final FlightObserver observer;
  private final double crashSpeed;
  private final List<Collision> present = new ArrayList<>(2);
  private final Map<Collidable, Contact> contacts = new LinkedHashMap<>();
  private SimTime now = SimTime.ZERO;

  /**
   * @param crashSpeed above which a touch is a crash, and no contact [m/s]
   */
  Contacts(FlightObserver observer, double crashSpeed) {
    this.observer = observer;
    this.crashSpeed = crashSpeed;
  }

  /** A step begins. */
  void next(SimTime time) {
    now = time;
    present.clear();
  }

  /**
   * Something stopped the drone in this step.
   *
   * @param flying whether its motors carried it
   */
  void add(Collision collision, boolean flying) {
    present.add(collision);
    if (flying && !collision.onGround() && collision.speed() <= crashSpeed) {
      touch(collision);
    }
  }

  /** Tells of contacts that have come to their end now that the drone is at {@code position}. */
  void part(Vec3 position) {
    for (Iterator<Contact> each = contacts.values().iterator(); each.hasNext(); ) {
      Contact contact = each.next();
      if (contact.ended(now, position)) {
        each.remove();
        tellEnd(contact);
      }
    }
  }

  /** The flight is over, and so are all contacts. */
  void partFromAll() {
    contacts.values().forEach(this::tellEnd);
    contacts.clear();
  }

  void forget() {
    present.clear();
    contacts.clear();
  }

  /** Whether the drone stands on something. */
  boolean onGround() {
    return present.stream().anyMatch(Collision::onGround);
  }

  /** What the drone stands on; the floor if it stands on nothing else. */
  Collidable ground() {
    return present.stream()
        .filter(Collision::onGround)
        .map(Collision::touched)
        .findFirst()
        .orElse(Surface.FLOOR);
  }

  /** What is in its way; what it stands on is not. */
  Optional<Collision> obstacle() {
    return present.stream().filter(collision -> !collision.onGround()).findFirst();
  }

  private void touch(Collision collision) {
    Collidable touched = collision.touched();
    Contact before = contacts.get(touched);
    if (before == null) {
      observer.happened(new Touched(touched, collision.speed(), collision.position()));
    }
    contacts.put(touched, new Contact(before == null ? now : before.since(), now, collision));
  }

  private void tellEnd(Contact contact) {
    observer.happened(new Parted(contact.collision().touched(), now.since(contact.since())));
  }
}
