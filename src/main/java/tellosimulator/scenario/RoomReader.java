package tellosimulator.scenario;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;
import tellosimulator.world.Wind;

/** Reads the room, its looks, its mission pads and its wind. */
final class RoomReader {

  static final Map<String, Surface> SURFACES =
      Map.of(
          "front", Surface.FRONT_WALL,
          "back", Surface.BACK_WALL,
          "left", Surface.LEFT_WALL,
          "right", Surface.RIGHT_WALL,
          "floor", Surface.FLOOR,
          "ceiling", Surface.CEILING);

  static final Map<String, Surface> PAD_WALLS =
      Map.of(
          "front", Surface.FRONT_WALL,
          "back", Surface.BACK_WALL,
          "left", Surface.LEFT_WALL,
          "right", Surface.RIGHT_WALL);

  static final Map<String, Walls> WALLS = Map.of("plain", Walls.PLAIN, "textured", Walls.TEXTURED);

  private static final double LONGEST_CM = ObstacleReader.LONGEST_CM;
  private static final Value<Double> EDGE = Values.length(Room.SHORTEST * 100, LONGEST_CM);
  private static final Value<Double> OFFSET = Values.length(-LONGEST_CM, LONGEST_CM);

  /** What stands for a room until the mistake is told; everything is in it. */
  private static final Room UNKNOWN = new Room(Room.LONGEST, Room.LONGEST, Room.LONGEST);

  private RoomReader() {}

  static Optional<Room> room(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.ROOM, node, mistakes);
    double width = section.read("width", EDGE, Room.DEFAULT.width());
    double depth = section.read("depth", EDGE, Room.DEFAULT.depth());
    double height = section.read("height", EDGE, Room.DEFAULT.height());
    return Optional.of(section.sound() ? new Room(width, depth, height) : UNKNOWN);
  }

  /** The looks of the room. */
  static Decor decor(Section scenario, List<Poster> posters) {
    return new Decor(
        scenario.read(
            "grid",
            Values.length(Decor.SMALLEST_GRID * 100, Decor.LARGEST_GRID * 100),
            Decor.DEFAULT.grid()),
        scenario.read("walls", Values.word(WALLS), Decor.DEFAULT.walls()),
        posters);
  }

  /**
   * A poster.
   *
   * @param images that its picture names
   */
  static Value<Poster> poster(Pictures images) {
    return (node, mistakes) -> {
      Section section = Section.of(Kind.POSTER, node, mistakes);
      Surface wall = section.need("wall", Values.word(SURFACES), Surface.FRONT_WALL);
      double along = section.read("along", OFFSET, 0.0);
      double height = section.need("height", OFFSET, 1.0);
      double width = section.need("width", Values.length(Poster.NARROWEST * 100, LONGEST_CM), 1.0);
      Optional<String> picture = section.need("picture", images.file());
      return section.sound()
          ? Optional.of(new Poster(wall, along, height, width, picture.orElseThrow()))
          : Optional.empty();
    };
  }

  static Optional<MissionPad> pad(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.PAD, node, mistakes);
    int id = section.need("id", padId(), 1);
    boolean hangs = section.has("wall");
    MissionPad pad = hangs ? hanging(section, id) : lying(section, id);
    return section.sound() ? Optional.of(pad) : Optional.empty();
  }

  private static MissionPad lying(Section section, int id) {
    for (String key : List.of("along", "height", "rotation")) {
      if (section.has(key)) {
        section.mistakes().add(section.at(key), Phrase.of("the key %s goes only with wall", key));
      }
    }
    Vec3 at = section.need("at", ObstacleReader.FLOOR_POINT, Vec3.ZERO);
    return MissionPad.onFloor(id, at, section.read("heading", Values.angle(), 0.0));
  }

  private static MissionPad hanging(Section section, int id) {
    section.exclude("wall", "at", "heading");
    return new MissionPad(
        id,
        section.need("wall", Values.word(PAD_WALLS), Surface.FRONT_WALL),
        section.read("along", OFFSET, 0.0),
        section.need("height", Values.length(0, LONGEST_CM), 1.0),
        section.read("rotation", Values.angle(), 0.0));
  }

  static Value<Integer> padId() {
    return Values.count(Phrase.of("a pad from 1 to %d", MissionPad.LAST_ID), 1, MissionPad.LAST_ID);
  }

  static Optional<Wind> wind(Node node, Mistakes mistakes) {
    Section section = Section.of(Kind.WIND, node, mistakes);
    Value<Double> speed = Values.speed(Wind.FASTEST * 100);
    double towards = section.read("towards", Values.angle(), 0.0);
    double mean = section.read("speed", speed, 0.0);
    double gusts = section.read("gusts", speed, 0.0);
    Vec3 velocity =
        mean == 0
            ? Vec3.ZERO
            : new Vec3(StrictMath.cos(towards) * mean, StrictMath.sin(towards) * mean, 0);
    return Optional.of(new Wind(velocity, gusts));
  }
}
