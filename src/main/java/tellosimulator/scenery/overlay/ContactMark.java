package tellosimulator.scenery.overlay;

import tellosimulator.math.Vec3;

/**
 * Where a drone touched something, or crashed into it. Immutable.
 *
 * @param drone its number
 * @param place of the drone then, room frame [m]
 * @param crash whether it crashed
 */
public record ContactMark(int drone, Vec3 place, boolean crash) {}
