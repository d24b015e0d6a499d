package tellosimulator.scenery.pad;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.room.Quads;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.scenery.room.Quads.Quad;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;

/** Mission pads as one sees them, printed when they are first asked for. For any thread. */
public final class PadCards {

  /** In the pad's frame: the upper edge of the picture is where x points. */
  private static final class Shared {
    static final Mesh CARD = new Quads().add(Quad.onFloor(MissionPad.EDGE), Patch.WHOLE).mesh();
  }

  private final Map<Integer, Part> cards = new ConcurrentHashMap<>();

  /** The pads of a room, room frame; all are decals. */
  public List<Placed> placed(Room room, List<MissionPad> pads) {
    return pads.stream().map(pad -> new Placed(card(pad.id()), pad.pose(room))).toList();
  }

  private Part card(int id) {
    return cards.computeIfAbsent(
        id, number -> new Part(Shared.CARD, PadDesign.texture(number), Finish.DECAL));
  }
}
