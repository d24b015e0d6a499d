package tellosimulator.view.world;

import java.util.List;
import javafx.scene.paint.Material;
import javafx.scene.shape.CullFace;
import javafx.scene.shape.MeshView;
import javafx.scene.shape.TriangleMesh;
import javafx.scene.shape.VertexFormat;
import tellosimulator.math.Vec3;

/** A piece of a path as a thin band in the air. For the JavaFX thread. */
final class TrailBand extends MeshView {

  /** Numbers of a corner in the list of faces: point, normal, texture. */
  private static final int CORNER = 3;

  /** Numbers of what joins two rings: two triangles a side. */
  private static final int JOINT = TrailPath.SIDES * 2 * 3 * CORNER;

  private final TriangleMesh mesh = new TriangleMesh(VertexFormat.POINT_NORMAL_TEXCOORD);

  TrailBand(Material material) {
    mesh.getNormals().setAll(0, 0, 1);
    mesh.getTexCoords().setAll(0, 0);
    setMesh(mesh);
    setMaterial(material);
    setCullFace(CullFace.NONE);
    setVisible(false);
  }

  /**
   * Shows a part of a path.
   *
   * @param first index of its first point
   * @param last index of its last point; nothing is shown if that is not behind the first
   */
  void show(TrailPath path, int first, int last) {
    setVisible(last > first);
    if (last > first) {
      mesh.getFaces().clear(); // or it would name points that are not there any more
      mesh.getPoints().setAll(points(path, first, last));
      mesh.getFaces().setAll(faces(last - first));
    }
  }

  private static float[] points(TrailPath path, int first, int last) {
    float[] points = new float[(last - first + 1) * TrailPath.SIDES * 3];
    int next = 0;
    for (int i = first; i <= last; i++) {
      List<Vec3> ring = path.ring(i);
      for (Vec3 corner : ring) {
        points[next++] = (float) corner.x();
        points[next++] = (float) corner.y();
        points[next++] = (float) corner.z();
      }
    }
    return points;
  }

  private static int[] faces(int joints) {
    int[] faces = new int[joints * JOINT];
    int next = 0;
    for (int i = 0; i < joints; i++) {
      int near = i * TrailPath.SIDES;
      int far = near + TrailPath.SIDES;
      for (int side = 0; side < TrailPath.SIDES; side++) {
        int other = (side + 1) % TrailPath.SIDES;
        int[] corners = {
          near + side, near + other, far + other, near + side, far + other, far + side
        };
        for (int corner : corners) {
          faces[next] = corner; // normal and texture are the only ones
          next += CORNER;
        }
      }
    }
    return faces;
  }
}
