/**
 * The drones' video: a camera's pictures, encoded as H.264 and sent to the operator.
 *
 * <p>{@code picture} holds what a picture is, {@code camera} draws what a drone sees, {@code codec}
 * encodes it; this package puts them together, one thread for each drone. It reads snapshots of the
 * simulation and never changes it. The window is not its job.
 */
package tellosimulator.video;
