/**
 * A proxy that forwards and records the traffic between operator programs and a real drone.
 *
 * <p>{@link tellosimulator.proxy.DroneProxy} opens the sockets that {@link
 * tellosimulator.proxy.ProxyPlan} describes. On one thread, {@code Relay} forwards each datagram
 * unchanged, and then passes it to the recorder. The package imports {@code recording} and the
 * packages below it. It does not interpret commands, except that it recognizes {@code command} and
 * {@code conn_req}, because their sender receives state and video.
 */
package tellosimulator.proxy;
