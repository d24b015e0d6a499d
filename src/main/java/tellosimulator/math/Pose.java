package tellosimulator.math;

/**
 * A position and an attitude in the room frame.
 *
 * @param position the position [m]
 */
public record Pose(Vec3 position, Attitude attitude) {}
