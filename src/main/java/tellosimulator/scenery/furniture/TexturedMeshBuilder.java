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
 * to the right and upwards as seen from outside; a {@link TextureMapping} converts them.
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

  /** Sets whether the texture of all subsequent surfaces is rotated by a quarter turn. */
  void turn(boolean quarter) {
    turned = quarter;
  }

  boolean isEmpty() {
    return mesh.isEmpty();
  }

  /**
   * Creates a vertex.
   *
   * @param right horizontal position in the texture [m]
   * @param up vertical position in the texture [m]
   */
  Vertex vertex(Vec3 position, Vec3 normal, double right, double up) {
    return turned
        ? new Vertex(position, normal, mapping.u(up), mapping.v(right))
        : new Vertex(position, normal, mapping.u(right), mapping.v(up));
  }

  /** Returns the underlying builder, for surfaces that are not rectangles. */
  MeshBuilder mesh() {
    return mesh;
  }

  /**
   * Adds a rectangle.
   *
   * @param left position of the rectangle's left edge in the texture [m]
   * @param low position of the rectangle's lower edge in the texture [m]
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

  /**
   * Adds all sides of a box except the given ones. The texture continues around the upright sides.
   */
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

    /**
     * Returns a side as seen from outside. On the top side, the front is up; on the bottom side,
     * the back is up.
     */
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
