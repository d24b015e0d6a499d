package tellosimulator.scenery.furniture;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.room.PictureShelf;
import tellosimulator.world.Cover;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/**
 * What obstacles look like, each at its place. It keeps what is made for the latest obstacles, so
 * that those that are the same next time, or only elsewhere, are not made again. For any thread.
 */
public final class Furniture {

  /** All that decides what an obstacle looks like. */
  private record Look(Shape shape, Cover cover) {}

  private final PictureShelf pictures = new PictureShelf();
  private Workshop workshop = new Workshop(pictures, Grit.of(0));
  private Map<Look, List<Part>> made = new HashMap<>();
  private List<Obstacle> latest = List.of();
  private List<Placed> placed = List.of();

  /** The parts of obstacles, each in its obstacle's frame; none is a decal or sheer. */
  public synchronized List<Placed> placed(List<Obstacle> obstacles) {
    if (obstacles != latest) {
      make(obstacles);
      latest = obstacles;
      placed = obstacles.stream().flatMap(obstacle -> place(obstacle).stream()).toList();
    }
    return placed;
  }

  private void make(List<Obstacle> obstacles) {
    List<Cover> covers = obstacles.stream().map(Obstacle::cover).distinct().toList();
    Grit grit = Workshop.grit(covers);
    if (!grit.equals(workshop.grit())) {
      workshop = new Workshop(pictures, grit);
      made = Map.of();
    }
    Map<Look, List<Part>> needed = new HashMap<>();
    for (Obstacle obstacle : obstacles) {
      needed.computeIfAbsent(look(obstacle), this::parts);
    }
    made = needed;
    workshop.keep(covers);
  }

  private List<Part> parts(Look look) {
    List<Part> known = made.get(look);
    return known == null ? workshop.parts(look.shape, look.cover) : known;
  }

  private List<Placed> place(Obstacle obstacle) {
    return made.get(look(obstacle)).stream()
        .map(part -> new Placed(part, obstacle.pose()))
        .toList();
  }

  private static Look look(Obstacle obstacle) {
    return new Look(obstacle.shape(), obstacle.cover());
  }
}
