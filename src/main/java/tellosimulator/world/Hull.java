package tellosimulator.world;

/**
 * The upright cylinder that stands for a body in collisions, its foot at the body's position.
 *
 * @param radius metres
 * @param height metres
 */
public record Hull(double radius, double height) {}
