package tellosimulator.scenery.furniture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Texture;

/** Makes few large parts of many small ones, for those who draw few large ones faster. */
public final class Joined {

  private record Look(Texture texture, Finish finish) {}

  /** Numbers one after the other; grows as they come. */
  private static final class Row {

    private float[] numbers = new float[64];
    private int count;

    void add(float number) {
      if (count == numbers.length) {
        numbers = Arrays.copyOf(numbers, 2 * count);
      }
      numbers[count++] = number;
    }

    void addAll(float[] more) {
      for (float number : more) {
        add(number);
      }
    }

    float[] all() {
      return Arrays.copyOf(numbers, count);
    }
  }

  private final Row points = new Row();
  private final Row normals = new Row();
  private final Row places = new Row();
  private int[] corners = new int[0];

  private Joined() {}

  /** Parts in the room frame, one for each picture and finish; scale and opacity do not count. */
  public static List<Part> parts(List<Placed> placed) {
    Map<Look, List<Placed>> alike = new LinkedHashMap<>();
    for (Placed one : placed) {
      Look look = new Look(one.part().texture(), one.part().finish());
      alike.computeIfAbsent(look, key -> new ArrayList<>()).add(one);
    }
    List<Part> parts = new ArrayList<>();
    alike.forEach((look, all) -> parts.add(new Part(mesh(all), look.texture, look.finish)));
    return parts;
  }

  private static Mesh mesh(List<Placed> all) {
    Joined joined = new Joined();
    joined.corners = new int[all.stream().mapToInt(one -> 9 * one.part().mesh().triangles()).sum()];
    int next = 0;
    for (Placed one : all) {
      next = joined.addCorners(one.part().mesh(), next);
      joined.addVertices(one.part().mesh(), one.pose());
    }
    return new Mesh(joined.points.all(), joined.normals.all(), joined.places.all(), joined.corners);
  }

  /** Adds a mesh's corners, before its vertices are there. */
  private int addCorners(Mesh mesh, int from) {
    int next = from;
    int[] offsets = {points.count / 3, normals.count / 3, places.count / 2};
    for (int corner : mesh.cornerArray()) {
      corners[next] = corner + offsets[next % 3];
      next++;
    }
    return next;
  }

  private void addVertices(Mesh mesh, Pose pose) {
    for (Vec3 point : vectors(mesh.pointArray())) {
      add(points, pose.position().plus(pose.attitude().toRoom(point)));
    }
    for (Vec3 normal : vectors(mesh.normalArray())) {
      add(normals, pose.attitude().toRoom(normal));
    }
    places.addAll(mesh.texCoordArray());
  }

  private static List<Vec3> vectors(float[] numbers) {
    List<Vec3> vectors = new ArrayList<>();
    for (int i = 0; i < numbers.length; i += 3) {
      vectors.add(new Vec3(numbers[i], numbers[i + 1], numbers[i + 2]));
    }
    return vectors;
  }

  private static void add(Row row, Vec3 vector) {
    row.add((float) vector.x());
    row.add((float) vector.y());
    row.add((float) vector.z());
  }
}
