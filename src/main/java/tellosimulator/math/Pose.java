package tellosimulator.math;

/**
 * Where something is and how it is turned, in the room frame.
 *
 * @param position metres
 */
public record Pose(Vec3 position, Attitude attitude) {}
