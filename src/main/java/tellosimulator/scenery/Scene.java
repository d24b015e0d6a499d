package tellosimulator.scenery;

import java.util.List;

/** What can be seen at a moment. The room comes first, then decals, then what stands in it. */
public record Scene(List<Placed> parts) {

  public Scene {
    parts = List.copyOf(parts);
  }
}
