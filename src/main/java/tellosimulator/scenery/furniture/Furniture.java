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
 * What obstacles look like, each at its place. It keeps what is made for the latest obstacles, so
 * that those that are the same next time, or only elsewhere, are not made again. For any thread.
 */
public final class Furniture {

  /** All that decides what an obstacle looks like. */
  private record Look(Shape shape, ObstacleAppearance appearance) {}

  private final ImageCache images = new ImageCache();
  private FurnitureBuilder builder = new FurnitureBuilder(images, PatternTexture.forCount(0));
  private Map<Look, List<Part>> made = new HashMap<>();
  private List<Obstacle> latest = List.of();
  private List<Instance> instances = List.of();

  /** The obstacles, and last the shade at their feet. The same list for the same obstacles. */
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
    Map<Look, List<Part>> needed = new HashMap<>();
    for (Obstacle obstacle : obstacles) {
      needed.computeIfAbsent(look(obstacle), this::parts);
    }
    made = needed;
    builder.keep(obstacles);
  }

  private List<Part> parts(Look look) {
    List<Part> known = made.get(look);
    return known == null ? builder.parts(look.shape, look.appearance) : known;
  }

  private List<Instance> place(Obstacle obstacle) {
    return made.get(look(obstacle)).stream()
        .map(part -> new Instance(part, obstacle.pose()))
        .toList();
  }

  private static Look look(Obstacle obstacle) {
    return new Look(obstacle.shape(), obstacle.appearance());
  }
}
