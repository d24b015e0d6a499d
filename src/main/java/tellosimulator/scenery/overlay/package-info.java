/**
 * Aids that help people to see where drones are: flown paths, lines straight down to the floor, and
 * number tags. {@link tellosimulator.scenery.overlay.Overlay} makes them for one window; whatever
 * renders a scene renders them too, but no drone's camera sees them. For one thread at a time.
 */
package tellosimulator.scenery.overlay;
