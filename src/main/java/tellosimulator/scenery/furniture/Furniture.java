package tellosimulator.scenery.furniture;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.texture.ImageCache;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Shape;

/**
 * Creates the instances of obstacles. The parts of the most recent obstacles are cached, so an
 * obstacle that is unchanged or has only been moved is not built again. Thread-safe.
 */
public final class Furniture {

  /** The values that determine an obstacle's appearance. */
  private record FurnitureKey(Shape shape, ObstacleAppearance appearance) {}

  private final ImageCache images = new ImageCache();
  private FurnitureBuilder builder = new FurnitureBuilder(images, PatternTexture.forCount(0));
  private Map<FurnitureKey, List<Part>> made = new HashMap<>();
  private List<Obstacle> latest = List.of();
  private List<Instance> instances = List.of();

  /**
   * Returns the instances of the obstacles, followed by the shade at their feet. As long as {@code
   * obstacles} is the same object, the same list is returned.
   */
  public synchronized List<Instance> instances(List<Obstacle> obstacles) {
    if (obstacles != latest) {
      make(obstacles);
      latest = obstacles;
      List<Instance> placed = new ArrayList<>();
      obstacles.forEach(obstacle -> placed.addAll(place(obstacle)));
      placed.addAll(FootShade.of(obstacles));
      instances = List.copyOf(placed);
    }
    return instances;
  }

  private void make(List<Obstacle> obstacles) {
    PatternTexture patterns = FurnitureBuilder.patterns(obstacles);
    if (!patterns.equals(builder.patterns())) {
      builder = new FurnitureBuilder(images, patterns);
      made = Map.of();
    }
    Map<FurnitureKey, List<Part>> needed = new HashMap<>();
    for (Obstacle obstacle : obstacles) {
      needed.computeIfAbsent(look(obstacle), this::parts);
    }
    made = needed;
    builder.keep(obstacles);
  }

  private List<Part> parts(FurnitureKey look) {
    List<Part> known = made.get(look);
    return known == null ? builder.parts(look.shape, look.appearance) : known;
  }

  private List<Instance> place(Obstacle obstacle) {
    return made.get(look(obstacle)).stream()
        .map(part -> new Instance(part, obstacle.pose()))
        .toList();
  }

  private static FurnitureKey look(Obstacle obstacle) {
    return new FurnitureKey(obstacle.shape(), obstacle.appearance());
  }
}
