/**
 * Aids that help people to see where drones are and where they shall go: flown paths, lines
 * straight down to the floor, rings that show headings, drone tags, goals, and where a drone
 * touched something. {@link tellosimulator.scenery.overlay.Overlay} makes them for one window;
 * whatever renders a scene renders them too, but no drone's camera sees them. {@link
 * tellosimulator.scenery.overlay.MarkColors} holds for plans and reports as well. For one thread at
 * a time.
 */
package tellosimulator.scenery.overlay;
