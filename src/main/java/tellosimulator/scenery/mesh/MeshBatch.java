package tellosimulator.scenery.mesh;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.math.Vec3;

/**
 * Merges small meshes of the same material into one mesh, so that only one draw call is needed.
 * This is static batching: the merged instances can no longer move.
 */
public final class MeshBatch {

  private final List<Vec3> positions = new ArrayList<>();
  private final List<Vec3> normals = new ArrayList<>();
  private float[] texCoords = {};
  private int[] faces = {};

  private MeshBatch() {}

  /** Returns one part for each material, in the frame of the instances' poses. */
  public static List<Part> of(List<Instance> instances) {
    Map<Material, List<Instance>> byMaterial = new LinkedHashMap<>();
    for (Instance instance : instances) {
      byMaterial
          .computeIfAbsent(instance.part().material(), key -> new ArrayList<>())
          .add(instance);
    }
    List<Part> parts = new ArrayList<>();
    byMaterial.forEach((material, all) -> parts.add(new Part(merged(all), material)));
    return parts;
  }

  private static Mesh merged(List<Instance> instances) {
    MeshBatch batch = new MeshBatch();
    int faceCount = instances.stream().mapToInt(one -> 9 * one.part().mesh().triangles()).sum();
    batch.faces = new int[faceCount];
    int texCoordCount =
        instances.stream().mapToInt(one -> one.part().mesh().texCoordArray().length).sum();
    batch.texCoords = new float[texCoordCount];
    int face = 0;
    int texCoord = 0;
    for (Instance instance : instances) {
      Mesh mesh = instance.part().mesh();
      int[] offsets = {batch.positions.size(), batch.normals.size(), texCoord / 2};
      for (int index : mesh.faceArray()) {
        batch.faces[face] = index + offsets[face % 3];
        face++;
      }
      float[] own = mesh.texCoordArray();
      System.arraycopy(own, 0, batch.texCoords, texCoord, own.length);
      texCoord += own.length;
      batch.addVectors(mesh, instance);
    }
    return new Mesh(
        Mesh.floats(batch.positions), Mesh.floats(batch.normals), batch.texCoords, batch.faces);
  }

  private void addVectors(Mesh mesh, Instance instance) {
    for (int i = 0; i < mesh.positions(); i++) {
      Vec3 scaled = instance.scaled(mesh.position(i));
      positions.add(instance.pose().position().plus(instance.pose().attitude().toRoom(scaled)));
    }
    float[] own = mesh.normalArray();
    for (int i = 0; i < own.length; i += 3) {
      normals.add(instance.pose().attitude().toRoom(new Vec3(own[i], own[i + 1], own[i + 2])));
    }
  }
}
