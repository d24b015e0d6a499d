package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Notation.Ends;
import tellosimulator.words.Phrase;
import tellosimulator.world.Cover;
import tellosimulator.world.Cover.Pattern;
import tellosimulator.world.Cover.Side;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleNames;
import tellosimulator.world.Shape;

/** Codecs of boxes, cylinders, walls and gates. */
final class ObstacleCodecs {

  /**
   * An obstacle and how a file writes it.
   *
   * @param obstacle without a name if the file gives it none
   */
  record Entry(Notation notation, Obstacle obstacle) {

    private Optional<Entry> of(String kind) {
      return notation.kind().equals(kind) ? Optional.of(this) : Optional.empty();
    }

    private <S extends Shape> S shape(Class<S> type) {
      return type.cast(obstacle.shape());
    }

    private Entry withEnds(Ends ends) {
      return new Entry(notation.withEnds(ends, obstacle), obstacle);
    }
  }

  /** The names of obstacles; those without one get one that no other has: {@code box 1}. */
  static List<String> names(List<Entry> entries) {
    ObstacleNames names = new ObstacleNames();
    for (Entry entry : entries) {
      names.take(entry.obstacle().name());
    }
    List<String> given = new ArrayList<>();
    for (Entry entry : entries) {
      String name = entry.obstacle().name();
      given.add(name.isEmpty() ? names.next(entry.notation().kind()) : name);
    }
    return given;
  }

  /** An obstacle of any kind. */
  static Codec<Entry> obstacle() {
    return new ChoiceCodec<Entry>("obstacle", Phrase.of("an obstacle"), "One obstacle.")
        .or("box", new BoxCodec(), entry -> entry.of("box"))
        .or("cylinder", new CylinderCodec(), entry -> entry.of("cylinder"))
        .or(Notation.WALL, new WallCodec(), entry -> entry.of(Notation.WALL))
        .or("gate", new GateCodec(), entry -> entry.of("gate"));
  }

  private static final double SHORTEST_CM = Shape.SHORTEST * 100;
  private static final NumberCodec LENGTH = NumberCodec.length(SHORTEST_CM, Scalars.LONGEST_CM);

  // --- keys that several kinds have ---

  private static final Field<Entry, String> NAME =
      shared("name", "For people and for goals; without it, one such as \"box 1\".")
          .optional(
              Scalars.LINE,
              entry ->
                  entry.notation().named()
                      ? Optional.of(entry.obstacle().name())
                      : Optional.empty());

  private static final Field<Entry, Vec3> AT =
      shared(
              "at",
              "Where the middle of its foot is: [x, y] in cm from the room's centre; x along the depth,"
                  + " y to the left.")
          .need(Scalars.FLOOR_POINT, entry -> entry.obstacle().foot());

  private static final Field<Entry, Double> BASE =
      shared("base", "How high it hangs above the floor in cm.")
          .usual(
              NumberCodec.length(0, Scalars.LONGEST_CM).or(0.0),
              entry -> entry.obstacle().foot().z());

  private static final Field<Entry, Double> HEADING =
      shared(
              "heading",
              "How it is turned, in degrees counter-clockwise seen from above; 0 looks along x.")
          .usual(NumberCodec.ANGLE.or(0.0), entry -> entry.obstacle().heading());

  private static final Field<Entry, Integer> COLOUR =
      shared("colour", "")
          .usual(Scalars.COLOUR.or(Cover.DEFAULT.rgb()), entry -> entry.obstacle().cover().rgb());

  private static final Field<Entry, Pattern> PATTERN =
      shared("pattern", "What is painted on it in two shades of its colour.")
          .usual(
              Scalars.words(Pattern.values()).or(Cover.DEFAULT.pattern()),
              entry -> entry.obstacle().cover().pattern());

  private static final Field<Entry, Map<Side, String>> PICTURES =
      shared("pictures", "")
          .usual(new PicturesCodec().or(Map.of()), entry -> entry.obstacle().cover().pictures());

  private ObstacleCodecs() {}

  private static Field.Key<Entry> shared(String key, String description) {
    return new Field.Key<>(key, description, field -> {});
  }

  private static Entry standing(Entries in, String kind, Shape shape) {
    return finished(in, kind, new Stand(in.get(AT), in.get(HEADING)), shape);
  }

  /** Where something stands on the floor. */
  private record Stand(Vec3 at, double heading) {}

  private static Entry finished(Entries in, String kind, Stand stand, Shape shape) {
    Optional<String> name = in.find(NAME);
    Cover cover = new Cover(in.get(COLOUR), in.get(PATTERN), in.get(PICTURES));
    Vec3 foot = stand.at().withZ(in.get(BASE));
    return new Entry(
        new Notation(kind, name.isPresent(), Optional.empty()),
        new Obstacle(name.orElse(""), shape, foot, stand.heading(), cover));
  }

  /** Image files on the sides of an obstacle. */
  private static final class PicturesCodec extends RecordCodec<Map<Side, String>> {

    private final Map<Side, Field<Map<Side, String>, String>> sides = new EnumMap<>(Side.class);

    PicturesCodec() {
      super(
          "pictures",
          Phrase.of("pictures"),
          "Image files that cover whole sides, seen from the folder of this file. The front looks"
              + " along the heading; around a cylinder goes that of the front.");
      Scalars.Word<Side> words = Scalars.words(Side.values());
      for (Side side : Side.values()) {
        sides.put(
            side,
            key(words.word(side), "Image file.")
                .optional(Scalars.PICTURE, pictures -> Optional.ofNullable(pictures.get(side))));
      }
    }

    @Override
    Map<Side, String> make(Entries in) {
      Map<Side, String> pictures = new EnumMap<>(Side.class);
      sides.forEach((side, field) -> in.find(field).ifPresent(file -> pictures.put(side, file)));
      return pictures;
    }
  }

  private static final class BoxCodec extends RecordCodec<Entry> {

    private final Field<Entry, Vec3> size;

    BoxCodec() {
      super("box", Phrase.of("a box"), "A box.");
      addAll(NAME, AT, BASE);
      size =
          key("size", "Depth (along its heading), width and height in cm.")
              .need(new Scalars.Vector(3, LENGTH), BoxCodec::size);
      addAll(HEADING, COLOUR, PATTERN, PICTURES);
    }

    private static Vec3 size(Entry entry) {
      Shape.Box box = entry.shape(Shape.Box.class);
      return new Vec3(box.depth(), box.width(), box.height());
    }

    @Override
    Entry make(Entries in) {
      Vec3 edges = in.get(size);
      return standing(in, "box", new Shape.Box(edges.x(), edges.y(), edges.z()));
    }
  }

  private static final class CylinderCodec extends RecordCodec<Entry> {

    private final Field<Entry, Double> radius;
    private final Field<Entry, Double> height;

    CylinderCodec() {
      super("cylinder", Phrase.of("a cylinder"), "An upright cylinder.");
      addAll(NAME, AT, BASE);
      radius = key("radius", "In cm.").need(LENGTH, entry -> cylinder(entry).radius());
      height = key("height", "In cm.").need(LENGTH, entry -> cylinder(entry).height());
      addAll(HEADING, COLOUR, PATTERN, PICTURES);
    }

    private static Shape.Cylinder cylinder(Entry entry) {
      return entry.shape(Shape.Cylinder.class);
    }

    @Override
    Entry make(Entries in) {
      return standing(in, "cylinder", new Shape.Cylinder(in.get(radius), in.get(height)));
    }
  }

  /** A box whose front is at the right of somebody who walks from one end to the other. */
  private static final class WallCodec extends RecordCodec<Entry> {

    /** Usual thickness [m]. Decided: wood that one can saw. */
    private static final double THICKNESS = 0.1;

    private final Field<Entry, Vec3> from;
    private final Field<Entry, Vec3> to;
    private final Field<Entry, Double> height;
    private final Field<Entry, Double> thickness;

    WallCodec() {
      super(
          "wall",
          Phrase.of("a wall"),
          "A straight wall. Its front is at the right hand of somebody who walks from one end to"
              + " the other.");
      add(NAME);
      from =
          key("from", "One end: [x, y] in cm.")
              .need(Scalars.FLOOR_POINT, wall -> ends(wall).from());
      to =
          key("to", "The other end: [x, y] in cm.")
              .need(Scalars.FLOOR_POINT, wall -> ends(wall).to());
      add(BASE);
      height = key("height", "In cm.").need(LENGTH, wall -> box(wall).height());
      thickness = key("thickness", "In cm.").usual(LENGTH.or(THICKNESS), wall -> box(wall).depth());
      addAll(COLOUR, PATTERN, PICTURES);
    }

    private static Ends ends(Entry wall) {
      return wall.notation().ends(wall.obstacle());
    }

    private static Shape.Box box(Entry wall) {
      return wall.shape(Shape.Box.class);
    }

    @Override
    void check(Entries in) {
      double length = length(in);
      if (length < Shape.SHORTEST) {
        in.mistake(to, Phrase.of("expected another place than that of from"));
      } else if (length > Shape.LONGEST) {
        in.mistake(
            to,
            Phrase.of("expected a wall of at most %s cm", NumberCodec.plain(Scalars.LONGEST_CM)));
      }
    }

    private double length(Entries in) {
      return exact(in.get(to).minus(in.get(from)).norm());
    }

    private static double exact(double metres) {
      return Frames.metres(NumberCodec.rounded(metres * 100));
    }

    @Override
    Entry make(Entries in) {
      Ends ends = new Ends(in.get(from), in.get(to));
      Vec3 way = ends.to().minus(ends.from());
      double headingDeg =
          NumberCodec.rounded(StrictMath.toDegrees(StrictMath.atan2(-way.x(), way.y())));
      Vec3 middle = ends.from().plusScaled(way, 0.5);
      Vec3 at = new Vec3(exact(middle.x()), exact(middle.y()), 0);
      Shape.Box box = new Shape.Box(in.get(thickness), length(in), in.get(height));
      return finished(in, Notation.WALL, new Stand(at, StrictMath.toRadians(headingDeg)), box)
          .withEnds(ends);
    }
  }

  private static final class GateCodec extends RecordCodec<Entry> {

    /** Usual thickness of a ring or beams [m]. Decided: wood that one can saw. */
    private static final double THICKNESS = 0.05;

    private static final String RING = "ring";
    private static final String FRAME = "frame";

    private final Field<Entry, Boolean> shape;
    private final Field<Entry, Double> diameter;
    private final Field<Entry, Double> width;
    private final Field<Entry, Double> height;
    private final Field<Entry, Double> centre;
    private final Field<Entry, Double> thickness;

    GateCodec() {
      super("gate", Phrase.of("a gate"), "A gate to fly through, along its heading or against it.");
      addAll(NAME, AT, BASE);
      shape =
          key("shape", "A ring on a post, or a frame.")
              .need(
                  new Scalars.Word<>(Map.of(RING, true, FRAME, false)),
                  gate -> ring(gate).isPresent());
      diameter =
          key("diameter", "Of a ring's opening in cm.")
              .optional(
                  NumberCodec.length(2 * SHORTEST_CM, Scalars.LONGEST_CM),
                  gate -> ring(gate).map(ring -> 2 * ring.radius()));
      width =
          key("width", "Of a frame's opening in cm.")
              .optional(LENGTH, gate -> frame(gate).map(Shape.Frame::width));
      height =
          key("height", "Of a frame's opening in cm.")
              .optional(LENGTH, gate -> frame(gate).map(Shape.Frame::opening));
      centre =
          key("centre", "Height of the opening's middle above the foot in cm.")
              .need(LENGTH, gate -> gate.shape(Shape.Gate.class).middle());
      thickness =
          key("thickness", "Of the ring or the beams in cm.")
              .usual(
                  LENGTH.orWritten(THICKNESS),
                  gate ->
                      ring(gate)
                          .map(Shape.Ring::tube)
                          .or(() -> frame(gate).map(Shape.Frame::beam))
                          .orElseThrow());
      addAll(HEADING, COLOUR, PATTERN, PICTURES);
      add(Case.of("shape", RING).needs("diameter").excludes("width", "height"));
      add(Case.of("shape", FRAME).needs("width", "height").excludes("diameter"));
    }

    private static Optional<Shape.Ring> ring(Entry gate) {
      return gate.obstacle().shape() instanceof Shape.Ring ring
          ? Optional.of(ring)
          : Optional.empty();
    }

    private static Optional<Shape.Frame> frame(Entry gate) {
      return gate.obstacle().shape() instanceof Shape.Frame frame
          ? Optional.of(frame)
          : Optional.empty();
    }

    @Override
    void check(Entries in) {
      double least = lowest(in);
      if (NumberCodec.rounded(in.get(centre) * 100) < NumberCodec.rounded(least * 100)) {
        in.mistake(
            centre,
            Phrase.of(
                "the centre of this opening must be at least %s cm high",
                NumberCodec.plain(least * 100)));
      }
    }

    /** Height of the middle of an opening whose gate stands on the floor [m]. */
    private double lowest(Entries in) {
      return in.get(shape) ? in.get(diameter) / 2 + in.get(thickness) : in.get(height) / 2;
    }

    @Override
    Entry make(Entries in) {
      double middle = Math.max(in.get(centre), lowest(in));
      return standing(
          in,
          "gate",
          in.get(shape)
              ? new Shape.Ring(in.get(diameter) / 2, in.get(thickness), middle)
              : new Shape.Frame(in.get(width), in.get(height), in.get(thickness), middle));
    }
  }
}
