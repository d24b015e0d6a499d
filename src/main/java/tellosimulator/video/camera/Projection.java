package tellosimulator.video.camera;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Placed;

/**
 * From the frame of a part to the picture. A point becomes x, y and its distance along the camera's
 * axis; x and y divided by the distance are pixels to the right and down from the picture's upper
 * left corner. Used again and again; for one thread.
 */
final class Projection {

  private final double[] turn = new double[9];
  private final double[] view = new double[12];
  private final double[] part = new double[12];

  private int width;
  private int height;
  private double near;
  private double slantAcross;
  private double slantDown;

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  double near() {
    return near;
  }

  /** The three rows of the transform: for x, y and distance of a part's point (x, y, z, 1). */
  double[] rows() {
    return part;
  }

  /** From now on things are seen from here. */
  void aim(Viewpoint viewpoint) {
    Lens lens = viewpoint.lens();
    width = lens.width();
    height = lens.height();
    near = viewpoint.near();
    double focal = lens.focalLength();
    slantAcross = Math.sqrt(focal * focal + width * width / 4.0);
    slantDown = Math.sqrt(focal * focal + height * height / 4.0);
    turn(viewpoint.pose().attitude());
    Vec3 eye = viewpoint.pose().position();
    for (int axis = 0; axis < 3; axis++) {
      double ahead = turn[3 * axis];
      view[axis] = -focal * turn[3 * axis + 1] + width / 2.0 * ahead;
      view[4 + axis] = -focal * turn[3 * axis + 2] + height / 2.0 * ahead;
      view[8 + axis] = ahead;
    }
    for (int row = 0; row < 12; row += 4) {
      view[row + 3] = -(view[row] * eye.x() + view[row + 1] * eye.y() + view[row + 2] * eye.z());
    }
  }

  /** From now on points are those of this part. */
  void place(Placed placed) {
    Pose pose = placed.pose();
    Vec3 at = pose.position();
    turn(pose.attitude());
    for (int row = 0; row < 12; row += 4) {
      double x = view[row];
      double y = view[row + 1];
      double z = view[row + 2];
      for (int axis = 0; axis < 3; axis++) {
        part[row + axis] =
            placed.scale() * (x * turn[axis] + y * turn[3 + axis] + z * turn[6 + axis]);
      }
      part[row + 3] = x * at.x() + y * at.y() + z * at.z() + view[row + 3];
    }
  }

  /**
   * Whether something of a ball may be in the picture.
   *
   * @param middle in the part's frame
   * @param radius in the room's measure [m]
   */
  boolean sees(double[] middle, double radius) {
    double x = row(0, middle);
    double y = row(4, middle);
    double distance = row(8, middle);
    // How far the middle is outside the planes through the eye and the picture's edges.
    double across = Math.max(-x, x - width * distance) / slantAcross;
    double down = Math.max(-y, y - height * distance) / slantDown;
    return distance + radius > near && across < radius && down < radius;
  }

  private double row(int row, double[] point) {
    return part[row] * point[0]
        + part[row + 1] * point[1]
        + part[row + 2] * point[2]
        + part[row + 3];
  }

  /** The matrix of a turn, row by row. */
  private void turn(Attitude attitude) {
    double w = attitude.w();
    double x = attitude.x();
    double y = attitude.y();
    double z = attitude.z();
    turn[0] = 1 - 2 * (y * y + z * z);
    turn[1] = 2 * (x * y - w * z);
    turn[2] = 2 * (x * z + w * y);
    turn[3] = 2 * (x * y + w * z);
    turn[4] = 1 - 2 * (x * x + z * z);
    turn[5] = 2 * (y * z - w * x);
    turn[6] = 2 * (x * z - w * y);
    turn[7] = 2 * (y * z + w * x);
    turn[8] = 1 - 2 * (x * x + y * y);
  }
}
