/**
 * The surroundings of the drones.
 *
 * <p>{@link tellosimulator.world.Arena} is the room with its contents: obstacles, mission pads and
 * wind. {@link tellosimulator.world.Room} is the box in which drones fly. The room and {@link
 * tellosimulator.world.Obstacles} determine where a body is stopped, and by which object. All
 * public types are immutable except {@link tellosimulator.world.ObstacleNames}. The package imports
 * {@code math}, {@code time} and {@code words}. The {@code controller} determines the effect of a
 * collision on a drone.
 */
package tellosimulator.world;
