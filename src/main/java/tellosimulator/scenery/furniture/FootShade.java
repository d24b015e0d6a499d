package tellosimulator.scenery.furniture;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.furniture.TexturedMeshBuilder.Box;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.Falloff;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance.Side;
import tellosimulator.world.Shape;

/**
 * The ambient occlusion on the sides of boxes and cylinders that stand on the floor: bands of shade
 * around their feet, all in one mesh. Obstacles with pictures have no shade, because programs
 * process the pictures.
 */
final class FootShade {

  /** Maximum height of the shade [m]. Decided: by eye. */
  private static final double REACH = 0.45;

  /** Maximum height of the shade, as a fraction of the obstacle's height. */
  private static final double LARGEST_PART = 0.6;

  /**
   * Gap between a side and its band, to prevent flicker [m]. Decided: enough at a distance of 10 m.
   */
  private static final double OFFSET = 0.002;

  /** Opacity at the floor. Decided: by eye. */
  private static final double DARKEST = 0.4;

  /** An obstacle whose foot is not higher than this stands on the floor [m]. Decided. */
  private static final double STANDING = 0.01;

  private static final int SIDES = 32;

  private static final Texture TEXTURE = Falloff.texture(Rgb.BLACK, DARKEST);

  private final MeshBuilder mesh = new MeshBuilder();

  private FootShade() {}

  /**
   * Returns the shade of these obstacles, in the room frame. The list is empty if none of the
   * obstacles has any shade.
   */
  static List<Instance> of(List<Obstacle> obstacles) {
    FootShade shade = new FootShade();
    for (Obstacle obstacle : obstacles) {
      if (obstacle.foot().z() < STANDING && obstacle.appearance().pictures().isEmpty()) {
        shade.add(obstacle.shape(), obstacle.pose());
      }
    }
    return shade.mesh.isEmpty()
        ? List.of()
        : List.of(Instance.atOrigin(new Part(shade.mesh.build(), TEXTURE, Shading.TRANSLUCENT)));
  }

  private void add(Shape shape, Pose pose) {
    double high = Math.min(REACH, LARGEST_PART * shape.height());
    shape
        .match(
            new Shape.Cases<Runnable>(
                box -> () -> addSides(box.size(), pose, high),
                cylinder -> () -> addTube(pose.position(), cylinder.radius() + OFFSET, high),
                ring -> () -> {}, // gates are too thin
                frame -> () -> {}))
        .run();
  }

  private void addSides(Vec3 box, Pose pose, double high) {
    Vec3 size = new Vec3(box.x() + 2 * OFFSET, box.y() + 2 * OFFSET, high);
    for (Side side : List.of(Side.FRONT, Side.LEFT, Side.BACK, Side.RIGHT)) {
      Quad quad = new Box(Vec3.ZERO, size).side(side);
      Vec3 corner = pose.position().plus(pose.attitude().toRoom(quad.corner()));
      mesh.quad(new Quad(corner, pose.attitude().toRoom(quad.right()), quad.up()), Falloff.REGION);
    }
  }

  private void addTube(Vec3 foot, double radius, double high) {
    List<Vertex> lower = new ArrayList<>();
    List<Vertex> upper = new ArrayList<>();
    double bottom = Falloff.REGION.top() + Falloff.REGION.height();
    for (int i = 0; i <= SIDES; i++) {
      double angle = 2 * Math.PI * i / SIDES;
      Vec3 out = new Vec3(StrictMath.cos(angle), StrictMath.sin(angle), 0);
      Vec3 low = foot.plusScaled(out, radius);
      lower.add(new Vertex(low, out, 0.5, bottom));
      upper.add(new Vertex(low.plusScaled(Vec3.UP, high), out, 0.5, Falloff.REGION.top()));
    }
    mesh.strip(lower, upper);
  }
}
