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
 * Tracks the objects that a drone touches, and reports the beginning and the end of each contact in
 * one event each. One instance per drone, confined to the simulation thread.
 */
final class Contacts {

  /** Clearance from the touched object at which a contact ends [m]. Decided. */
  private static final double CLEARANCE = 0.03;

  /**
   * Distance from the last touch [m]. Beyond this distance, a contact ends once {@link #APART} has
   * passed, because the drone has moved past an edge of the object.
   */
  private static final double PASSED = 0.1;

  /**
   * Time since the last touch [s] after which the contact of a drone beyond {@link #PASSED} ends.
   * Decided: long enough to bridge the gaps between touches of a drone that trembles while it leans
   * on an object.
   */
  private static final double APART = 2;

  /**
   * A current contact.
   *
   * @param since the time of the first touch
   * @param last the time of the last touch
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
   * Creates a tracker without contacts.
   *
   * @param crashSpeed the speed above which a touch is a crash instead of a contact [m/s]
   */
  Contacts(FlightObserver observer, double crashSpeed) {
    this.observer = observer;
    this.crashSpeed = crashSpeed;
  }

  /** Begins a step. */
  void next(SimTime time) {
    now = time;
    present.clear();
  }

  /**
   * Adds a collision that stopped the drone in this step.
   *
   * @param flying whether the drone flew with its motors running
   */
  void add(Collision collision, boolean flying) {
    present.add(collision);
    if (flying && !collision.onGround() && collision.speed() <= crashSpeed) {
      touch(collision);
    }
  }

  /** Reports the end of the contacts that are over, now that the drone is at {@code position}. */
  void part(Vec3 position) {
    for (Iterator<Contact> each = contacts.values().iterator(); each.hasNext(); ) {
      Contact contact = each.next();
      if (contact.ended(now, position)) {
        each.remove();
        tellEnd(contact);
      }
    }
  }

  /** Reports the end of all contacts, because the flight is over. */
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

  /** Returns the object on which the drone stands; the floor if there is no other. */
  Collidable ground() {
    return present.stream()
        .filter(Collision::onGround)
        .map(Collision::touched)
        .findFirst()
        .orElse(Surface.FLOOR);
  }

  /**
   * Returns the collision with an obstacle in the drone's way, if any. The ground below the drone
   * is not an obstacle.
   */
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
