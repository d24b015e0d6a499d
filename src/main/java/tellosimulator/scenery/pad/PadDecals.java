package tellosimulator.scenery.pad;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;

/** Creates the decals of mission pads, each on first use. Thread-safe. */
public final class PadDecals {

  /** A square in the pad's frame. The x axis points to the upper edge of the texture. */
  private final Mesh mesh = MeshBuilder.of(Quad.onFloor(MissionPad.EDGE));

  private final Map<Integer, Part> decals = new ConcurrentHashMap<>();

  /** Returns the decals of a room's pads. */
  public List<Instance> instances(Room room, List<MissionPad> pads) {
    return pads.stream().map(pad -> new Instance(decal(pad.id()), pad.pose(room))).toList();
  }

  private Part decal(int id) {
    return decals.computeIfAbsent(
        id, number -> new Part(mesh, PadTexture.of(number), Shading.DECAL));
  }
}
