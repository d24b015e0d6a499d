package tellosimulator.scenery.furniture;

import java.util.Set;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.room.Quads.Quad;
import tellosimulator.world.Cover.Side;

/**
 * An upright box in the frame of an obstacle.
 *
 * @param middle of its base [m]
 * @param size its depth (x), width (y) and height (z) [m]
 */
record Plank(Vec3 middle, Vec3 size) {

  /** A side, and how far around the box its left edge is [m]. */
  private record Face(Quad quad, double from) {}

  /** Covers it, but for some sides. */
  void cover(Skin skin, Set<Side> without) {
    for (Side side : Side.values()) {
      if (!without.contains(side)) {
        Face face = face(side);
        skin.quad(face.quad, face.from, face.quad.corner().z());
      }
    }
  }

  /** A side as one sees it from outside; on top the front is up, below it the back. */
  Quad side(Side side) {
    return face(side).quad;
  }

  private Face face(Side side) {
    double x = size.x();
    double y = size.y();
    return switch (side) {
      case FRONT -> upright(new Vec3(x / 2, -y / 2, 0), new Vec3(0, y, 0), 0);
      case LEFT -> upright(new Vec3(x / 2, y / 2, 0), new Vec3(-x, 0, 0), y);
      case BACK -> upright(new Vec3(-x / 2, y / 2, 0), new Vec3(0, -y, 0), y + x);
      case RIGHT -> upright(new Vec3(-x / 2, -y / 2, 0), new Vec3(x, 0, 0), y + x + y);
      case TOP -> level(new Vec3(-x / 2, y / 2, size.z()), new Vec3(x, 0, 0));
      case BOTTOM -> level(new Vec3(x / 2, y / 2, 0), new Vec3(-x, 0, 0));
    };
  }

  private Face upright(Vec3 corner, Vec3 right, double from) {
    return new Face(new Quad(middle.plus(corner), right, new Vec3(0, 0, size.z())), from);
  }

  private Face level(Vec3 corner, Vec3 up) {
    return new Face(new Quad(middle.plus(corner), new Vec3(0, -size.y(), 0), up), 0);
  }
}
