/**
 * The binary protocol of the drone's app. {@link tellosimulator.protocol.app.AppProtocol} is the
 * second {@code DroneProtocol} of a drone, beside the text protocol in {@code command}: it receives
 * {@code Packet}s, whose ids are listed in {@code MessageId}, and gives orders to the controller.
 * {@code Telemetry} and {@code AppLog} send what the drone sends by itself.
 */
package tellosimulator.protocol.app;
