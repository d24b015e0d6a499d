/** Where people look at the room from: an orbit about a pivot, and the views of the room. */
package tellosimulator.scenery.orbit;
