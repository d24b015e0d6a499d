/**
 * What the drone's own instruments make of the truth.
 *
 * <p>{@link tellosimulator.sensor.Instruments} turns a {@link tellosimulator.model.DroneState} into
 * {@link tellosimulator.sensor.SensorReadings}; {@link tellosimulator.sensor.SeededNoise} gives
 * random numbers that depend on nothing but seed, drone, purpose and time. All of it is immutable
 * and for any thread. The package imports {@code model}, {@code profile}, {@code time} and {@code
 * math}. How readings are written on the wire is not its job.
 */
package tellosimulator.sensor;
