package tellosimulator.world;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;

/**
 * An upright object that stands or hangs in the room. Immutable.
 *
 * @param name the name by which users and goals refer to the obstacle, such as {@code table}
 * @param foot the middle of the obstacle's foot, in the room frame [m]
 * @param heading the direction of the obstacle's x axis [rad], counter-clockwise seen from above; 0
 *     is along the room's x axis
 */
public record Obstacle(
    String name, Shape shape, Vec3 foot, double heading, ObstacleAppearance appearance)
    implements Collidable {

  @Override
  public Phrase phrase() {
    return Phrase.of("the obstacle \"%s\"", label());
  }

  /** Returns the translatable name of the obstacle. */
  public Phrase label() {
    return Phrase.name(name);
  }

  /** Returns the pose of the obstacle's frame. */
  public Pose pose() {
    return new Pose(foot, Attitude.ofHeading(heading));
  }

  /**
   * Whether a body overlaps this obstacle. To test all obstacles of a room, use {@link Obstacles}.
   *
   * @param position the body's position, in the room frame [m]
   */
  public boolean intersects(Vec3 position, Collider collider) {
    return Solid.of(this).stream()
        .anyMatch(solid -> solid.penetration(position, position, collider).isPresent());
  }

  /** Returns a copy of this obstacle with another name. */
  public Obstacle named(String newName) {
    return new Obstacle(newName, shape, foot, heading, appearance);
  }

  /** Returns a copy of this obstacle at another place. */
  public Obstacle movedTo(Vec3 newFoot, double newHeading) {
    return new Obstacle(name, shape, newFoot, newHeading, appearance);
  }
}
