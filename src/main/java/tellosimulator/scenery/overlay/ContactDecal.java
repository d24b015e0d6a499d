package tellosimulator.scenery.overlay;

import tellosimulator.math.Vec3;

/**
 * The place where a drone touched something or crashed into it. Immutable.
 *
 * @param drone number of the drone
 * @param place position of the drone in the room frame at that moment [m]
 * @param crash whether the drone crashed
 */
public record ContactDecal(int drone, Vec3 place, boolean crash) {}
