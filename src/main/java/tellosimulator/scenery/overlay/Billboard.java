package tellosimulator.scenery.overlay;

import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;

/**
 * A square picture that faces the camera and is equally large from near and far. Immutable; for any
 * thread.
 */
final class Billboard {

  /** 1 wide and 1 high in the camera's frame, standing on the origin, seen from behind. */
  private static final Mesh STANDING =
      MeshBuilder.of(new Quad(new Vec3(0, 0.5, 0), new Vec3(0, -1, 0), Vec3.UP));

  private final Part part;
  private final double size;

  private Billboard(Mesh mesh, Texture texture, double size) {
    part = new Part(mesh, texture, Shading.TRANSLUCENT);
    this.size = size;
  }

  /**
   * One that stands on its place.
   *
   * @param size of its edge, as a share of the distance from the camera
   */
  static Billboard standing(Texture texture, double size) {
    return new Billboard(STANDING, texture, size);
  }

  /**
   * The picture where a place is seen, but before everything else that is seen there.
   *
   * @param aside how many of its widths it is moved to the right
   * @param distance from the camera, so near that nothing is nearer [m]
   */
  Instance inFront(Vec3 place, Pose camera, int aside, double distance) {
    Vec3 way = place.minus(camera.position());
    double nearer = Math.min(1, distance / way.norm());
    double edge = size * way.norm() * nearer;
    Vec3 right = camera.attitude().toRoom(new Vec3(0, -1, 0));
    Vec3 shown = camera.position().plusScaled(way, nearer).plusScaled(right, 1.1 * aside * edge);
    return new Instance(part, new Pose(shown, camera.attitude()), edge, 1);
  }
}
