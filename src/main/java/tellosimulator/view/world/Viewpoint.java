package tellosimulator.view.world;

import tellosimulator.math.Pose;
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

  /** A pinhole camera with an image of this size [pixels]. */
  PinholeCamera pinhole(int width, int height) {
    double across =
        vertical ? 2 * Math.atan(Math.tan(fieldOfView / 2) * width / height) : fieldOfView;
    return new PinholeCamera(pose, new CameraIntrinsics(width, height, across), near);
  }
}
