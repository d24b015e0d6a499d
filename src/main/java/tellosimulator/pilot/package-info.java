/** Flies drones by the commands of an operator program, for the window and for browsers. */
package tellosimulator.pilot;
