package tellosimulator.view.world;

import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.overlay.Eye;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.PinholeCamera;

/**
 * The viewpoint from which a window shows the scene. Immutable.
 *
 * @param pose the pose of the camera in the room frame; the camera looks along its x axis
 * @param fieldOfView the angle between two opposite edges of the image [rad]
 * @param vertical whether the field of view is from top to bottom, instead of from left to right
 * @param near the distance of the near plane [m]
 * @param far the distance beyond which objects need not be drawn [m]
 */
record Viewpoint(Pose pose, double fieldOfView, boolean vertical, double near, double far) {

  /**
   * Projects a place onto an image of the given size [px].
   *
   * @return the pixel, from the top left corner; empty if the place is outside the image or not
   *     beyond the near plane
   */
  Optional<Point2D> project(Vec3 place, double width, double height) {
    Vec3 seen = pose.attitude().toBody(place.minus(pose.position()));
    double across = (vertical ? height : width) / 2;
    double focalLength = across / Math.tan(fieldOfView / 2);
    Point2D pixel =
        new Point2D(
            width / 2 - focalLength * seen.y() / seen.x(),
            height / 2 - focalLength * seen.z() / seen.x());
    boolean inImage = new Rectangle2D(0, 0, width, height).contains(pixel);
    return seen.x() > near && inImage ? Optional.of(pixel) : Optional.empty();
  }

  /** Returns the eye for which the visual aids are drawn. */
  Eye eye() {
    return new Eye(pose, near);
  }

  /** Returns a pinhole camera with an image of the given size [pixels]. */
  PinholeCamera pinhole(int width, int height) {
    double across =
        vertical ? 2 * Math.atan(Math.tan(fieldOfView / 2) * width / height) : fieldOfView;
    return new PinholeCamera(pose, new CameraIntrinsics(width, height, across), near);
  }
}
