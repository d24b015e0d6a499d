package tellosimulator.scenery.orbit;

/** A view of the room that is selected by a key or in a menu. */
public enum RoomView {
  /**
   * The view from the back and above, a little from the right. Decided: shows the floor and two
   * walls.
   */
  START(20, 33),
  /** The view from the front wall. Drones that face along the room's x axis show their noses. */
  FRONT(180, 14),
  /** The view from the right wall. */
  SIDE(90, 14),
  /** The view from above, with the room's x axis pointing up, as in the plan. */
  TOP(0, 90),
  /** The view from behind the drone. The camera rotates with the drone. */
  CHASE(0, 18);

  private final double heading;
  private final double elevation;

  /**
   * Creates a view in a direction.
   *
   * @param headingDeg the direction in which the camera looks, counter-clockwise, 0 along the
   *     room's x axis; for {@link #CHASE}, relative to the drone's nose
   * @param elevationDeg the angle of the camera above the horizontal
   */
  RoomView(double headingDeg, double elevationDeg) {
    heading = Math.toRadians(headingDeg);
    elevation = Math.toRadians(elevationDeg);
  }

  /** Returns the direction in which the camera looks [rad]. */
  public double heading() {
    return heading;
  }

  /** Returns the angle of the camera above the horizontal [rad]. */
  public double elevation() {
    return elevation;
  }
}
