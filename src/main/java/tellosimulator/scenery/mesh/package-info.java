/**
 * The values of which scenes are made: {@link tellosimulator.scenery.mesh.Mesh}, {@link
 * tellosimulator.scenery.mesh.Texture}, {@link tellosimulator.scenery.mesh.Material}, {@link
 * tellosimulator.scenery.mesh.Part} and {@link tellosimulator.scenery.mesh.Instance}, in the terms
 * of 3D engines. All are immutable and for any thread. The package imports only {@code math}; what
 * a thing looks like, and drawing it, are not its job.
 */
package tellosimulator.scenery.mesh;
