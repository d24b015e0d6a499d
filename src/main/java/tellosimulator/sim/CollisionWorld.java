package tellosimulator.sim;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.sensor.Echoes;
import tellosimulator.sensor.PadDetector.Card;
import tellosimulator.time.SimTime;
import tellosimulator.world.Arena;
import tellosimulator.world.Collider;
import tellosimulator.world.Collision;
import tellosimulator.world.Obstacles;
import tellosimulator.world.WindField;

/**
 * The current surroundings of each drone: the room, its obstacles, and the other drones. Not
 * thread-safe.
 */
final class CollisionWorld {

  private static final Collider COLLIDER = DroneSpec.COLLIDER;

  private final List<SimDrone> drones;
  private final long seed;
  private Arena arena;
  private Obstacles obstacles;
  private List<Card> cards;
  private WindField wind;

  /**
   * Creates the surroundings of a simulation's drones.
   *
   * @param drones in the order of their numbers; the list may change
   * @param seed the seed of all randomness
   */
  CollisionWorld(Arena arena, List<SimDrone> drones, long seed) {
    this.drones = drones;
    this.seed = seed;
    change(arena);
  }

  /** Replaces the arena. */
  void change(Arena newArena) {
    arena = newArena;
    obstacles = Obstacles.of(arena);
    cards = arena.pads().stream().map(pad -> new Card(pad.id(), pad.pose(arena.room()))).toList();
    wind = new WindField(arena.wind(), seed);
  }

  Arena arena() {
    return arena;
  }

  /** Returns the air velocity at a time, in the room frame [m/s]. */
  Vec3 wind(SimTime time) {
    return wind.at(time);
  }

  /** Returns the collision with an obstacle that stops a drone during a step, if any. */
  Optional<Collision> obstacle(DroneBody drone) {
    return obstacles.collide(drone.before(), drone.position(), drone.velocity(), COLLIDER);
  }

  /** Returns the collision with a wall, the floor or the ceiling that stops a drone, if any. */
  Optional<Collision> surface(DroneBody drone) {
    return arena.room().collide(drone.position(), drone.velocity(), COLLIDER);
  }

  /**
   * Returns whether a resting drone may have lost its support, or overlaps something. The result is
   * always true for a drone above the floor.
   */
  boolean unsettles(DroneBody drone) {
    Vec3 place = drone.position();
    return place.z() > 0
        || !arena.room().contains(place, COLLIDER)
        || obstacles.around(place, COLLIDER).isPresent();
  }

  /** Returns the mission pads in the room. */
  List<Card> cards() {
    return cards;
  }

  /**
   * Returns whether the straight line between two points is free of obstacles. The last centimetre
   * of the line is ignored.
   */
  boolean free(Vec3 from, Vec3 to) {
    Vec3 way = to.minus(from);
    double distance = way.norm();
    return obstacles.distance(from, way.normalized(), distance) >= distance - 0.01;
  }

  /**
   * Returns the surroundings that a drone's distance sensors detect: room, obstacles, other drones.
   */
  Echoes echoes(int number) {
    return new Echoes() {
      @Override
      public double below(Pose drone) {
        double down = drone.attitude().up().z();
        return down > 0
            ? nearest(
                number,
                drone.position(),
                drone.attitude().up().times(-1),
                drone.position().z() / down)
            : Double.POSITIVE_INFINITY;
      }

      @Override
      public double along(Vec3 origin, Vec3 direction) {
        return nearest(number, origin, direction, arena.room().distance(origin, direction));
      }
    };
  }

  /**
   * Returns the distance along a ray to the nearest obstacle or other drone [m], but at most {@code
   * limit}.
   */
  private double nearest(int number, Vec3 origin, Vec3 direction, double limit) {
    double nearest = obstacles.distance(origin, direction, limit);
    for (SimDrone other : drones) {
      if (other.number() != number) {
        nearest = Math.min(nearest, other.body().distanceAlong(origin, direction));
      }
    }
    return nearest;
  }
}
