/**
 * The instruments of a drone. They turn its true state into readings.
 *
 * <p>{@link tellosimulator.sensor.Instruments} turns a {@link tellosimulator.model.DroneState} into
 * {@link tellosimulator.sensor.SensorReadings}. {@link tellosimulator.sensor.SeededNoise} provides
 * random numbers that depend only on seed, drone, purpose and index. All types are immutable. The
 * package imports {@code model}, {@code profile}, {@code time} and {@code math}. Another package
 * defines the format of readings on the wire.
 */
package tellosimulator.sensor;
