package tellosimulator.scenery.overlay;

import tellosimulator.math.Pose;

/**
 * From where people look at an overlay. Immutable.
 *
 * @param pose of the camera, room frame; it looks along its x axis
 * @param nearest nearer things are clipped [m]
 */
public record Eye(Pose pose, double nearest) {}
