/**
 * Makes an H.264 stream of pictures. {@link tellosimulator.video.codec.VideoEncoder} is its type;
 * the encoder is built on parts of JCodec. It knows neither drones nor sockets, starts no threads
 * and reads no clock.
 */
package tellosimulator.video.codec;
