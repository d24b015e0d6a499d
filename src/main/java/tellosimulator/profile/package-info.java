/**
 * The simulated product and the reference model that it follows.
 *
 * <p>{@link tellosimulator.profile.Profile} is the product. {@link tellosimulator.profile.Behavior}
 * is the reference model, as a table of values. Both are immutable. The package imports only {@code
 * math}. Constants that are the same in every profile and behaviour belong in {@code
 * model.DroneSpec} instead.
 */
package tellosimulator.profile;
