package tellosimulator.world;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;

/**
 * Something upright that stands or hangs in the room. Immutable; for any thread.
 *
 * @param name for people and goals, such as {@code table}
 * @param foot middle of its foot, room frame [m]
 * @param heading where its x axis points [rad], counter-clockwise seen from above, 0 along the
 *     room's x
 */
public record Obstacle(
    String name, Shape shape, Vec3 foot, double heading, ObstacleAppearance appearance)
    implements Collidable {

  @Override
  public Phrase phrase() {
    return Phrase.of("the obstacle \"%s\"", label());
  }

  /** Its name, for people. */
  public Phrase label() {
    return Phrase.name(name);
  }

  /** Where its frame is. */
  public Pose pose() {
    return new Pose(foot, Attitude.ofHeading(heading));
  }

  /** Whether a body is in it. For one obstacle; {@link Obstacles} finds those nearby. */
  public boolean intersects(Vec3 position, Collider collider) {
    return Solid.of(this).stream()
        .anyMatch(solid -> solid.penetration(position, position, collider).isPresent());
  }

  /** The same with another name. */
  public Obstacle named(String newName) {
    return new Obstacle(newName, shape, foot, heading, appearance);
  }

  /** The same elsewhere. */
  public Obstacle movedTo(Vec3 newFoot, double newHeading) {
    return new Obstacle(name, shape, newFoot, newHeading, appearance);
  }
}
