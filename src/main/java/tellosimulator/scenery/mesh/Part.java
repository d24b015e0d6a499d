package tellosimulator.scenery.mesh;

/** A mesh with its material: what one draw call draws. */
public record Part(Mesh mesh, Material material) {

  public Part(Mesh mesh, Texture texture, Shading shading) {
    this(mesh, new Material(texture, shading));
  }
}
