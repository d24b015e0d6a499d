/**
 * The drones' video: pictures from a camera, encoded as H.264 and sent to the operator.
 *
 * <p>{@code picture} contains the picture type, {@code camera} renders what a drone sees, and
 * {@code codec} encodes it. This package connects them, with one thread for each drone. It reads
 * snapshots of the simulation and never changes the simulation. Showing the pictures in the window
 * belongs to another package.
 */
package tellosimulator.video;
