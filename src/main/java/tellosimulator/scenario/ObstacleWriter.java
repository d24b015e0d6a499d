package tellosimulator.scenario;

import java.nio.file.Path;
import tellosimulator.world.Cover;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/** Writes obstacles. */
final class ObstacleWriter {

  private final Path folder;

  /**
   * @param folder in which the file will be
   */
  ObstacleWriter(Path folder) {
    this.folder = folder;
  }

  Yaml written(Obstacle obstacle, Notation notation) {
    Yaml written = Yaml.line();
    if (notation.named()) {
      written.put("name", obstacle.name());
    }
    if (notation.isWall()) {
      wall(written, obstacle, notation);
    } else {
      standing(written, obstacle);
    }
    cover(written, obstacle.cover());
    return Yaml.block().put(notation.kind(), written);
  }

  private static void wall(Yaml written, Obstacle obstacle, Notation notation) {
    Shape.Box box = (Shape.Box) obstacle.shape();
    Notation.Ends ends = notation.ends(obstacle);
    written
        .put("from", ScenarioWriter.point(ends.from()))
        .put("to", ScenarioWriter.point(ends.to()))
        .put("base", obstacle.foot().z() * 100, 0)
        .put("height", box.height() * 100)
        .put("thickness", box.depth() * 100, ObstacleReader.WALL_THICKNESS * 100);
  }

  private static void standing(Yaml written, Obstacle obstacle) {
    written
        .put("at", ScenarioWriter.point(obstacle.foot()))
        .put("base", obstacle.foot().z() * 100, 0);
    shape(written, obstacle.shape());
    written.put("heading", ScenarioWriter.degrees(obstacle.heading()), 0);
  }

  private static void shape(Yaml written, Shape shape) {
    if (shape instanceof Shape.Box box) {
      written.put("size", Yaml.numbers(box.depth() * 100, box.width() * 100, box.height() * 100));
    } else if (shape instanceof Shape.Cylinder cylinder) {
      written.put("radius", cylinder.radius() * 100).put("height", cylinder.height() * 100);
    } else if (shape instanceof Shape.Ring ring) {
      written
          .put("shape", "ring")
          .put("diameter", ring.radius() * 200)
          .put("centre", ring.middle() * 100)
          .put("thickness", ring.tube() * 100);
    } else {
      Shape.Frame frame = (Shape.Frame) shape;
      written
          .put("shape", "frame")
          .put("width", frame.width() * 100)
          .put("height", frame.opening() * 100)
          .put("centre", frame.middle() * 100)
          .put("thickness", frame.beam() * 100);
    }
  }

  private void cover(Yaml written, Cover cover) {
    written
        .put(
            "colour",
            ScenarioWriter.colour(cover.rgb()),
            ScenarioWriter.colour(Cover.DEFAULT.rgb()))
        .put(
            "pattern",
            ScenarioWriter.key(ObstacleReader.PATTERNS, cover.pattern()),
            ScenarioWriter.key(ObstacleReader.PATTERNS, Cover.DEFAULT.pattern()));
    Yaml pictures = Yaml.line();
    ObstacleReader.SIDES.forEach(
        (key, side) -> {
          if (cover.pictures().containsKey(side)) {
            pictures.put(key, Pictures.from(folder, cover.pictures().get(side)));
          }
        });
    written.put("pictures", Yaml.marked(pictures.node(), pictures.isEmpty()));
  }
}
