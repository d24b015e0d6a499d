package tellosimulator.view.pilot;

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
 * Which commands show a drone's abilities in a room without touching its walls: a half circle, a
 * flip, turns and moves where there is space, a few short moves where there is little, and only
 * turns where obstacles or other drones are in the way of these.
 *
 * <p>All of it happens within a circle around a point near the start, so it fits whichever way the
 * nose points.
 */
final class DemoTour {

  /** Air at the walls for errors that add up over a long tour [m]. Measured: 2.5 cm a move. */
  private static final double LONG_MARGIN = 0.35;

  /** The same for a short tour [m]. */
  private static final double SHORT_MARGIN = 0.2;

  /** Radius of a long tour [m]. Decided: easily seen in the default room; a curve needs 0.5. */
  private static final double LARGEST_RADIUS = 1.2;

  private static final double SMALLEST_LONG_RADIUS = 0.55;

  /** Length of the moves of a short tour [m]. Documented: a move has 20 cm at the least. */
  private static final double LARGEST_SHORT_RADIUS = 0.5;

  private static final double SMALLEST_SHORT_RADIUS = 0.2;

  /** Heights of flight [m]. Decided: eye level, or what a low room leaves. */
  private static final double HIGHEST_CRUISE = 1.2;

  private static final double LOWEST_CRUISE = 0.45;

  /** Air between flight and ceiling in a low room [m]. Assumed: a flip fits below. */
  private static final double CEILING_AIR = 0.75;

  /** What a flip needs above the drone's feet [m]. Measured in the simulation: 0.44. */
  private static final double FLIP_AIR = 0.64;

  /** How much higher the second half is [m], if the ceiling allows it. */
  private static final double RISE = 0.4;

  /** Air above the second half [m]. */
  private static final double RISE_AIR = 0.6;

  /**
   * Battery percentage for a flip. Measured: the drone asks for 50, and by then a filming one has
   * used 6.
   */
  private static final int ENOUGH_FOR_FLIP = 58;

  private final Room room;
  private final FreeSpace space;
  private final Behavior behavior;
  private final Pose pose;
  private final int batteryPercent;

  /**
   * @param number of a drone that stands, from 1
   */
  DemoTour(SimSnapshot snapshot, int number) {
    DroneSnapshot drone = snapshot.drones().get(number - 1);
    this.room = snapshot.room();
    this.space = new FreeSpace(snapshot, number);
    this.behavior = drone.product().behavior();
    this.pose = drone.state().motion().pose();
    this.batteryPercent = drone.state().energy().battery().percent();
  }

  /** From {@code command} to {@code land}. */
  List<String> commands() {
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

  /** Radius around the room's middle that leaves {@code margin} at the walls [m]. */
  private double freeRadius(double margin) {
    return Math.min(room.width(), room.depth()) / 2 - DroneSpec.COLLIDER.radius() - margin;
  }

  /** The place nearest to the start that has this much air around it [m]. */
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

  /** How high the feet can be [m]. */
  private double top() {
    return room.height() - DroneSpec.COLLIDER.height();
  }

  private static double within(double value, double limit) {
    double most = Math.max(0, limit);
    return Math.max(-most, Math.min(most, value));
  }
}
