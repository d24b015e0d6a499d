package tellosimulator.video.camera;

import tellosimulator.math.Pose;

/**
 * From where one looks, and through what.
 *
 * @param pose of the camera in the room frame; it looks along its x axis, and its z axis is up in
 *     the picture
 * @param near nothing nearer is in the picture [m]
 */
public record Viewpoint(Pose pose, Lens lens, double near) {}
