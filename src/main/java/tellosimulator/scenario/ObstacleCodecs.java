package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.SourceForm.Kind;
import tellosimulator.words.Phrase;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.ObstacleAppearance.Side;
import tellosimulator.world.ObstacleNames;
import tellosimulator.world.Shape;

/** Codecs of boxes, cylinders, walls and gates. */
final class ObstacleCodecs {

  /**
   * An obstacle together with its form in a file.
   *
   * @param obstacle the obstacle; its name is empty if the file contains none
   */
  record ParsedObstacle(SourceForm notation, Obstacle obstacle) {}

  /**
   * Returns the names of obstacles. An obstacle without a name gets a unique one such as {@code box
   * 1}.
   */
  static List<String> names(List<ParsedObstacle> entries) {
    ObstacleNames names = new ObstacleNames();
    for (ParsedObstacle entry : entries) {
      names.take(entry.obstacle().name());
    }
    List<String> given = new ArrayList<>();
    for (ParsedObstacle entry : entries) {
      String name = entry.obstacle().name();
      given.add(name.isEmpty() ? names.next(entry.notation().kind().word()) : name);
    }
    return given;
  }

  /** Returns the codec of an obstacle of any kind. */
  static Codec<ParsedObstacle> obstacle() {
    ChoiceCodec<ParsedObstacle> codec =
        new ChoiceCodec<>("obstacle", Phrase.of("an obstacle"), "One obstacle.");
    Field<ParsedObstacle, ?> box = codec.or("box", box());
    Field<ParsedObstacle, ?> cylinder = codec.or("cylinder", cylinder());
    Field<ParsedObstacle, ?> wall = codec.or("wall", wall());
    Field<ParsedObstacle, ?> gate = codec.or("gate", gate());
    return codec.choosing(
        entry ->
            switch (entry.notation().kind()) {
              case BOX -> box;
              case CYLINDER -> cylinder;
              case WALL -> wall;
              case GATE -> gate;
            });
  }

  /** Default thickness of walls [m]. Decided: a partition wall of wood. */
  private static final double WALL_THICKNESS = 0.1;

  /** Default thickness of the rings and beams of gates [m]. Decided: a slat. */
  private static final double GATE_THICKNESS = 0.05;

  private static final String RING = "ring";
  private static final String FRAME = "frame";
  private static final NumberCodec LENGTH = NumberCodec.length(Quantity.SIZE);

  // --- keys shared by several kinds ---

  private static final Field<ParsedObstacle, String> NAME =
      shared("name", "For people and for goals; without it, one such as \"box 1\".")
          .optional(
              Scalars.LINE,
              entry ->
                  entry.notation().named()
                      ? Optional.of(entry.obstacle().name())
                      : Optional.empty());

  private static final Field<ParsedObstacle, Vec3> AT =
      shared(
              "at",
              "Position of the middle of its foot: [x, y] in cm from the room's centre; x along the"
                  + " depth, y to the left.")
          .need(Scalars.FLOOR_POINT, entry -> entry.obstacle().foot());

  private static final Field<ParsedObstacle, Double> BASE =
      shared("base", "Height of its lower end above the floor in cm.")
          .usual(NumberCodec.length(Quantity.HEIGHT).or(0.0), entry -> entry.obstacle().foot().z());

  private static final Field<ParsedObstacle, Double> HEADING =
      shared("heading", "Heading in degrees counter-clockwise, seen from above; 0 faces along x.")
          .usual(NumberCodec.ANGLE.or(0.0), entry -> entry.obstacle().heading());

  private static final Field<ParsedObstacle, Integer> COLOR =
      shared("colour", "")
          .usual(
              Scalars.COLOR.or(ObstacleAppearance.DEFAULT.rgb()),
              entry -> entry.obstacle().appearance().rgb());

  private static final Field<ParsedObstacle, Pattern> PATTERN =
      shared("pattern", "Pattern painted on it.")
          .usual(
              WordCodec.of(Pattern.values()).or(ObstacleAppearance.DEFAULT.pattern()),
              entry -> entry.obstacle().appearance().pattern());

  private static final Field<ParsedObstacle, Map<Side, String>> PICTURES =
      shared("pictures", "")
          .usual(pictures().or(Map.of()), entry -> entry.obstacle().appearance().pictures());

  private ObstacleCodecs() {}

  private static Field.Key<ParsedObstacle> shared(String key, String description) {
    return new Field.Key<>(key, description, field -> {});
  }

  private static ParsedObstacle standing(Entries in, Kind kind, Shape shape) {
    return finished(in, kind, new Stand(in.get(AT), in.get(HEADING)), shape);
  }

  /** The position [m] and heading [rad] of an obstacle, without its height above the floor. */
  private record Stand(Vec3 at, double heading) {}

  private static ParsedObstacle finished(Entries in, Kind kind, Stand stand, Shape shape) {
    Optional<String> name = in.find(NAME);
    ObstacleAppearance appearance =
        new ObstacleAppearance(in.get(COLOR), in.get(PATTERN), in.get(PICTURES));
    Vec3 foot = stand.at().withZ(in.get(BASE));
    return new ParsedObstacle(
        new SourceForm(kind, name.isPresent()),
        new Obstacle(name.orElse(""), shape, foot, stand.heading(), appearance));
  }

  /** Returns the codec for image files on the sides of an obstacle. */
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

  private static Codec<ParsedObstacle> box() {
    RecordCodec<ParsedObstacle> codec = new RecordCodec<>("box", Phrase.of("a box"), "A box.");
    codec.addAll(NAME, AT, BASE);
    Field<ParsedObstacle, Vec3> size =
        codec
            .key("size", "Depth (along its heading), width and height in cm.")
            .need(new NumberCodec.Vector(3, LENGTH), entry -> entry.obstacle().shape().size());
    codec.addAll(HEADING, COLOR, PATTERN, PICTURES);
    return codec.made(
        in -> {
          Vec3 edges = in.get(size);
          return standing(in, Kind.BOX, new Shape.Box(edges.x(), edges.y(), edges.z()));
        });
  }

  private static Codec<ParsedObstacle> cylinder() {
    RecordCodec<ParsedObstacle> codec =
        new RecordCodec<>("cylinder", Phrase.of("a cylinder"), "An upright cylinder.");
    codec.addAll(NAME, AT, BASE);
    Field<ParsedObstacle, Double> radius =
        codec.key("radius", "In cm.").need(LENGTH, entry -> entry.obstacle().shape().reach());
    Field<ParsedObstacle, Double> height =
        codec.key("height", "In cm.").need(LENGTH, entry -> entry.obstacle().shape().height());
    codec.addAll(HEADING, COLOR, PATTERN, PICTURES);
    return codec.made(
        in -> standing(in, Kind.CYLINDER, new Shape.Cylinder(in.get(radius), in.get(height))));
  }

  /**
   * Returns the codec of a wall. A wall is a box. Its front is on the right of a person who looks
   * from the first end to the second.
   */
  private static Codec<ParsedObstacle> wall() {
    RecordCodec<ParsedObstacle> codec =
        new RecordCodec<>(
            "wall",
            Phrase.of("a wall"),
            "A straight wall. Its front is to the right of a person who walks from one end to"
                + " the other.");
    codec.add(NAME);
    Field<ParsedObstacle, Vec3> from =
        codec
            .key("from", "One end: [x, y] in cm.")
            .need(Scalars.FLOOR_POINT, wall -> ends(wall).from());
    Field<ParsedObstacle, Vec3> to =
        codec
            .key("to", "The other end: [x, y] in cm.")
            .need(Scalars.FLOOR_POINT, wall -> ends(wall).to());
    codec.add(BASE);
    Field<ParsedObstacle, Double> height =
        codec.key("height", "In cm.").need(LENGTH, wall -> wall.obstacle().shape().height());
    Field<ParsedObstacle, Double> thickness =
        codec
            .key("thickness", "In cm.")
            .usual(LENGTH.or(WALL_THICKNESS), wall -> wall.obstacle().shape().size().x());
    codec.addAll(COLOR, PATTERN, PICTURES);
    codec.checked(
        in -> {
          double length = length(in.get(from), in.get(to));
          if (length < Shape.SHORTEST) {
            in.misfit(to, Phrase.of("expected another place than that of from"));
          } else if (length > Shape.LONGEST) {
            String most = NumberCodec.plain(Quantity.SIZE.most());
            in.misfit(to, Phrase.of("expected a wall of at most %s cm", most));
          }
        });
    return codec.made(
        in -> {
          Ends ends = new Ends(in.get(from), in.get(to));
          Shape.Box box =
              new Shape.Box(in.get(thickness), length(ends.from(), ends.to()), in.get(height));
          return finished(in, Kind.WALL, between(ends), box);
        });
  }

  /** The ends of a wall, on the floor [m]. */
  private record Ends(Vec3 from, Vec3 to) {}

  /**
   * Returns the ends of a wall, rounded to 10 µm. This restores the ends from which the wall was
   * created, despite the rounding of its heading, length and position.
   */
  private static Ends ends(ParsedObstacle wall) {
    Obstacle obstacle = wall.obstacle();
    double half = ((Shape.Box) obstacle.shape()).width() / 2;
    double heading = obstacle.heading();
    Vec3 along = new Vec3(-StrictMath.sin(heading) * half, StrictMath.cos(heading) * half, 0);
    return new Ends(stepped(obstacle.foot().minus(along)), stepped(obstacle.foot().plus(along)));
  }

  private static Vec3 stepped(Vec3 end) {
    return new Vec3(Math.rint(end.x() * 1e5) / 1e5, Math.rint(end.y() * 1e5) / 1e5, 0);
  }

  private static double length(Vec3 from, Vec3 to) {
    return exact(to.minus(from).norm());
  }

  private static double exact(double meters) {
    return Frames.meters(NumberCodec.rounded(meters * 100));
  }

  /** Returns the position and heading of a wall between two ends. */
  private static Stand between(Ends ends) {
    Vec3 way = ends.to().minus(ends.from());
    double headingDeg =
        NumberCodec.rounded(StrictMath.toDegrees(StrictMath.atan2(-way.x(), way.y())));
    Vec3 middle = ends.from().plusScaled(way, 0.5);
    Vec3 at = new Vec3(exact(middle.x()), exact(middle.y()), 0);
    return new Stand(at, StrictMath.toRadians(headingDeg));
  }

  private static Codec<ParsedObstacle> gate() {
    RecordCodec<ParsedObstacle> codec =
        new RecordCodec<>(
            "gate", Phrase.of("a gate"), "A gate to fly through, along its heading or against it.");
    codec.addAll(NAME, AT, BASE);
    Field<ParsedObstacle, Boolean> isRing =
        codec
            .key("shape", "A ring on a post, or a frame.")
            .need(
                new WordCodec<>(Map.of(RING, true, FRAME, false)), gate -> ring(gate).isPresent());
    Field<ParsedObstacle, Double> diameter =
        codec
            .key("diameter", "Of a ring's opening in cm.")
            .optional(
                NumberCodec.length(Quantity.DIAMETER),
                gate -> ring(gate).map(ring -> 2 * ring.radius()));
    Field<ParsedObstacle, Double> width =
        codec
            .key("width", "Of a frame's opening in cm.")
            .optional(LENGTH, gate -> frame(gate).map(Shape.Frame::width));
    Field<ParsedObstacle, Double> height =
        codec
            .key("height", "Of a frame's opening in cm.")
            .optional(LENGTH, gate -> frame(gate).map(Shape.Frame::opening));
    Field<ParsedObstacle, Double> center =
        codec
            .key("centre", "Height of the opening's middle above the foot in cm.")
            .need(LENGTH, gate -> ((Shape.Gate) gate.obstacle().shape()).middle());
    Field<ParsedObstacle, Double> thickness =
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
    // minimum height of the centre of the opening above the foot of the gate [m]
    ToDoubleFunction<Entries> lowest =
        in -> in.get(isRing) ? in.get(diameter) / 2 + in.get(thickness) : in.get(height) / 2;
    codec.checked(
        in -> {
          double leastCm = lowest.applyAsDouble(in) * 100;
          if (NumberCodec.rounded(in.get(center) * 100) < NumberCodec.rounded(leastCm)) {
            in.misfit(
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
          return standing(in, Kind.GATE, gate);
        });
  }

  private static Optional<Shape.Ring> ring(ParsedObstacle gate) {
    return gate.obstacle().shape() instanceof Shape.Ring ring
        ? Optional.of(ring)
        : Optional.empty();
  }

  private static Optional<Shape.Frame> frame(ParsedObstacle gate) {
    return gate.obstacle().shape() instanceof Shape.Frame frame
        ? Optional.of(frame)
        : Optional.empty();
  }
}
