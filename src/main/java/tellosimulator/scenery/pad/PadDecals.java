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

/** The decals of mission pads, each made when it is first used. For any thread. */
public final class PadDecals {

  /** In the pad's frame: the upper edge of the texture is where x points. */
  private final Mesh mesh = MeshBuilder.of(Quad.onFloor(MissionPad.EDGE));

  private final Map<Integer, Part> decals = new ConcurrentHashMap<>();

  /** The pads of a room. */
  public List<Instance> instances(Room room, List<MissionPad> pads) {
    return pads.stream().map(pad -> new Instance(decal(pad.id()), pad.pose(room))).toList();
  }

  private Part decal(int id) {
    return decals.computeIfAbsent(
        id, number -> new Part(mesh, PadTexture.of(number), Shading.DECAL));
  }
}
