/**
 * The simulator in a browser, for machines without a display: the server draws the room and the
 * drones' video, and the browser shows the pictures. HTTP only, so that it works behind proxies and
 * port forwarding: pictures are a multipart stream of JPEG files, the state is a stream of
 * server-sent events, and actions are POST requests.
 *
 * <p>{@code WebServer} answers requests after {@code Access} has checked them. Each open page is a
 * {@code Viewer} with a camera of its own. Nothing here can slow the simulation: streams read its
 * newest snapshot, and a reader that is too slow is disconnected.
 */
package tellosimulator.web;
