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
 * From where a window sees the scene. Immutable; for any thread.
 *
 * @param pose of the camera, room frame; it looks along its x axis
 * @param fieldOfView across the image [rad]
 * @param vertical whether the field of view is from top to bottom, or from left to right
 * @param near nearer things are clipped [m]
 * @param far farther things need not be drawn [m]
 */
record Viewpoint(Pose pose, double fieldOfView, boolean vertical, double near, double far) {

  /**
   * Where a place is seen in an image of this size [pixels from its top left corner].
   *
   * @return empty if it is behind the camera or outside of the image
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

  /** For what helps people alone. */
  Eye eye() {
    return new Eye(pose, near);
  }

  /** A pinhole camera with an image of this size [pixels]. */
  PinholeCamera pinhole(int width, int height) {
    double across =
        vertical ? 2 * Math.atan(Math.tan(fieldOfView / 2) * width / height) : fieldOfView;
    return new PinholeCamera(pose, new CameraIntrinsics(width, height, across), near);
  }
}
