package tellosimulator.video.camera;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;

/**
 * The model-view-projection transform including the viewport transform. It converts model
 * coordinates to the homogeneous screen coordinates x, y and w. w is the depth along the camera's
 * axis [m]; x / w and y / w are pixels to the right and down from the upper left corner. Reused.
 * Not thread-safe.
 */
final class ModelViewProjection {

  private final double[] rotation = new double[9];
  private final double[] viewProjection = new double[12];
  private final double[] matrix = new double[12];

  private int width;
  private int height;
  private double near;

  /** Length of the normals of the left and right side planes of the frustum. */
  private double sideNorm;

  private double topNorm;

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  double near() {
    return near;
  }

  /** The matrix, row by row: three rows for x, y and w of a vertex (x, y, z, 1). */
  double[] matrix() {
    return matrix;
  }

  /** Sets view, projection and viewport. */
  void setCamera(PinholeCamera camera) {
    CameraIntrinsics intrinsics = camera.intrinsics();
    width = intrinsics.width();
    height = intrinsics.height();
    near = camera.near();
    double focal = intrinsics.focalLength();
    sideNorm = Math.sqrt(focal * focal + width * width / 4.0);
    topNorm = Math.sqrt(focal * focal + height * height / 4.0);
    setRotation(camera.pose().attitude());
    Vec3 eye = camera.pose().position();
    for (int axis = 0; axis < 3; axis++) {
      double ahead = rotation[3 * axis];
      viewProjection[axis] = -focal * rotation[3 * axis + 1] + width / 2.0 * ahead;
      viewProjection[4 + axis] = -focal * rotation[3 * axis + 2] + height / 2.0 * ahead;
      viewProjection[8 + axis] = ahead;
    }
    for (int row = 0; row < 12; row += 4) {
      viewProjection[row + 3] =
          -(viewProjection[row] * eye.x()
              + viewProjection[row + 1] * eye.y()
              + viewProjection[row + 2] * eye.z());
    }
  }

  /** Sets the model transform. */
  void setModel(Instance instance) {
    Pose pose = instance.pose();
    Vec3 scale = instance.scale();
    Vec3 at = pose.position();
    setRotation(pose.attitude());
    for (int row = 0; row < 12; row += 4) {
      double x = viewProjection[row];
      double y = viewProjection[row + 1];
      double z = viewProjection[row + 2];
      matrix[row] = scale.x() * (x * rotation[0] + y * rotation[3] + z * rotation[6]);
      matrix[row + 1] = scale.y() * (x * rotation[1] + y * rotation[4] + z * rotation[7]);
      matrix[row + 2] = scale.z() * (x * rotation[2] + y * rotation[5] + z * rotation[8]);
      matrix[row + 3] = x * at.x() + y * at.y() + z * at.z() + viewProjection[row + 3];
    }
  }

  /**
   * Frustum culling: returns whether a bounding sphere may be visible.
   *
   * @param center the centre, in model coordinates
   * @param radius the radius in the room [m]
   */
  boolean intersectsFrustum(double[] center, double radius) {
    double x = row(0, center);
    double y = row(4, center);
    double w = row(8, center);
    // Distances by which the centre is outside the side planes.
    double aside = Math.max(-x, x - width * w) / sideNorm;
    double above = Math.max(-y, y - height * w) / topNorm;
    return w + radius > near && aside < radius && above < radius;
  }

  private double row(int row, double[] position) {
    return matrix[row] * position[0]
        + matrix[row + 1] * position[1]
        + matrix[row + 2] * position[2]
        + matrix[row + 3];
  }

  /** Sets the rotation matrix for an attitude, row by row. */
  private void setRotation(Attitude attitude) {
    double w = attitude.w();
    double x = attitude.x();
    double y = attitude.y();
    double z = attitude.z();
    rotation[0] = 1 - 2 * (y * y + z * z);
    rotation[1] = 2 * (x * y - w * z);
    rotation[2] = 2 * (x * z + w * y);
    rotation[3] = 2 * (x * y + w * z);
    rotation[4] = 1 - 2 * (x * x + z * z);
    rotation[5] = 2 * (y * z - w * x);
    rotation[6] = 2 * (x * z - w * y);
    rotation[7] = 2 * (y * z + w * x);
    rotation[8] = 1 - 2 * (x * x + y * y);
  }
}
