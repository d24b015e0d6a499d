/**
 * Visual aids that show people where drones are and where they must go: flown paths, plumb lines
 * down to the floor, rings that show headings, drone tags, goals, and contacts. {@link
 * tellosimulator.scenery.overlay.Overlay} creates them for one window. Every renderer of a scene
 * draws them, but drones' cameras do not see them. {@link
 * tellosimulator.scenery.overlay.OverlayColors} also applies to plans and reports. Not thread-safe.
 */
package tellosimulator.scenery.overlay;
