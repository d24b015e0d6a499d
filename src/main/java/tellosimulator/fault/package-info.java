/**
 * What goes wrong on demand: on the link, and later in drones, sensors and video.
 *
 * <p>{@link tellosimulator.fault.FaultKind} is the table of all faults, {@link
 * tellosimulator.fault.Fault} one that is asked for, written and read in one line by {@link
 * tellosimulator.fault.FaultText}. {@link tellosimulator.fault.FaultSchedule} knows which of them
 * act now, {@link tellosimulator.fault.LinkChannel} does to datagrams what they say. Everything
 * random comes from {@code SeededNoise}, so the same seed gives the same bytes. Records are for any
 * thread, schedule and channels for that of the simulation. The package imports {@code sensor} and
 * what that stands on. Commands, replies and sockets are not its job.
 */
package tellosimulator.fault;
