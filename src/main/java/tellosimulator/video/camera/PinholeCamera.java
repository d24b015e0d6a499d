package tellosimulator.video.camera;

import tellosimulator.math.Pose;

/**
 * A pinhole camera: its pose (extrinsics), intrinsics and near plane.
 *
 * @param pose of the camera in the room frame; it looks along its x axis, and its z axis is up in
 *     the image
 * @param near distance of the near plane, before which everything is clipped [m]
 */
public record PinholeCamera(Pose pose, CameraIntrinsics intrinsics, double near) {}
