package tellosimulator.controller;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tellosimulator.controller.FlightEvent.Touched;
import tellosimulator.model.DroneSpec;
import tellosimulator.time.SimTime;
import tellosimulator.world.Collision;

/**
 * What a drone touches in a step, and what people are told of it. For one drone and the simulation
 * thread.
 */
final class Contacts {

  /** A touch this long after the last one is told anew [s]. Decided. */
  private static final double APART = 1;

  private final FlightObserver observer;
  private final List<Collision> present = new ArrayList<>(2);
  private SimTime now = SimTime.ZERO;
  private Optional<Collision> told = Optional.empty();
  private SimTime lastTouch = SimTime.ZERO;

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
    told = Optional.empty();
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
    boolean same =
        told.filter(last -> last.touched().equals(collision.touched())).isPresent()
            && now.since(lastTouch) < APART;
    lastTouch = now;
    if (!same && collision.speed() <= DroneSpec.CRASH_SPEED) {
      told = Optional.of(collision);
      observer.happened(new Touched(collision.touched(), collision.speed(), collision.position()));
    }
  }
}
