package tellosimulator.view.fx;

import javafx.scene.shape.TriangleMesh;
import javafx.scene.shape.VertexFormat;
import tellosimulator.scenery.mesh.Mesh;

/** The meshes of a scenery as JavaFX has them. For any thread. */
public final class FxMeshes {

  private FxMeshes() {}

  /** A mesh of the same triangles. */
  public static TriangleMesh of(Mesh mesh) {
    TriangleMesh converted = new TriangleMesh(VertexFormat.POINT_NORMAL_TEXCOORD);
    converted.getPoints().setAll(mesh.positionArray());
    converted.getNormals().setAll(mesh.normalArray());
    converted.getTexCoords().setAll(mesh.texCoordArray());
    converted.getFaces().setAll(mesh.faceArray());
    return converted;
  }
}
