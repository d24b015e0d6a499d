package tellosimulator.video.camera;

import tellosimulator.math.Pose;

/**
 * A pinhole camera: its pose (extrinsics), intrinsics and near plane.
 *
 * @param pose the camera's pose in the room frame; the camera faces along its x axis, and its z
 *     axis points up in the image
 * @param near distance of the near plane [m]; everything nearer is clipped
 */
public record PinholeCamera(Pose pose, CameraIntrinsics intrinsics, double near) {}
