package tellosimulator.scenery;

import java.util.List;

/**
 * What can be seen at a moment, in the order of drawing: the room, decals, what stands in it, and
 * last what is sheer.
 */
public record Scene(List<Placed> parts) {

  public Scene {
    parts = List.copyOf(parts);
  }
}
