/**
 * Stands between operator programs and a real drone, and records what passes.
 *
 * <p>{@link tellosimulator.proxy.DroneProxy} opens the sockets that {@link
 * tellosimulator.proxy.ProxyPlan} asks for; {@code Relay} passes each datagram on unchanged, on one
 * thread, and tells the recorder afterwards. The package imports {@code recording} and what that
 * stands on. What commands mean is not its job: it knows {@code command} alone, whose sender gets
 * state and video.
 */
package tellosimulator.proxy;
