package tellosimulator.cli;

import java.util.List;
import java.util.stream.Stream;
import tellosimulator.math.Vec3;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Walls;

/** The options that say what the room is like, and where in it the drones start. */
final class RoomOptions {

  private final OptionValue<Room> room;
  private final OptionValue<Walls> walls;
  private final OptionValue<List<Poster>> posters;
  private final OptionValue<OptionTypes.Point> start;

  RoomOptions(OptionList optionList) {
    room =
        optionList
            .option(
                "--room",
                "WxDxH",
                "Width, depth and height of the room in cm, each 100 to 20000. Default: 500x500x300.")
            .read(OptionTypes::roomSize, "500x500x300");
    walls =
        optionList
            .option(
                "--walls",
                "auto|textured|plain",
                "textured: walls and floor with patterns that cameras can see. plain: even colours."
                    + " auto: textured in the drones' film, calm in the window. Default: auto.")
            .read(OptionTypes::wallsName, "auto");
    posters =
        optionList
            .option(
                "--poster",
                "WALL,ALONG,HEIGHT,WIDTH,FILE",
                "Hang an image file (PNG, JPEG, GIF or BMP) on a wall: front, back, left, right, floor or"
                    + " ceiling. ALONG is from the middle of the wall to the right, HEIGHT from the floor"
                    + " to the middle of the image (on floor and ceiling: from the middle upwards), and"
                    + " WIDTH that of the image, all in cm. Can be given several times.")
            .readEach(OptionTypes::posterOnWall);
    start =
        optionList
            .option(
                "--start",
                "X,Y",
                "Where the drone starts, in cm from the room's centre: X along its depth, Y to the left."
                    + " Several drones stand in a row around it. Default: 0,0.")
            .read(OptionTypes::floorPoint, "0,0");
  }

  /** Whether anything is said about the room. */
  boolean given() {
    return Stream.of(room, walls, posters, start).anyMatch(OptionValue::given);
  }

  OptionValue<Room> size() {
    return room;
  }

  Room room() {
    return room.value();
  }

  OptionValue<Walls> walls() {
    return walls;
  }

  List<Poster> posters() {
    return posters.value();
  }

  OptionValue<OptionTypes.Point> startPoint() {
    return start;
  }

  /** Around where the drones start, room frame [m]. */
  Vec3 start() {
    return start.value().inMeters();
  }
}
