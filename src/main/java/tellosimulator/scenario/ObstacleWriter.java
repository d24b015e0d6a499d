package tellosimulator.scenario;

import java.nio.file.Path;
import tellosimulator.world.Cover;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/** Writes obstacles. A wall becomes the box that it is. */
final class ObstacleWriter {

  private final Path folder;

  /**
   * @param folder in which the file will be
   */
  ObstacleWriter(Path folder) {
    this.folder = folder;
  }

  Yaml written(Obstacle obstacle) {
    Yaml written =
        Yaml.line()
            .put("name", obstacle.name())
            .put("at", ScenarioWriter.point(obstacle.foot()))
            .put("base", obstacle.foot().z() * 100, 0);
    String kind = shape(written, obstacle.shape());
    written.put("heading", ScenarioWriter.degrees(obstacle.heading()), 0);
    cover(written, obstacle.cover());
    return Yaml.block().put(kind, written);
  }

  /** Returns the kind of obstacle. */
  private static String shape(Yaml written, Shape shape) {
    if (shape instanceof Shape.Box box) {
      written.put("size", Yaml.numbers(box.depth() * 100, box.width() * 100, box.height() * 100));
      return "box";
    }
    if (shape instanceof Shape.Cylinder cylinder) {
      written.put("radius", cylinder.radius() * 100).put("height", cylinder.height() * 100);
      return "cylinder";
    }
    if (shape instanceof Shape.Ring ring) {
      written
          .put("shape", "ring")
          .put("diameter", ring.radius() * 200)
          .put("centre", ring.middle() * 100)
          .put("thickness", ring.tube() * 100);
      return "gate";
    }
    Shape.Frame frame = (Shape.Frame) shape;
    written
        .put("shape", "frame")
        .put("width", frame.width() * 100)
        .put("height", frame.opening() * 100)
        .put("centre", frame.middle() * 100)
        .put("thickness", frame.beam() * 100);
    return "gate";
  }

  private void cover(Yaml written, Cover cover) {
    if (cover.rgb() != Cover.DEFAULT.rgb()) {
      written.put("colour", ScenarioWriter.colour(cover.rgb()));
    }
    written.put(
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
    if (!pictures.isEmpty()) {
      written.put("pictures", pictures);
    }
  }
}
