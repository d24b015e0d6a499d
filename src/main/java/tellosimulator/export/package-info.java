/** Recordings in the formats of other tools. */
package tellosimulator.export;
