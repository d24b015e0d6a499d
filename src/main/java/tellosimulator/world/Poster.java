package tellosimulator.world;

import java.util.Optional;
import tellosimulator.math.Pose;

/**
 * An image that hangs in the room.
 *
 * @param surface the surface on which the image hangs
 * @param along the distance from the surface's middle to the image's middle [m], to the right as
 *     seen by a viewer in front of the surface. For a viewer of the floor, the front wall is at the
 *     top; for a viewer of the ceiling, the back wall is at the top
 * @param height the height of the image's middle above the floor [m]; on the floor and the ceiling,
 *     the distance from the surface's middle towards the wall at the top
 * @param width the width of the image [m]; the height follows from the aspect ratio of the picture
 * @param picture the image file
 * @param givenName the name that its owner gave it; empty if it is called after its image file
 */
public record Poster(
    Surface surface,
    double along,
    double height,
    double width,
    String picture,
    Optional<String> givenName) {

  /** Minimum width of a poster [m]. Decided: still visible to a camera 10 cm away. */
  public static final double NARROWEST = 0.01;

  /** Creates a poster that is called after its image file. */
  public Poster(Surface surface, double along, double height, double width, String picture) {
    this(surface, along, height, width, picture, Optional.empty());
  }

  public Poster {
    if (!Double.isFinite(along) || !Double.isFinite(height)) {
      throw new IllegalArgumentException(
          "poster is at " + along + ", " + height + " m, but both must be finite");
    }
    if (!(width >= NARROWEST && width <= Room.LONGEST)) {
      throw new IllegalArgumentException(
          "poster is " + width + " m wide, but must be from " + NARROWEST + " to " + Room.LONGEST);
    }
  }

  /**
   * Returns the name by which goals refer to the poster: the given one, or that of the image file
   * without folder and ending.
   */
  public String name() {
    return givenName.orElseGet(
        () -> picture.replaceFirst("^.*[/\\\\]", "").replaceFirst("(?<=.)\\.[^.]*$", ""));
  }

  /** Returns the pose of the poster's middle in a room, with the axes of {@link Surface#pose}. */
  public Pose pose(Room room) {
    return surface.pose(room, along, height);
  }
}
