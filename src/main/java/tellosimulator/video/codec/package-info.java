/**
 * An H.264 encoder (Constrained Baseline, CAVLC). {@link tellosimulator.video.codec.VideoEncoder}
 * is the interface, and {@link tellosimulator.video.codec.H264Encoder} is the implementation.
 * Parameter sets and VLC tables come from JCodec. The terms are those of the standard (ITU-T H.264)
 * and of x264; {@code docs/glossary.md} lists them. The package does not depend on drones or
 * sockets, starts no threads and reads no clock.
 */
package tellosimulator.video.codec;
