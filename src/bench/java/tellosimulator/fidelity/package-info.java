/** Measures how far behaviour {@code measured} is from published flights of real drones. */
package tellosimulator.fidelity;
