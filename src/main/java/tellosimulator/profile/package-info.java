/**
 * Which drone is simulated, and after which account of it.
 *
 * <p>{@link tellosimulator.profile.Profile} is the product; {@link tellosimulator.profile.Behavior}
 * the account, as a table of values. Both are immutable and for any thread. The package imports
 * {@code math} at the most. Constants that are the same in every profile and behaviour are not its
 * job: they stand in {@code model.DroneSpec}.
 */
package tellosimulator.profile;
