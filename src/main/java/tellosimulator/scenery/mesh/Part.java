package tellosimulator.scenery.mesh;

/** A mesh with its material. A renderer draws it with one draw call. */
public record Part(Mesh mesh, Material material) {

  public Part(Mesh mesh, Texture texture, Shading shading) {
    this(mesh, new Material(texture, shading));
  }
}
