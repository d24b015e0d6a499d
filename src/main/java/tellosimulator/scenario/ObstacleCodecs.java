package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Notation.Ends;
import tellosimulator.words.Phrase;
import tellosimulator.world.Footprint;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.ObstacleAppearance.Side;
import tellosimulator.world.ObstacleNames;
import tellosimulator.world.Shape;

/** Codecs of boxes, cylinders, walls and gates. */
final class ObstacleCodecs {

  /**
   * An obstacle and how a file writes it.
   *
   * @param obstacle without a name if the file gives it none
   */
  record NotedObstacle(Notation notation, Obstacle obstacle) {

    private Optional<NotedObstacle> of(String kind) {
      return notation.kind().equals(kind) ? Optional.of(this) : Optional.empty();
    }

    private NotedObstacle withEnds(Ends ends) {
      return new NotedObstacle(notation.withEnds(ends, obstacle), obstacle);
    }
  }

  /** The names of obstacles; those without one get one that no other has: {@code box 1}. */
  static List<String> names(List<NotedObstacle> entries) {
    ObstacleNames names = new ObstacleNames();
    for (NotedObstacle entry : entries) {
      names.take(entry.obstacle().name());
    }
    List<String> given = new ArrayList<>();
    for (NotedObstacle entry : entries) {
      String name = entry.obstacle().name();
      given.add(name.isEmpty() ? names.next(entry.notation().kind()) : name);
    }
    return given;
  }

  /** An obstacle of any kind. */
  static Codec<NotedObstacle> obstacle() {
    return new ChoiceCodec<NotedObstacle>("obstacle", Phrase.of("an obstacle"), "One obstacle.")
        .or("box", box(), entry -> entry.of("box"))
        .or("cylinder", cylinder(), entry -> entry.of("cylinder"))
        .or(Notation.WALL, wall(), entry -> entry.of(Notation.WALL))
        .or("gate", gate(), entry -> entry.of("gate"));
  }

  /** Usual thickness of a wall, and of a ring or beams [m]. Decided: wood that one can saw. */
  private static final double WALL_THICKNESS = 0.1;

  private static final double GATE_THICKNESS = 0.05;

  private static final String RING = "ring";
  private static final String FRAME = "frame";
  private static final double SHORTEST_CM = Shape.SHORTEST * 100;
  private static final NumberCodec LENGTH = NumberCodec.length(SHORTEST_CM, Scalars.LONGEST_CM);

  // --- keys that several kinds have ---

  private static final Field<NotedObstacle, String> NAME =
      shared("name", "For people and for goals; without it, one such as \"box 1\".")
          .optional(
              Scalars.LINE,
              entry ->
                  entry.notation().named()
                      ? Optional.of(entry.obstacle().name())
                      : Optional.empty());

  private static final Field<NotedObstacle, Vec3> AT =
      shared(
              "at",
              "Where the middle of its foot is: [x, y] in cm from the room's centre; x along the depth,"
                  + " y to the left.")
          .need(Scalars.FLOOR_POINT, entry -> entry.obstacle().foot());

  private static final Field<NotedObstacle, Double> BASE =
      shared("base", "How high it hangs above the floor in cm.")
          .usual(
              NumberCodec.length(0, Scalars.LONGEST_CM).or(0.0),
              entry -> entry.obstacle().foot().z());

  private static final Field<NotedObstacle, Double> HEADING =
      shared(
              "heading",
              "How it is turned, in degrees counter-clockwise seen from above; 0 looks along x.")
          .usual(NumberCodec.ANGLE.or(0.0), entry -> entry.obstacle().heading());

  private static final Field<NotedObstacle, Integer> COLOR =
      shared("colour", "")
          .usual(
              Scalars.COLOR.or(ObstacleAppearance.DEFAULT.rgb()),
              entry -> entry.obstacle().appearance().rgb());

  private static final Field<NotedObstacle, Pattern> PATTERN =
      shared("pattern", "What is painted on it in two shades of its colour.")
          .usual(
              WordCodec.of(Pattern.values()).or(ObstacleAppearance.DEFAULT.pattern()),
              entry -> entry.obstacle().appearance().pattern());

  private static final Field<NotedObstacle, Map<Side, String>> PICTURES =
      shared("pictures", "")
          .usual(pictures().or(Map.of()), entry -> entry.obstacle().appearance().pictures());

  private ObstacleCodecs() {}

  private static Field.Key<NotedObstacle> shared(String key, String description) {
    return new Field.Key<>(key, description, field -> {});
  }

  private static NotedObstacle standing(Entries in, String kind, Shape shape) {
    return finished(in, kind, new Stand(in.get(AT), in.get(HEADING)), shape);
  }

  /** Where something stands on the floor. */
  private record Stand(Vec3 at, double heading) {}

  private static NotedObstacle finished(Entries in, String kind, Stand stand, Shape shape) {
    Optional<String> name = in.find(NAME);
    ObstacleAppearance appearance =
        new ObstacleAppearance(in.get(COLOR), in.get(PATTERN), in.get(PICTURES));
    Vec3 foot = stand.at().withZ(in.get(BASE));
    return new NotedObstacle(
        new Notation(kind, name.isPresent(), Optional.empty()),
        new Obstacle(name.orElse(""), shape, foot, stand.heading(), appearance));
  }

  /** Image files on the sides of an obstacle. */
  private static Codec<Map<Side, String>> pictures() {
    RecordCodec<Map<Side, String>> codec =
        new RecordCodec<>(
            "pictures",
            Phrase.of("pictures"),
            "Image files that cover whole sides, seen from the folder of this file. The front looks"
                + " along the heading; around a cylinder goes that of the front.");
    Map<Side, Field<Map<Side, String>, String>> sides = new EnumMap<>(Side.class);
    WordCodec<Side> words = WordCodec.of(Side.values());
    for (Side side : Side.values()) {
      sides.put(
          side,
          codec
              .key(words.word(side), "Image file.")
              .optional(Scalars.PICTURE, pictures -> Optional.ofNullable(pictures.get(side))));
    }
    return codec.made(
        in -> {
          Map<Side, String> pictures = new EnumMap<>(Side.class);
          sides.forEach(
              (side, field) -> in.find(field).ifPresent(file -> pictures.put(side, file)));
          return pictures;
        });
  }

  private static Codec<NotedObstacle> box() {
    RecordCodec<NotedObstacle> codec = new RecordCodec<>("box", Phrase.of("a box"), "A box.");
    codec.addAll(NAME, AT, BASE);
    Field<NotedObstacle, Vec3> size =
        codec
            .key("size", "Depth (along its heading), width and height in cm.")
            .need(
                new NumberCodec.Vector(3, LENGTH),
                entry -> Footprint.size(entry.obstacle().shape()));
    codec.addAll(HEADING, COLOR, PATTERN, PICTURES);
    return codec.made(
        in -> {
          Vec3 edges = in.get(size);
          return standing(in, "box", new Shape.Box(edges.x(), edges.y(), edges.z()));
        });
  }

  private static Codec<NotedObstacle> cylinder() {
    RecordCodec<NotedObstacle> codec =
        new RecordCodec<>("cylinder", Phrase.of("a cylinder"), "An upright cylinder.");
    codec.addAll(NAME, AT, BASE);
    Field<NotedObstacle, Double> radius =
        codec.key("radius", "In cm.").need(LENGTH, entry -> entry.obstacle().shape().reach());
    Field<NotedObstacle, Double> height =
        codec.key("height", "In cm.").need(LENGTH, entry -> entry.obstacle().shape().height());
    codec.addAll(HEADING, COLOR, PATTERN, PICTURES);
    return codec.made(
        in -> standing(in, "cylinder", new Shape.Cylinder(in.get(radius), in.get(height))));
  }

  /** A box whose front is at the right of somebody who walks from one end to the other. */
  private static Codec<NotedObstacle> wall() {
    RecordCodec<NotedObstacle> codec =
        new RecordCodec<>(
            Notation.WALL,
            Phrase.of("a wall"),
            "A straight wall. Its front is at the right hand of somebody who walks from one end to"
                + " the other.");
    codec.add(NAME);
    Field<NotedObstacle, Vec3> from =
        codec
            .key("from", "One end: [x, y] in cm.")
            .need(Scalars.FLOOR_POINT, wall -> ends(wall).from());
    Field<NotedObstacle, Vec3> to =
        codec
            .key("to", "The other end: [x, y] in cm.")
            .need(Scalars.FLOOR_POINT, wall -> ends(wall).to());
    codec.add(BASE);
    Field<NotedObstacle, Double> height =
        codec.key("height", "In cm.").need(LENGTH, wall -> wall.obstacle().shape().height());
    Field<NotedObstacle, Double> thickness =
        codec
            .key("thickness", "In cm.")
            .usual(LENGTH.or(WALL_THICKNESS), wall -> Footprint.size(wall.obstacle().shape()).x());
    codec.addAll(COLOR, PATTERN, PICTURES);
    codec.checked(
        in -> {
          double length = length(in.get(from), in.get(to));
          if (length < Shape.SHORTEST) {
            in.diagnostic(to, Phrase.of("expected another place than that of from"));
          } else if (length > Shape.LONGEST) {
            String most = NumberCodec.plain(Scalars.LONGEST_CM);
            in.diagnostic(to, Phrase.of("expected a wall of at most %s cm", most));
          }
        });
    return codec.made(
        in -> {
          Ends ends = new Ends(in.get(from), in.get(to));
          Shape.Box box =
              new Shape.Box(in.get(thickness), length(ends.from(), ends.to()), in.get(height));
          return finished(in, Notation.WALL, between(ends), box).withEnds(ends);
        });
  }

  private static Ends ends(NotedObstacle wall) {
    return wall.notation().ends(wall.obstacle());
  }

  private static double length(Vec3 from, Vec3 to) {
    return exact(to.minus(from).norm());
  }

  private static double exact(double meters) {
    return Frames.meters(NumberCodec.rounded(meters * 100));
  }

  /** Where a wall stands, from its ends. */
  private static Stand between(Ends ends) {
    Vec3 way = ends.to().minus(ends.from());
    double headingDeg =
        NumberCodec.rounded(StrictMath.toDegrees(StrictMath.atan2(-way.x(), way.y())));
    Vec3 middle = ends.from().plusScaled(way, 0.5);
    Vec3 at = new Vec3(exact(middle.x()), exact(middle.y()), 0);
    return new Stand(at, StrictMath.toRadians(headingDeg));
  }

  private static Codec<NotedObstacle> gate() {
    RecordCodec<NotedObstacle> codec =
        new RecordCodec<>(
            "gate", Phrase.of("a gate"), "A gate to fly through, along its heading or against it.");
    codec.addAll(NAME, AT, BASE);
    Field<NotedObstacle, Boolean> isRing =
        codec
            .key("shape", "A ring on a post, or a frame.")
            .need(
                new WordCodec<>(Map.of(RING, true, FRAME, false)), gate -> ring(gate).isPresent());
    Field<NotedObstacle, Double> diameter =
        codec
            .key("diameter", "Of a ring's opening in cm.")
            .optional(
                NumberCodec.length(2 * SHORTEST_CM, Scalars.LONGEST_CM),
                gate -> ring(gate).map(ring -> 2 * ring.radius()));
    Field<NotedObstacle, Double> width =
        codec
            .key("width", "Of a frame's opening in cm.")
            .optional(LENGTH, gate -> frame(gate).map(Shape.Frame::width));
    Field<NotedObstacle, Double> height =
        codec
            .key("height", "Of a frame's opening in cm.")
            .optional(LENGTH, gate -> frame(gate).map(Shape.Frame::opening));
    Field<NotedObstacle, Double> center =
        codec
            .key("centre", "Height of the opening's middle above the foot in cm.")
            .need(LENGTH, gate -> ((Shape.Gate) gate.obstacle().shape()).middle());
    Field<NotedObstacle, Double> thickness =
        codec
            .key("thickness", "Of the ring or the beams in cm.")
            .usual(
                LENGTH.orWritten(GATE_THICKNESS),
                gate ->
                    ring(gate)
                        .map(Shape.Ring::tube)
                        .or(() -> frame(gate).map(Shape.Frame::beam))
                        .orElseThrow());
    codec.addAll(HEADING, COLOR, PATTERN, PICTURES);
    codec.add(Case.of("shape", RING).needs("diameter").excludes("width", "height"));
    codec.add(Case.of("shape", FRAME).needs("width", "height").excludes("diameter"));
    // height of the middle of an opening whose gate stands on the floor [m]
    ToDoubleFunction<Entries> lowest =
        in -> in.get(isRing) ? in.get(diameter) / 2 + in.get(thickness) : in.get(height) / 2;
    codec.checked(
        in -> {
          double leastCm = lowest.applyAsDouble(in) * 100;
          if (NumberCodec.rounded(in.get(center) * 100) < NumberCodec.rounded(leastCm)) {
            in.diagnostic(
                center,
                Phrase.of(
                    "the centre of this opening must be at least %s cm high",
                    NumberCodec.plain(leastCm)));
          }
        });
    return codec.made(
        in -> {
          double middle = Math.max(in.get(center), lowest.applyAsDouble(in));
          Shape.Gate gate =
              in.get(isRing)
                  ? new Shape.Ring(in.get(diameter) / 2, in.get(thickness), middle)
                  : new Shape.Frame(in.get(width), in.get(height), in.get(thickness), middle);
          return standing(in, "gate", gate);
        });
  }

  private static Optional<Shape.Ring> ring(NotedObstacle gate) {
    return gate.obstacle().shape() instanceof Shape.Ring ring
        ? Optional.of(ring)
        : Optional.empty();
  }

  private static Optional<Shape.Frame> frame(NotedObstacle gate) {
    return gate.obstacle().shape() instanceof Shape.Frame frame
        ? Optional.of(frame)
        : Optional.empty();
  }
}
