package tellosimulator.scenario;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Wind;

/** Codecs of the room, its posters, its mission pads and its wind. */
final class RoomCodecs {

  private static final Map<String, Surface> WALLS =
      Map.of(
          "front", Surface.FRONT_WALL,
          "back", Surface.BACK_WALL,
          "left", Surface.LEFT_WALL,
          "right", Surface.RIGHT_WALL);

  private RoomCodecs() {}

  private static Map<String, Surface> surfaces() {
    Map<String, Surface> surfaces = new HashMap<>(WALLS);
    surfaces.put("floor", Surface.FLOOR);
    surfaces.put("ceiling", Surface.CEILING);
    return surfaces;
  }

  /** The room. */
  static final class RoomCodec extends RecordCodec<Room> {

    private static final NumberCodec EDGE =
        NumberCodec.length(Room.SHORTEST * 100, Scalars.LONGEST_CM);

    private final Field<Room, Double> width =
        key("width", "Along y.").usual(EDGE.orWritten(Room.DEFAULT.width()), Room::width);
    private final Field<Room, Double> depth =
        key("depth", "Along x.").usual(EDGE.orWritten(Room.DEFAULT.depth()), Room::depth);
    private final Field<Room, Double> height =
        key("height", "Along z.").usual(EDGE.orWritten(Room.DEFAULT.height()), Room::height);

    RoomCodec() {
      super("room", Phrase.of("a room"), "Size of the room in cm. Its floor's centre is [0, 0].");
    }

    @Override
    Room make(Entries in) {
      return new Room(in.get(width), in.get(depth), in.get(height));
    }
  }

  /** A poster. */
  static final class PosterCodec extends RecordCodec<Poster> {

    private final Field<Poster, Surface> wall =
        key("wall", "Where it hangs.").need(new Scalars.Word<>(surfaces()), Poster::surface);
    private final Field<Poster, Double> along =
        key(
                "along",
                "From the middle of the wall to that of the image, to the right as one looks"
                    + " at it, in cm.")
            .usual(Scalars.OFFSET.orWritten(0.0), Poster::along);
    private final Field<Poster, Double> height =
        key(
                "height",
                "From the floor to the middle of the image in cm; on floor and ceiling, from their"
                    + " middle upwards.")
            .need(Scalars.OFFSET, Poster::height);
    private final Field<Poster, Double> width =
        key("width", "Width of the image in cm; its height follows.")
            .need(NumberCodec.length(Poster.NARROWEST * 100, Scalars.LONGEST_CM), Poster::width);
    private final Field<Poster, String> picture =
        key("picture", "Image file (PNG, JPEG, GIF or BMP), seen from the folder of this file.")
            .need(Scalars.PICTURE, Poster::picture);

    PosterCodec() {
      super("poster", Phrase.of("a poster"), "An image on a wall, the floor or the ceiling.");
    }

    @Override
    Poster make(Entries in) {
      return new Poster(
          in.get(wall), in.get(along), in.get(height), in.get(width), in.get(picture));
    }
  }

  /** The number of a mission pad. */
  static final Codec<Integer> PAD_ID =
      Scalars.count(Phrase.of("a pad from 1 to %d", MissionPad.LAST_ID), 1, MissionPad.LAST_ID);

  /** A mission pad, which lies on the floor or hangs on a wall. */
  static final class PadCodec extends RecordCodec<MissionPad> {

    private final Field<MissionPad, Integer> id =
        key("id", "The number that is printed on it.").need(PAD_ID, MissionPad::id);
    private final Field<MissionPad, Vec3> at =
        key("at", "On the floor: where its middle is, [x, y] in cm.")
            .optional(
                Scalars.FLOOR_POINT,
                pad -> lying(pad).map(lying -> lying.pose(Room.DEFAULT).position()));
    private final Field<MissionPad, Double> heading =
        key(
                "heading",
                "On the floor: where its rocket points, in degrees counter-clockwise; 0 is"
                    + " along x.")
            .optional(NumberCodec.ANGLE.or(0.0), pad -> lying(pad).map(MissionPad::rotation));
    private final Field<MissionPad, Surface> wall =
        key("wall", "On which wall it hangs.")
            .optional(new Scalars.Word<>(WALLS), pad -> hanging(pad).map(MissionPad::surface));
    private final Field<MissionPad, Double> along =
        key(
                "along",
                "On a wall: from its middle to that of the pad, to the right as one looks at"
                    + " it, in cm.")
            .optional(Scalars.OFFSET.orWritten(0.0), pad -> hanging(pad).map(MissionPad::along));
    private final Field<MissionPad, Double> height =
        key("height", "On a wall: of the pad's middle above the floor in cm.")
            .optional(
                NumberCodec.length(0, Scalars.LONGEST_CM),
                pad -> hanging(pad).map(MissionPad::height));
    private final Field<MissionPad, Double> rotation =
        key(
                "rotation",
                "On a wall: where its rocket points, in degrees counter-clockwise; 0 is"
                    + " upwards.")
            .optional(NumberCodec.ANGLE.or(0.0), pad -> hanging(pad).map(MissionPad::rotation));

    PadCodec() {
      super("pad", Phrase.of("a mission pad"), "A mission pad on the floor, or on a wall.");
      add(Case.with("wall").needs("height").excludes("at", "heading"));
      add(Case.without("wall").needs("at").excludes("along", "height", "rotation"));
    }

    private static Optional<MissionPad> lying(MissionPad pad) {
      return Optional.of(pad).filter(any -> any.surface() == Surface.FLOOR);
    }

    private static Optional<MissionPad> hanging(MissionPad pad) {
      return Optional.of(pad).filter(any -> any.surface() != Surface.FLOOR);
    }

    @Override
    MissionPad make(Entries in) {
      Optional<Surface> surface = in.find(wall);
      return surface.isEmpty()
          ? MissionPad.onFloor(in.get(id), in.get(at), in.get(heading))
          : new MissionPad(
              in.get(id), surface.get(), in.get(along), in.get(height), in.get(rotation));
    }
  }

  /** The wind. */
  static final class WindCodec extends RecordCodec<Wind> {

    private static final NumberCodec SPEED = NumberCodec.speed(Wind.FASTEST * 100);

    private final Field<Wind, Double> towards =
        key("towards", "Where it blows to, in degrees counter-clockwise; 0 is along x.")
            .usual(NumberCodec.ANGLE.or(0.0), WindCodec::heading);
    private final Field<Wind, Double> speed =
        key("speed", "In cm/s.").usual(SPEED.or(0.0), wind -> wind.mean().norm());
    private final Field<Wind, Double> gusts =
        key("gusts", "How much it varies (standard deviation) in cm/s.")
            .usual(SPEED.or(0.0), Wind::gusts);

    WindCodec() {
      super("wind", Phrase.of("wind"), "Moving air.");
    }

    private static double heading(Wind wind) {
      return wind.mean().norm() == 0 ? 0 : StrictMath.atan2(wind.mean().y(), wind.mean().x());
    }

    @Override
    Wind make(Entries in) {
      double mean = in.get(speed);
      double angle = in.get(towards);
      Vec3 velocity =
          mean == 0
              ? Vec3.ZERO
              : new Vec3(StrictMath.cos(angle) * mean, StrictMath.sin(angle) * mean, 0);
      return new Wind(velocity, in.get(gusts));
    }
  }
}
