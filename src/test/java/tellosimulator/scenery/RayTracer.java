package tellosimulator.scenery;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;

/**
 * A slow and simple ray tracer for tests, independent of the methods of the renderers. It handles
 * only opaque surfaces and the decals on them.
 */
public final class RayTracer {

  /** Surfaces that are nearer to each other than this are coplanar [m]. */
  private static final double SAME = 1e-4;

  private record Triangle(Instance placed, List<Vec3> places, Vec3 a, Vec3 b, Vec3 c) {}

  private record Hit(double distance, Texture texture, Vec3 place, double opacity, boolean decal) {}

  private final List<Triangle> triangles = new ArrayList<>();

  public RayTracer(Scene scene) {
    for (Instance placed : scene.instances()) {
      Shading shading = placed.part().material().shading();
      if (shading == Shading.UNLIT || shading.coplanar()) {
        addTriangles(placed);
      }
    }
  }

  private void addTriangles(Instance placed) {
    Mesh mesh = placed.part().mesh();
    int[] corners = mesh.faceArray();
    for (int i = 0; i < mesh.triangles(); i++) {
      triangles.add(
          new Triangle(
              placed,
              places(mesh, i),
              point(placed, corners[9 * i]),
              point(placed, corners[9 * i + 3]),
              point(placed, corners[9 * i + 6])));
    }
  }

  private static Vec3 point(Instance placed, int index) {
    Attitude attitude = placed.pose().attitude();
    Vec3 own = placed.scaled(placed.part().mesh().position(index));
    return placed.pose().position().plus(attitude.toRoom(own));
  }

  /** Returns the colour at the end of a ray; black if it hits nothing. */
  public Rgb look(Vec3 from, Vec3 direction) {
    List<Hit> hits = new ArrayList<>();
    double nearest = Double.POSITIVE_INFINITY;
    for (Triangle triangle : triangles) {
      Hit hit = hit(triangle, from, direction);
      if (hit != null) {
        hits.add(hit);
        nearest = hit.decal ? nearest : Math.min(nearest, hit.distance);
      }
    }
    Rgb seen = Rgb.BLACK;
    for (Hit hit : hits) {
      if (Math.abs(hit.distance - nearest) < SAME) {
        seen = seen.towards(color(hit), hit.decal ? hit.opacity * alpha(hit) : 1);
      }
    }
    return seen;
  }

  private static Hit hit(Triangle triangle, Vec3 from, Vec3 direction) {
    Vec3 ab = triangle.b.minus(triangle.a);
    Vec3 ac = triangle.c.minus(triangle.a);
    Vec3 normal = ab.cross(ac);
    double facing = -normal.dot(direction);
    if (facing <= 1e-12) {
      return null; // a back face
    }
    Vec3 away = from.minus(triangle.a);
    double distance = away.dot(normal) / facing;
    Vec3 turned = away.cross(direction);
    double v = ac.dot(turned) / facing;
    double w = -ab.dot(turned) / facing;
    if (distance <= 0 || v < -1e-9 || w < -1e-9 || v + w > 1 + 1e-9) {
      return null;
    }
    Part part = triangle.placed.part();
    return new Hit(
        distance,
        part.material().texture(),
        triangle
            .places
            .get(0)
            .times(1 - v - w)
            .plusScaled(triangle.places.get(1), v)
            .plusScaled(triangle.places.get(2), w),
        triangle.placed.opacity(),
        part.material().shading() == Shading.DECAL);
  }

  /** Returns the texture coordinates of a triangle's corners: u and v of each. */
  private static List<Vec3> places(Mesh mesh, int triangle) {
    int[] corners = mesh.faceArray();
    float[] places = mesh.texCoordArray();
    List<Vec3> found = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      int corner = corners[9 * triangle + 3 * i + 2];
      found.add(new Vec3(places[2 * corner], places[2 * corner + 1], 0));
    }
    return found;
  }

  private static int pixel(Hit hit) {
    Texture texture = hit.texture;
    int x = (int) Math.floor(hit.place.x() * texture.width() + 1e-6);
    int y = (int) Math.floor(hit.place.y() * texture.height() + 1e-6);
    return texture.argb(Math.floorMod(x, texture.width()), Math.floorMod(y, texture.height()));
  }

  private static Rgb color(Hit hit) {
    return Rgb.of(pixel(hit));
  }

  private static double alpha(Hit hit) {
    return (pixel(hit) >>> 24) / 255.0;
  }
}
