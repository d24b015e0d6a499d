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
 * A square image that faces the camera and has the same apparent size at any distance. Immutable.
 */
final class Billboard {

  /**
   * A square with sides of length 1 in the camera's frame. The middle of its lower edge is at the
   * origin, and it faces the camera.
   */
  private static final Mesh STANDING =
      MeshBuilder.of(new Quad(new Vec3(0, 0.5, 0), new Vec3(0, -1, 0), Vec3.UP));

  private final Part part;
  private final double size;

  private Billboard(Mesh mesh, Texture texture, double size) {
    part = new Part(mesh, texture, Shading.TRANSLUCENT);
    this.size = size;
  }

  /**
   * Creates a billboard whose lower edge is at the place that it marks.
   *
   * @param size side length, as a fraction of the distance from the camera
   */
  static Billboard standing(Texture texture, double size) {
    return new Billboard(STANDING, texture, size);
  }

  /**
   * Returns the billboard at the point of the screen where a place appears, in front of everything
   * else there.
   *
   * @param place point in the room frame that the billboard marks [m]
   * @param aside offset to the right, in widths of the billboard
   * @param distance distance from the camera [m], so small that nothing is nearer
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
