package tellosimulator.controller;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import tellosimulator.controller.FlightEvent.Touched;
import tellosimulator.model.DroneSpec;
import tellosimulator.time.SimTime;
import tellosimulator.world.Collision;
import tellosimulator.world.Touchable;

/**
 * What a drone touches in a step, and what people are told of it. For one drone and the simulation
 * thread.
 */
final class Contacts {

  /** A touch this long after the last one of the same thing is told anew [s]. Decided. */
  private static final double APART = 1;

  private final FlightObserver observer;
  private final List<Collision> present = new ArrayList<>(2);
  private SimTime now = SimTime.ZERO;
  private final Map<Touchable, SimTime> lastTouches = new HashMap<>();

  Contacts(FlightObserver observer) {
    this.observer = observer;
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
    if (flying && !collision.onGround()) {
      tell(collision);
    }
  }

  void forget() {
    present.clear();
    lastTouches.clear();
  }

  /** Whether the drone stands on something. */
  boolean onGround() {
    return present.stream().anyMatch(Collision::onGround);
  }

  /** What is in its way; what it stands on is not. */
  Optional<Collision> obstacle() {
    return present.stream().filter(collision -> !collision.onGround()).findFirst();
  }

  private void tell(Collision collision) {
    Optional<SimTime> last = Optional.ofNullable(lastTouches.put(collision.touched(), now));
    boolean goesOn = last.filter(time -> now.since(time) < APART).isPresent();
    if (!goesOn && collision.speed() <= DroneSpec.CRASH_SPEED) {
      observer.happened(new Touched(collision.touched(), collision.speed(), collision.position()));
    }
  }
}
