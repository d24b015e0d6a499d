/**
 * The value types that scenes are made of: {@link tellosimulator.scenery.mesh.Mesh}, {@link
 * tellosimulator.scenery.mesh.Texture}, {@link tellosimulator.scenery.mesh.Material}, {@link
 * tellosimulator.scenery.mesh.Part} and {@link tellosimulator.scenery.mesh.Instance}. Their names
 * are those that 3D engines commonly use. All types are immutable. The package imports only {@code
 * math}. It neither designs particular objects nor renders.
 */
package tellosimulator.scenery.mesh;
