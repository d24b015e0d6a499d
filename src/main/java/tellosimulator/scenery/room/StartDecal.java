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

/** The decal on the floor at a drone's start. Immutable. */
public final class StartDecal {

  /** Side length of the decal [m]. Decided: a drone covers only part of the ring. */
  private static final double SIZE = 0.42;

  /** Opacity of the decal. Decided: the floor shows through. */
  private static final double OPACITY = 0.8;

  private static final int TEXELS = 256;

  private static final Mesh MESH = MeshBuilder.of(Quad.onFloor(SIZE));

  private final Part part;

  /**
   * Creates the decal of a drone's start.
   *
   * @param color colour of the drone's livery
   */
  public StartDecal(Rgb color) {
    Texture texture = AlphaMask.texture(TEXELS, color.paler(0.85), StartDecal::mask);
    part = new Part(MESH, texture, Shading.DECAL);
  }

  /**
   * Returns the decal, positioned at a drone's start.
   *
   * @param start pose of the drone after a reset, in the room frame
   */
  public Instance at(Pose start) {
    return new Instance(part, new Pose(start.position().withZ(0), start.attitude()), 1, OPACITY);
  }

  /** Draws a ring, an arrow that points upwards, and an H as on a helipad. */
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
