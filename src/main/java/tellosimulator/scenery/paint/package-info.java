/**
 * Draws the pictures that are on things. {@link tellosimulator.scenery.paint.Sketch} draws strokes
 * and surfaces with smooth edges, {@link tellosimulator.scenery.paint.Digit} writes numbers. It
 * stands on nothing but colours and textures, needs neither fonts nor a display, and is for one
 * thread at a time.
 */
package tellosimulator.scenery.paint;
