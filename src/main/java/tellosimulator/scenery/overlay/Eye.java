package tellosimulator.scenery.overlay;

import tellosimulator.math.Pose;

/**
 * The viewpoint from which people look at an overlay. Immutable.
 *
 * @param pose pose of the camera in the room frame; the camera looks along its x axis
 * @param nearest distance of the near clipping plane [m]
 */
public record Eye(Pose pose, double nearest) {}
