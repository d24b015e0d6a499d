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

/** What is around each drone now: the room, what stands in it, and the others. For one thread. */
final class CollisionWorld {

  private static final Collider COLLIDER = DroneSpec.COLLIDER;

  private final List<SimDrone> drones;
  private final long seed;
  private Arena arena;
  private Obstacles obstacles;
  private List<Card> cards;
  private WindField wind;

  /**
   * @param drones in the order of their numbers; may change
   * @param seed of everything random
   */
  CollisionWorld(Arena arena, List<SimDrone> drones, long seed) {
    this.drones = drones;
    this.seed = seed;
    change(arena);
  }

  /** Something else is there now. */
  void change(Arena newArena) {
    arena = newArena;
    obstacles = Obstacles.of(arena);
    cards = arena.pads().stream().map(pad -> new Card(pad.id(), pad.pose(arena.room()))).toList();
    wind = new WindField(arena.wind(), seed);
  }

  Arena arena() {
    return arena;
  }

  /** Velocity of the air, room frame [m/s]. */
  Vec3 wind(SimTime time) {
    return wind.at(time);
  }

  /** The obstacle that stops a drone on its way through a step. */
  Optional<Collision> obstacle(SimDrone drone) {
    return obstacles.collide(drone.before(), drone.position(), drone.velocity(), COLLIDER);
  }

  /** The side of the room that stops a drone. */
  Optional<Collision> surface(SimDrone drone) {
    return arena.room().collide(drone.position(), drone.velocity(), COLLIDER);
  }

  /** Whether nothing carries a drone that rests, or something is where it is. */
  boolean unsettles(SimDrone drone) {
    Vec3 place = drone.position();
    return place.z() > 0
        || !arena.room().contains(place, COLLIDER)
        || obstacles.around(place, COLLIDER).isPresent();
  }

  /** Mission pads in the room. */
  List<Card> cards() {
    return cards;
  }

  /** Whether no obstacle stands between two places; the last centimetres do not count. */
  boolean free(Vec3 from, Vec3 to) {
    Vec3 way = to.minus(from);
    double distance = way.norm();
    return obstacles.distance(from, way.normalized(), distance) >= distance - 0.01;
  }

  /** What a drone's distance sensors see: the room, obstacles, other drones. */
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

  /** The distance along a ray to an obstacle or another drone, or {@code limit} [m]. */
  private double nearest(int number, Vec3 origin, Vec3 direction, double limit) {
    double nearest = obstacles.distance(origin, direction, limit);
    for (SimDrone other : drones) {
      if (other.number() != number) {
        nearest = Math.min(nearest, other.distanceAlong(origin, direction));
      }
    }
    return nearest;
  }
}
