package tellosimulator.junit;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.assertj.core.api.AbstractAssert;

/**
 * Assertions about a drone, in centimetres and degrees. Each assertion first waits until a falling
 * drone has reached the ground. {@link SimulatedDrone#truth} provides the same facts without
 * AssertJ.
 */
public final class DroneAssert extends AbstractAssert<DroneAssert, SimulatedDrone> {

  DroneAssert(SimulatedDrone drone) {
    super(drone, DroneAssert.class);
  }

  /** Asserts that the drone has flown and now stands undamaged with its motors off. */
  public DroneAssert hasLanded() {
    DroneTruth truth = truth();
    if (!truth.landed()) {
      String why = truth.takeoffs() == 0 && !truth.crashed() ? ", and never took off" : "";
      fail("%s has not landed: it %s%s", actual, where(truth), why);
    }
    return this;
  }

  /** Asserts that the drone is airborne. */
  public DroneAssert isFlying() {
    DroneTruth truth = truth();
    if (!truth.flying()) {
      fail("%s is not flying: it %s", actual, where(truth));
    }
    return this;
  }

  /** Asserts how often the drone has taken off. */
  public DroneAssert tookOff(Times times) {
    int takeoffs = truth().takeoffs();
    if (!times.holds(takeoffs)) {
      fail("%s: expected to take off %s, but did %s", actual, times, Times.times(takeoffs));
    }
    return this;
  }

  /** Asserts that the drone has crashed. */
  public DroneAssert hasCrashed() {
    DroneTruth truth = truth();
    if (!truth.crashed()) {
      fail("%s has not crashed: it %s", actual, where(truth));
    }
    return this;
  }

  /** Asserts that the drone has never crashed. */
  public DroneAssert neverCrashed() {
    DroneTruth truth = truth();
    if (truth.crashed()) {
      fail("%s crashed: it %s", actual, touches(truth));
    }
    return this;
  }

  /** Asserts that the drone has touched nothing in flight and has not crashed. */
  public DroneAssert neverTouchedAnything() {
    DroneTruth truth = truth();
    if (!truth.touched().isEmpty()) {
      fail("%s should touch nothing, but %s", actual, touches(truth));
    }
    return this;
  }

  /** Asserts that the drone's feet always stayed below a given height above the floor [cm]. */
  public DroneAssert stayedBelow(double height) {
    double highest = truth().highest();
    if (highest >= height) {
      fail("%s should stay below %s, but was %s high", actual, cm(height), cm(highest));
    }
    return this;
  }

  /** Asserts that the drone has reached at least a given height above the floor [cm]. */
  public DroneAssert climbedTo(double height) {
    double highest = truth().highest();
    if (highest < height) {
      fail("%s should climb to %s, but was only %s high", actual, cm(height), cm(highest));
    }
    return this;
  }

  /** Asserts that the drone never exceeded a given horizontal distance from its start [cm]. */
  public DroneAssert stayedWithin(double distance) {
    double farthest = truth().farthest();
    if (farthest > distance) {
      fail(
          "%s should stay within %s of its start, but was %s away",
          actual, cm(distance), cm(farthest));
    }
    return this;
  }

  /**
   * Asserts that the drone's heading equals a value within a tolerance, both in degrees. The
   * heading is measured clockwise from the room's x axis.
   */
  public DroneAssert hasHeading(double heading, double tolerance) {
    double difference = Math.abs(Math.IEEEremainder(truth().heading() - heading, 360));
    if (difference > tolerance) {
      fail(
          "%s should look at %.0f degrees, give or take %.0f, but looks at %.0f",
          actual, heading, tolerance, truth().heading());
    }
    return this;
  }

  /**
   * Asserts that the drone flew through a gate.
   *
   * @throws IllegalArgumentException if the room has no gate with that name
   */
  public DroneAssert visited(String gate) {
    List<String> gates = actual.gates();
    if (!gates.contains(gate)) {
      throw new IllegalArgumentException(
          gates.isEmpty()
              ? "the room has no gates, so none is called " + gate
              : "no gate is called " + gate + ", the gates are " + String.join(", ", gates));
    }
    List<String> visited = truth().visited();
    if (!visited.contains(gate)) {
      fail(
          "%s did not fly through %s, but through %s",
          actual, gate, visited.isEmpty() ? "none" : String.join(", ", visited));
    }
    return this;
  }

  /**
   * Begins an assertion that the drone is near a place. A method of the returned object then names
   * the place.
   *
   * @param distance the maximum horizontal distance [cm]
   */
  public Nearness isWithin(double distance) {
    return new Nearness(distance);
  }

  /** The second half of {@link #isWithin}: the place from which the distance is measured. */
  public final class Nearness {

    private final double distance;

    private Nearness(double distance) {
      this.distance = distance;
    }

    /** Asserts that the drone is within the distance of its start. */
    public DroneAssert ofStart() {
      return of("its start", truth().start());
    }

    /**
     * Asserts that the drone is within the distance of a point on the floor [cm]. The room's x axis
     * runs along its depth, and its y axis to the left.
     */
    public DroneAssert of(double x, double y) {
      return of(String.format(Locale.ROOT, "x %.0f, y %.0f cm", x, y), new Position(x, y, 0));
    }

    private DroneAssert of(String name, Position place) {
      double away = truth().position().levelDistanceTo(place);
      if (away > distance) {
        fail(
            "%s should be within %s of %s, but is %s away, at %s",
            actual, cm(distance), name, cm(away), truth().position());
      }
      return DroneAssert.this;
    }
  }

  private DroneTruth truth() {
    isNotNull();
    actual.awaitFalls();
    return actual.truth();
  }

  private void fail(String message, Object... values) {
    failWithMessage("%s", String.format(Locale.ROOT, message, values));
  }

  private static String where(DroneTruth truth) {
    return FlightExplanation.phase(truth) + " at " + truth.position();
  }

  private static String touches(DroneTruth truth) {
    return truth.touched().stream().map(FlightExplanation::touch).collect(Collectors.joining(", "));
  }

  private static String cm(double length) {
    return String.format(Locale.ROOT, "%.0f cm", length);
  }
}
