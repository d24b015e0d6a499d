/**
 * Fault injection for the link, drones, sensors and video.
 *
 * <p>{@link tellosimulator.fault.FaultKind} is the table of all faults. A {@link
 * tellosimulator.fault.Fault} is a fault to inject. {@link tellosimulator.fault.FaultText} parses a
 * fault from one line of text, and formats it as such a line. {@link
 * tellosimulator.fault.FaultSchedule} tracks the active faults, and {@link
 * tellosimulator.fault.LossyChannel} applies them to datagrams. All randomness comes from {@code
 * SeededNoise}, so the same seed gives the same bytes. Records are immutable; schedule and channels
 * are confined to the simulation thread. The package imports {@code sensor} and its dependencies.
 * Commands, replies and sockets belong to other packages.
 */
package tellosimulator.fault;
