package tellosimulator.view.world;

/** A view of the room that one chooses with a key or in a menu. */
public enum RoomView {
  /** From behind and above, a little from the right. Decided: one sees floor and two walls. */
  START(20, 33),
  /** From the front wall: one sees the noses of drones that look along the room's x. */
  FRONT(180, 14),
  /** From the right wall. */
  SIDE(90, 14),
  /** From above, with the room's x up in the picture, as in the plan. */
  TOP(0, 90),
  /** From behind the drone, with which it turns. */
  CHASE(0, 18);

  private final double heading;
  private final double elevation;

  /**
   * @param headingDeg along which the camera looks, counter-clockwise, 0 along the room's x; of
   *     {@link #CHASE}, from the drone's nose
   * @param elevationDeg how high the camera stands, as an angle
   */
  RoomView(double headingDeg, double elevationDeg) {
    heading = Math.toRadians(headingDeg);
    elevation = Math.toRadians(elevationDeg);
  }

  /** Radians. */
  double heading() {
    return heading;
  }

  /** Radians. */
  double elevation() {
    return elevation;
  }
}
