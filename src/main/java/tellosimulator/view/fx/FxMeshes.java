package tellosimulator.view.fx;

import javafx.scene.shape.TriangleMesh;
import javafx.scene.shape.VertexFormat;
import tellosimulator.scenery.mesh.Mesh;

/** Converts meshes of a scene to JavaFX meshes. Thread-safe. */
public final class FxMeshes {

  private FxMeshes() {}

  /** Returns a JavaFX mesh with the same triangles, normals and texture coordinates. */
  public static TriangleMesh of(Mesh mesh) {
    TriangleMesh converted = new TriangleMesh(VertexFormat.POINT_NORMAL_TEXCOORD);
    converted.getPoints().setAll(mesh.positionArray());
    converted.getNormals().setAll(mesh.normalArray());
    converted.getTexCoords().setAll(mesh.texCoordArray());
    converted.getFaces().setAll(mesh.faceArray());
    return converted;
  }
}
