package tellosimulator.scenario;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.Cover;
import tellosimulator.world.Cover.Pattern;
import tellosimulator.world.Cover.Side;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

/** Reads boxes, cylinders, walls and gates. */
final class ObstacleReader implements Value<ObstacleReader.Entry> {

  /**
   * An obstacle before all have names.
   *
   * @param kind its key in the file
   * @param obstacle without a name if it was given none
   */
  record Entry(String kind, Obstacle obstacle) {}

  static final double LONGEST_CM = Room.LONGEST * 100;
  static final double SHORTEST_CM = Shape.SHORTEST * 100;

  static final Map<String, Pattern> PATTERNS =
      Map.of(
          "plain", Pattern.PLAIN,
          "checks", Pattern.CHECKS,
          "stripes", Pattern.STRIPES,
          "bricks", Pattern.BRICKS);

  static final Map<String, Side> SIDES =
      Map.of(
          "front", Side.FRONT,
          "back", Side.BACK,
          "left", Side.LEFT,
          "right", Side.RIGHT,
          "top", Side.TOP,
          "bottom", Side.BOTTOM);

  private static final Value<Double> LENGTH = Values.length(SHORTEST_CM, LONGEST_CM);
  private static final Value<Double> DIAMETER = Values.length(2 * SHORTEST_CM, LONGEST_CM);
  private static final Value<Double> HEIGHT = Values.length(0, LONGEST_CM);
  private static final Value<List<Double>> SIZE =
      Values.lengths("x, y, z", SHORTEST_CM, LONGEST_CM);
  private static final Value<Double> ANGLE = Values.angle();
  private static final Value<String> NAME = Values.text();
  private static final Value<Integer> COLOUR = Values.colour();
  private static final Value<Pattern> PATTERN = Values.word(PATTERNS);

  /** A place on the floor. */
  static final Value<Vec3> FLOOR_POINT =
      Values.map(
          Values.lengths("x, y", -LONGEST_CM, LONGEST_CM),
          point -> new Vec3(point.get(0), point.get(1), 0));

  /** Thickness of walls, and of a gate's ring or beams [m]. Decided: wood that one can saw. */
  static final double WALL_THICKNESS = 0.1;

  private static final double GATE_THICKNESS = 0.05;

  /** What stands for a shape until the mistake is told. */
  private static final Shape UNKNOWN = new Shape.Box(1, 1, 1);

  private final Pictures images;

  /**
   * @param images that its pictures name
   */
  ObstacleReader(Pictures images) {
    this.images = images;
  }

  @Override
  public Optional<Entry> read(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.OBSTACLE, node, mistakes);
    Optional<String> kind = section.onlyKey();
    if (kind.isEmpty()) {
      return Optional.empty();
    }
    Optional<Obstacle> obstacle = obstacle(kind.get(), section.at(kind.get()), mistakes);
    return obstacle.isPresent()
        ? Optional.of(new Entry(kind.get(), obstacle.get()))
        : Optional.empty();
  }

  private Optional<Obstacle> obstacle(String kind, Node node, Mistakes mistakes) {
    return switch (kind) {
      case "box" -> box(node, mistakes);
      case "cylinder" -> cylinder(node, mistakes);
      case "wall" -> wall(node, mistakes);
      default -> gate(node, mistakes);
    };
  }

  private Optional<Obstacle> box(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.BOX, node, mistakes);
    List<Double> size = section.need("size", SIZE, List.of(1.0, 1.0, 1.0));
    return standing(section, new Shape.Box(size.get(0), size.get(1), size.get(2)));
  }

  private Optional<Obstacle> cylinder(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.CYLINDER, node, mistakes);
    double radius = section.need("radius", LENGTH, 1.0);
    double height = section.need("height", LENGTH, 1.0);
    return standing(section, new Shape.Cylinder(radius, height));
  }

  /** A box whose front is at the right of somebody who walks from one end to the other. */
  private Optional<Obstacle> wall(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.WALL, node, mistakes);
    Vec3 from = section.need("from", FLOOR_POINT, Vec3.ZERO);
    Vec3 to = section.need("to", FLOOR_POINT, new Vec3(1, 0, 0));
    double height = section.need("height", LENGTH, 1.0);
    double thickness = section.read("thickness", LENGTH, WALL_THICKNESS);
    Vec3 way = to.minus(from);
    double length = Frames.metres(Values.rounded(way.norm() * 100));
    if (section.sound() && length < Shape.SHORTEST) {
      mistakes.add(section.at("to"), Phrase.of("expected another place than that of from"));
    }
    if (section.sound() && length > Shape.LONGEST) {
      mistakes.add(
          section.at("to"),
          Phrase.of("expected a wall of at most %s cm", Values.plain(LONGEST_CM)));
    }
    if (!section.sound()) {
      return Optional.empty();
    }
    double headingDeg = Values.rounded(StrictMath.toDegrees(StrictMath.atan2(-way.x(), way.y())));
    Vec3 middle = from.plusScaled(way, 0.5);
    Vec3 foot = new Vec3(exact(middle.x()), exact(middle.y()), section.read("base", HEIGHT, 0.0));
    return finished(
        section, new Shape.Box(thickness, length, height), foot, StrictMath.toRadians(headingDeg));
  }

  private static double exact(double metres) {
    return Frames.metres(Values.rounded(metres * 100));
  }

  private Optional<Obstacle> gate(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.GATE, node, mistakes);
    boolean ring = section.need("shape", Values.word(Map.of("ring", true, "frame", false)), true);
    double thickness = section.read("thickness", LENGTH, GATE_THICKNESS);
    Shape shape = ring ? ring(section, thickness) : frame(section, thickness);
    return standing(section, shape);
  }

  private static Shape ring(Section section, double thickness) {
    section.exclude("ring", "width", "height");
    double radius = section.need("diameter", DIAMETER, 1.0) / 2;
    double centre = centre(section, radius + thickness);
    return section.sound() ? new Shape.Ring(radius, thickness, centre) : UNKNOWN;
  }

  private static Shape frame(Section section, double thickness) {
    section.exclude("frame", "diameter");
    double width = section.need("width", LENGTH, 1.0);
    double height = section.need("height", LENGTH, 1.0);
    double centre = centre(section, height / 2);
    return section.sound() ? new Shape.Frame(width, height, thickness, centre) : UNKNOWN;
  }

  /**
   * Height of the middle of an opening [m].
   *
   * @param least at which the gate stands on the floor
   */
  private static double centre(Section section, double least) {
    double centre = section.need("centre", LENGTH, Room.LONGEST);
    if (section.sound() && Values.rounded(centre * 100) < Values.rounded(least * 100)) {
      section
          .mistakes()
          .add(
              section.at("centre"),
              Phrase.of(
                  "the centre of this opening must be at least %s cm high",
                  Values.plain(least * 100)));
    }
    return Math.max(centre, least);
  }

  private Optional<Obstacle> standing(Section section, Shape shape) {
    Vec3 at = section.need("at", FLOOR_POINT, Vec3.ZERO);
    double heading = section.read("heading", ANGLE, 0.0);
    return finished(section, shape, at.withZ(section.read("base", HEIGHT, 0.0)), heading);
  }

  private Optional<Obstacle> finished(Section section, Shape shape, Vec3 foot, double heading) {
    String name = section.read("name", NAME, "");
    Cover cover =
        new Cover(
            section.read("colour", COLOUR, Cover.DEFAULT.rgb()),
            section.read("pattern", PATTERN, Cover.DEFAULT.pattern()),
            section.read("pictures", this::pictures, Map.of()));
    return section.sound()
        ? Optional.of(new Obstacle(name, shape, foot, heading, cover))
        : Optional.empty();
  }

  private Optional<Map<Side, String>> pictures(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.PICTURES, node, mistakes);
    Map<Side, String> pictures = new EnumMap<>(Side.class);
    SIDES.forEach(
        (key, side) ->
            section.read(key, images.file()).ifPresent(file -> pictures.put(side, file)));
    return Optional.of(pictures);
  }
}
