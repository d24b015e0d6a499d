package tellosimulator.scenery.room;

import java.util.List;
import tellosimulator.math.Pose;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Arc;
import tellosimulator.scenery.texture.AlphaMask.Point;

/** The decal on the floor where a drone starts. For any thread. */
public final class StartMark {

  /** Edge of the decal [m]. Decided: the drone covers the ring only in part. */
  private static final double SIZE = 0.42;

  /** Decided: the floor shines through. */
  private static final double OPACITY = 0.8;

  private static final int TEXELS = 256;

  private static final Mesh MESH = MeshBuilder.of(Quad.onFloor(SIZE));

  private final Part part;

  /**
   * @param color of what belongs to the drone
   */
  public StartMark(Rgb color) {
    Texture texture = AlphaMask.texture(TEXELS, color.paler(0.85), StartMark::mask);
    part = new Part(MESH, texture, Shading.DECAL);
  }

  /**
   * The mark at its place.
   *
   * @param start where a reset puts the drone, room frame
   */
  public Instance at(Pose start) {
    return new Instance(part, new Pose(start.position().withZ(0), start.attitude()), 1, OPACITY);
  }

  /** A ring with an arrow upwards and an H, as on a landing place. */
  private static AlphaMask mask() {
    Point center = new Point(128, 152);
    return new AlphaMask(TEXELS)
        .stroke(Arc.circle(center, 88).points(), 12)
        .stroke(Arc.circle(center, 66).points(), 5)
        .fill(List.of(new Point(128, 4), new Point(168, 54), new Point(88, 54)))
        .stroke(List.of(new Point(104, 126), new Point(104, 178)), 14)
        .stroke(List.of(new Point(152, 126), new Point(152, 178)), 14)
        .stroke(List.of(new Point(104, 152), new Point(152, 152)), 14);
  }
}
