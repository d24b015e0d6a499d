package tellosimulator.world;

/**
 * An image that hangs in the room.
 *
 * @param surface on which it hangs
 * @param along from the surface's middle to the image's middle, to the right as one sees it who
 *     looks at it [m]; the front wall is the upper end of the floor and the lower end of the
 *     ceiling
 * @param height of the image's middle above the floor [m]; on floor and ceiling, from the surface's
 *     middle to its upper end
 * @param width of the image [m]; its height follows from the picture
 * @param picture a file
 */
public record Poster(Surface surface, double along, double height, double width, String picture) {

  /** Narrowest poster [m]. Decided: a camera sees it from a hand's breadth. */
  public static final double NARROWEST = 0.01;

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
}
