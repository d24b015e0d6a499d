/**
 * What stands around the drones.
 *
 * <p>{@link tellosimulator.world.Room} is the box in which they fly and says where a body is
 * stopped. Everything here is immutable and for any thread. The package imports {@code math}. What
 * a collision does to a drone is not its job: that is the controller's.
 */
package tellosimulator.world;
