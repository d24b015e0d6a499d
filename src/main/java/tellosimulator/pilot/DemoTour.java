package tellosimulator.pilot;

import java.util.List;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.profile.Behavior;
import tellosimulator.sim.FreeSpace;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.world.Room;

/**
 * Plans the commands of a demonstration that stays clear of the walls. In a large space, it
 * consists of a half circle, a flip, turns and moves; in a small one, of a few short moves and
 * turns. If obstacles or other drones are in the way, the drone only turns.
 *
 * <p>All movements stay within a circle around a point near the start, so that the tour fits,
 * whichever way the nose points.
 */
public final class DemoTour {

  /**
   * Clearance from the walls in a long tour [m]. Position errors add up during the tour. Measured:
   * an error of 2.5 cm per move.
   */
  private static final double LONG_MARGIN = 0.35;

  /** Clearance from the walls in a short tour [m]. */
  private static final double SHORT_MARGIN = 0.2;

  /** Maximum radius of a long tour [m]. Decided: clearly visible in the default room. */
  private static final double LARGEST_RADIUS = 1.2;

  /** Minimum radius of a long tour [m]. Decided: a curve needs at least 0.5 m. */
  private static final double SMALLEST_LONG_RADIUS = 0.55;

  /** Maximum length of the moves of a short tour [m]. */
  private static final double LARGEST_SHORT_RADIUS = 0.5;

  /** Minimum length of the moves of a short tour [m]. Documented: a move is at least 20 cm long. */
  private static final double SMALLEST_SHORT_RADIUS = 0.2;

  /** Maximum flight height [m]. Decided: at eye level. In a low room, the drone flies lower. */
  private static final double HIGHEST_CRUISE = 1.2;

  /** Minimum flight height, even in a low room [m]. */
  private static final double LOWEST_CRUISE = 0.45;

  /**
   * In a low room: the distance from the flight height up to the greatest possible height of the
   * feet [m]. Assumed: enough for a flip.
   */
  private static final double CEILING_AIR = 0.75;

  /**
   * Space that a flip needs above the drone's feet [m]. Measured in the simulation: the drone
   * climbs by 0.44 m.
   */
  private static final double FLIP_AIR = 0.64;

  /** Additional flight height of the second half of the tour, if the ceiling allows it [m]. */
  private static final double RISE = 0.4;

  /** Clearance above the drone in the second half of the tour [m]. */
  private static final double RISE_AIR = 0.6;

  /**
   * Minimum battery percentage for a flip. Measured: the drone requires 50 %; if it streams video,
   * it has used 6 % by the time of the flip.
   */
  private static final int ENOUGH_FOR_FLIP = 58;

  private final Room room;
  private final FreeSpace space;
  private final Behavior behavior;
  private final Pose pose;
  private final int batteryPercent;

  /**
   * Plans a tour.
   *
   * @param number the number of a standing drone, from 1
   */
  public DemoTour(SimSnapshot snapshot, int number) {
    DroneSnapshot drone = snapshot.drones().get(number - 1);
    this.room = snapshot.room();
    this.space = new FreeSpace(snapshot, number);
    this.behavior = drone.product().behavior();
    this.pose = drone.state().motion().pose();
    this.batteryPercent = drone.state().energy().battery().percent();
  }

  /** Returns the commands, from {@code command} to {@code land}. */
  public List<String> commands() {
    double radius = Math.min(LARGEST_RADIUS, freeRadius(LONG_MARGIN));
    FlightPlan route = begun();
    if (radius >= SMALLEST_LONG_RADIUS) {
      flyLong(route, radius);
    } else {
      flyShort(route);
    }
    if (!space.holds(route.path())) {
      route = begun();
      flyShort(route);
    }
    if (!space.holds(route.path())) {
      route = begun().clockwise(180).clockwise(180);
    }
    return route.say("land").commands();
  }

  private FlightPlan begun() {
    return FlightPlan.from(pose)
        .say("command")
        .takeoff(behavior.takeoffHeight() + behavior.takeoffCreep());
  }

  private void flyLong(FlightPlan route, double radius) {
    int radiusCm = (int) Math.floor(radius * 100);
    int sideCm = radiusCm * 2 / 3;
    double cruise = cruise();
    Vec3 middle = nearestMiddle(radius + LONG_MARGIN).withZ(cruise);
    route.goTo(middle).forward(radiusCm).clockwise(-90);
    route.halfCircleToTheLeft(radiusCm).clockwise(90);
    if (flips(cruise)) {
      route.flipForward();
    }
    route.goTo(middle.withZ(risen(cruise))).right(sideCm).clockwise(180).right(sideCm);
    route.clockwise(180).goTo(nearestMiddle(LONG_MARGIN).withZ(cruise));
  }

  private void flyShort(FlightPlan route) {
    double radius =
        Math.max(SMALLEST_SHORT_RADIUS, Math.min(LARGEST_SHORT_RADIUS, freeRadius(SHORT_MARGIN)));
    int radiusCm = (int) Math.floor(radius * 100);
    route.goTo(nearestMiddle(radius + SHORT_MARGIN).withZ(cruise()));
    route.forward(radiusCm).clockwise(180).forward(radiusCm).clockwise(180);
    route.goTo(nearestMiddle(SHORT_MARGIN).withZ(cruise()));
  }

  /**
   * Returns the radius of the largest circle around the middle of the room along which a drone
   * stays {@code margin} away from the walls [m].
   */
  private double freeRadius(double margin) {
    return Math.min(room.width(), room.depth()) / 2 - DroneSpec.COLLIDER.radius() - margin;
  }

  /**
   * Returns the place nearest to the start at which the drone is at least {@code air} away from all
   * walls, or as far away as a narrow room allows [m]. Its height is 0.
   */
  private Vec3 nearestMiddle(double air) {
    return new Vec3(
        within(pose.position().x(), room.depth() / 2 - DroneSpec.COLLIDER.radius() - air),
        within(pose.position().y(), room.width() / 2 - DroneSpec.COLLIDER.radius() - air),
        0);
  }

  private double cruise() {
    return Math.max(LOWEST_CRUISE, Math.min(HIGHEST_CRUISE, top() - CEILING_AIR));
  }

  private double risen(double cruise) {
    return cruise + RISE + RISE_AIR <= top() ? cruise + RISE : cruise;
  }

  private boolean flips(double cruise) {
    return batteryPercent >= ENOUGH_FOR_FLIP && cruise + FLIP_AIR <= top();
  }

  /** Returns the greatest possible height of the feet [m]. */
  private double top() {
    return room.height() - DroneSpec.COLLIDER.height();
  }

  private static double within(double value, double limit) {
    double most = Math.max(0, limit);
    return Math.max(-most, Math.min(most, value));
  }
}
