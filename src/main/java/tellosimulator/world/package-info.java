/**
 * What stands around the drones.
 *
 * <p>{@link tellosimulator.world.Arena} is the room with all that is in it: obstacles, mission pads
 * and wind; {@link tellosimulator.world.Room} is the box in which drones fly. They say where a body
 * is stopped and by what. Everything here is immutable and for any thread. The package imports
 * {@code math}, {@code time} and {@code words}. What a collision does to a drone is not its job:
 * that is the controller's.
 */
package tellosimulator.world;
