package tellosimulator.scenery;

import tellosimulator.math.Pose;

/**
 * A part at its place.
 *
 * @param pose room frame
 * @param scale its size, 1 as it is
 * @param opacity from 0 to 1; only of {@link Finish#DECAL}
 */
public record Placed(Part part, Pose pose, double scale, double opacity) {

  public Placed(Part part, Pose pose) {
    this(part, pose, 1, 1);
  }
}
