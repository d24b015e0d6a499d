package tellosimulator.scenario;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Wind;

/** Codecs of the room, posters, mission pads and wind. */
final class RoomCodecs {

  /** Codec of the number of a mission pad. */
  static final Codec<Integer> PAD_ID =
      Scalars.count(Phrase.of("a pad from 1 to %d", MissionPad.LAST_ID), 1, MissionPad.LAST_ID);

  private RoomCodecs() {}

  static Codec<Room> room() {
    RecordCodec<Room> codec =
        new RecordCodec<>(
            "room", Phrase.of("a room"), "Size of the room in cm. Its floor's centre is [0, 0].");
    NumberCodec edge = NumberCodec.length(Quantity.ROOM_EDGE);
    Field<Room, Double> width =
        codec.key("width", "Along y.").usual(edge.orWritten(Room.DEFAULT.width()), Room::width);
    Field<Room, Double> depth =
        codec.key("depth", "Along x.").usual(edge.orWritten(Room.DEFAULT.depth()), Room::depth);
    Field<Room, Double> height =
        codec.key("height", "Along z.").usual(edge.orWritten(Room.DEFAULT.height()), Room::height);
    return codec.made(in -> new Room(in.get(width), in.get(depth), in.get(height)));
  }

  static Codec<Poster> poster() {
    RecordCodec<Poster> codec =
        new RecordCodec<>(
            "poster", Phrase.of("a poster"), "An image on a wall, the floor or the ceiling.");
    Field<Poster, Surface> wall =
        codec
            .key("wall", "Surface on which it hangs.")
            .need(new WordCodec<>(Surface.byWord()), Poster::surface);
    Field<Poster, Double> along =
        codec
            .key(
                "along",
                "From the middle of the wall to that of the image, to the right as one looks"
                    + " at it, in cm.")
            .usual(Scalars.OFFSET.orWritten(0.0), Poster::along);
    Field<Poster, Double> height =
        codec
            .key(
                "height",
                "From the floor to the middle of the image in cm; on floor and ceiling, from their"
                    + " middle upwards.")
            .need(Scalars.OFFSET, Poster::height);
    Field<Poster, Double> width =
        codec
            .key("width", "Width of the image in cm; its height follows.")
            .need(NumberCodec.length(Quantity.POSTER_WIDTH), Poster::width);
    Field<Poster, String> picture =
        codec
            .key(
                "picture", "Image file (PNG, JPEG, GIF or BMP), seen from the folder of this file.")
            .need(Scalars.PICTURE, Poster::picture);
    Field<Poster, String> name =
        codec
            .key("name", "Its name for goals; without it, that of the file without its ending.")
            .optional(Scalars.LINE, Poster::givenName);
    return codec.made(
        in ->
            new Poster(
                in.get(wall),
                in.get(along),
                in.get(height),
                in.get(width),
                in.get(picture),
                in.find(name)));
  }

  /** Returns the codec of a mission pad on the floor or on a wall. */
  static Codec<MissionPad> pad() {
    RecordCodec<MissionPad> codec =
        new RecordCodec<>(
            "pad", Phrase.of("a mission pad"), "A mission pad on the floor, or on a wall.");
    Map<String, Surface> walls = new HashMap<>(Surface.byWord());
    walls.values().removeIf(surface -> !surface.wall());
    Field<MissionPad, Integer> id =
        codec.key("id", "The number that is printed on it.").need(PAD_ID, MissionPad::id);
    Field<MissionPad, Vec3> at =
        codec
            .key("at", "On the floor: where its middle is, [x, y] in cm.")
            .optional(Scalars.FLOOR_POINT, lying(pad -> pad.pose(Room.DEFAULT).position()));
    Field<MissionPad, Double> heading =
        codec
            .key(
                "heading",
                "On the floor: where its rocket points, in degrees counter-clockwise; 0 is"
                    + " along x.")
            .optional(NumberCodec.ANGLE.or(0.0), lying(MissionPad::rotation));
    Field<MissionPad, Surface> wall =
        codec
            .key("wall", "On which wall it hangs.")
            .optional(new WordCodec<>(walls), hanging(MissionPad::surface));
    Field<MissionPad, Double> along =
        codec
            .key(
                "along",
                "On a wall: from its middle to that of the pad, to the right as one looks at"
                    + " it, in cm.")
            .optional(Scalars.OFFSET.orWritten(0.0), hanging(MissionPad::along));
    Field<MissionPad, Double> height =
        codec
            .key("height", "On a wall: of the pad's middle above the floor in cm.")
            .optional(NumberCodec.length(Quantity.HEIGHT), hanging(MissionPad::height));
    Field<MissionPad, Double> rotation =
        codec
            .key(
                "rotation",
                "On a wall: where its rocket points, in degrees counter-clockwise; 0 is upwards.")
            .optional(NumberCodec.ANGLE.or(0.0), hanging(MissionPad::rotation));
    codec.add(Case.with("wall").needs("height").excludes("at", "heading"));
    codec.add(Case.without("wall").needs("at").excludes("along", "height", "rotation"));
    return codec.made(
        in ->
            in.find(wall)
                .map(
                    side ->
                        new MissionPad(
                            in.get(id), side, in.get(along), in.get(height), in.get(rotation)))
                .orElseGet(() -> MissionPad.onFloor(in.get(id), in.get(at), in.get(heading))));
  }

  private static <V> Function<MissionPad, Optional<V>> lying(Function<MissionPad, V> getter) {
    return pad -> pad.surface().wall() ? Optional.empty() : Optional.of(getter.apply(pad));
  }

  private static <V> Function<MissionPad, Optional<V>> hanging(Function<MissionPad, V> getter) {
    return pad -> pad.surface().wall() ? Optional.of(getter.apply(pad)) : Optional.empty();
  }

  static Codec<Wind> wind() {
    RecordCodec<Wind> codec = new RecordCodec<>("wind", Phrase.of("wind"), "Moving air.");
    NumberCodec range = NumberCodec.speed(Quantity.WIND_SPEED);
    Field<Wind, Double> towards =
        codec
            .key(
                "towards",
                "Direction towards which it blows, in degrees counter-clockwise; 0 is along x.")
            .usual(NumberCodec.ANGLE.or(0.0), RoomCodecs::heading);
    Field<Wind, Double> speed =
        codec.key("speed", "In cm/s.").usual(range.or(0.0), wind -> wind.mean().norm());
    Field<Wind, Double> gusts =
        codec
            .key("gusts", "Standard deviation of its speed in cm/s.")
            .usual(range.or(0.0), Wind::gusts);
    return codec.made(in -> new Wind(velocity(in.get(speed), in.get(towards)), in.get(gusts)));
  }

  private static double heading(Wind wind) {
    return wind.mean().norm() == 0 ? 0 : StrictMath.atan2(wind.mean().y(), wind.mean().x());
  }

  private static Vec3 velocity(double speed, double angle) {
    return speed == 0
        ? Vec3.ZERO
        : new Vec3(StrictMath.cos(angle) * speed, StrictMath.sin(angle) * speed, 0);
  }
}
