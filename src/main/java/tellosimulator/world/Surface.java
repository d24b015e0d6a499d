package tellosimulator.world;

import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;

/** A surface of the room: the floor, the ceiling or a wall. */
public enum Surface implements Collidable {
  FLOOR("floor", Phrase.of("the floor")),
  CEILING("ceiling", Phrase.of("the ceiling")),
  FRONT_WALL("front", Phrase.of("the front wall")),
  BACK_WALL("back", Phrase.of("the back wall")),
  LEFT_WALL("left", Phrase.of("the left wall")),
  RIGHT_WALL("right", Phrase.of("the right wall"));

  /** The rotation from an object on the floor to one on the front wall. */
  private static final Attitude HANGING = new Attitude(Math.sqrt(0.5), 0, -Math.sqrt(0.5), 0);

  /** The rotation from an object on the floor to one on the ceiling. */
  private static final Attitude OVERHEAD = new Attitude(0, 0, 1, 0);

  private final String word;
  private final Phrase phrase;

  Surface(String word, Phrase phrase) {
    this.word = word;
    this.phrase = phrase;
  }

  /**
   * Returns all surfaces by their names in files and on the command line, such as {@code front}.
   */
  public static Map<String, Surface> byWord() {
    return Stream.of(values())
        .collect(Collectors.toUnmodifiableMap(side -> side.word, side -> side));
  }

  @Override
  public Phrase phrase() {
    return phrase;
  }

  /** Whether the surface is a wall. */
  public boolean wall() {
    return this != FLOOR && this != CEILING;
  }

  /**
   * Returns the direction from the room's middle to this wall [rad], counter-clockwise seen from
   * above, 0 along x; 0 also for the floor and the ceiling.
   */
  public double heading() {
    return switch (this) {
      case LEFT_WALL -> Math.PI / 2;
      case BACK_WALL -> Math.PI;
      case RIGHT_WALL -> -Math.PI / 2;
      default -> 0;
    };
  }

  /**
   * Returns the pose of a flat object on the surface, in the room frame. Its z axis points out of
   * the surface, x to the viewer's top, and y to the viewer's left.
   *
   * @param along the distance from the surface's middle to the right, as seen by a viewer in front
   *     of it [m]; the front wall is at the viewer's top for the floor, and at the bottom for the
   *     ceiling
   * @param height the height above the floor [m]; on floor and ceiling, the distance from the
   *     surface's middle towards the viewer's top
   */
  public Pose pose(Room room, double along, double height) {
    return switch (this) {
      case FLOOR -> new Pose(new Vec3(height, -along, 0), Attitude.LEVEL);
      case CEILING -> new Pose(new Vec3(-height, -along, room.height()), OVERHEAD);
      default -> {
        Attitude facing = Attitude.ofHeading(heading());
        Vec3 middle = facing.toRoom(new Vec3(room.distanceTo(this), -along, height));
        yield new Pose(middle, facing.after(HANGING));
      }
    };
  }
}
