package tellosimulator.scenery.furniture;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.world.ObstacleAppearance.Side;

/**
 * Builds the surfaces of an obstacle that share a texture. Texture coordinates are given in metres,
 * to the right and up as one sees the surface from outside, and mapped by a {@link TextureMapping}.
 */
final class TexturedMeshBuilder {

  private final TextureMapping mapping;
  private final MeshBuilder mesh = new MeshBuilder();
  private boolean turned;

  TexturedMeshBuilder(TextureMapping mapping) {
    this.mapping = mapping;
  }

  TextureMapping mapping() {
    return mapping;
  }

  /** Turns the texture of what follows by a quarter, or not. */
  void turn(boolean quarter) {
    turned = quarter;
  }

  boolean isEmpty() {
    return mesh.isEmpty();
  }

  /**
   * A vertex.
   *
   * @param right where in the texture it is [m]
   * @param up where in the texture it is [m]
   */
  Vertex vertex(Vec3 position, Vec3 normal, double right, double up) {
    return turned
        ? new Vertex(position, normal, mapping.u(up), mapping.v(right))
        : new Vertex(position, normal, mapping.u(right), mapping.v(up));
  }

  /** For surfaces that are not rectangles. */
  MeshBuilder mesh() {
    return mesh;
  }

  /**
   * Adds a rectangle.
   *
   * @param left where its left edge is in the texture [m]
   * @param low where its lower edge is in the texture [m]
   */
  void quad(Quad quad, double left, double low) {
    Vec3 normal = quad.normal();
    double right = left + quad.right().norm();
    double high = low + quad.up().norm();
    Vec3 above = quad.corner().plus(quad.up());
    mesh.strip(
        List.of(
            vertex(quad.corner(), normal, left, low),
            vertex(quad.corner().plus(quad.right()), normal, right, low)),
        List.of(
            vertex(above, normal, left, high),
            vertex(above.plus(quad.right()), normal, right, high)));
  }

  /** Adds the sides of a box, but for some; the texture goes around the upright ones. */
  void box(Box box, Set<Side> without) {
    double x = box.size.x();
    double y = box.size.y();
    for (Side side : EnumSet.complementOf(copyOf(without))) {
      double left =
          switch (side) {
            case FRONT, TOP, BOTTOM -> 0;
            case LEFT -> y;
            case BACK -> y + x;
            case RIGHT -> y + x + y;
          };
      Quad quad = box.side(side);
      quad(quad, left, quad.corner().z());
    }
  }

  private static EnumSet<Side> copyOf(Set<Side> sides) {
    EnumSet<Side> copy = EnumSet.noneOf(Side.class);
    copy.addAll(sides);
    return copy;
  }

  Part build(Shading shading) {
    return new Part(mesh.build(), mapping.texture(), shading);
  }

  /**
   * An upright box in the frame of an obstacle.
   *
   * @param foot centre of its base [m]
   * @param size its depth (x), width (y) and height (z) [m]
   */
  record Box(Vec3 foot, Vec3 size) {

    /** A side as one sees it from outside; on top the front is up, below it the back. */
    Quad side(Side side) {
      double x = size.x();
      double y = size.y();
      return switch (side) {
        case FRONT -> upright(new Vec3(x / 2, -y / 2, 0), new Vec3(0, y, 0));
        case LEFT -> upright(new Vec3(x / 2, y / 2, 0), new Vec3(-x, 0, 0));
        case BACK -> upright(new Vec3(-x / 2, y / 2, 0), new Vec3(0, -y, 0));
        case RIGHT -> upright(new Vec3(-x / 2, -y / 2, 0), new Vec3(x, 0, 0));
        case TOP -> level(new Vec3(-x / 2, y / 2, size.z()), new Vec3(x, 0, 0));
        case BOTTOM -> level(new Vec3(x / 2, y / 2, 0), new Vec3(-x, 0, 0));
      };
    }

    private Quad upright(Vec3 corner, Vec3 right) {
      return new Quad(foot.plus(corner), right, new Vec3(0, 0, size.z()));
    }

    private Quad level(Vec3 corner, Vec3 up) {
      return new Quad(foot.plus(corner), new Vec3(0, -size.y(), 0), up);
    }
  }
}
