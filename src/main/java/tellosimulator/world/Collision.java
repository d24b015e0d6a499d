package tellosimulator.world;

import tellosimulator.math.Vec3;

/**
 * A body that was stopped by a surface.
 *
 * @param surface what it touches; of several the one that it hit fastest
 * @param normal unit vector away from the surface
 * @param speed how fast it came [m/s], 0 when it only rests or leans
 * @param position where the body is now, outside every surface [m]
 * @param velocity what is left of its velocity [m/s]
 */
public record Collision(Surface surface, Vec3 normal, double speed, Vec3 position, Vec3 velocity) {}
