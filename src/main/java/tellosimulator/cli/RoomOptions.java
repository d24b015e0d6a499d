package tellosimulator.cli;

import java.util.List;
import java.util.stream.Stream;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Quantity;
import tellosimulator.world.Decor;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Walls;

/** The command-line options for the room and the starting point of the drones. */
final class RoomOptions {

  final OptionValue<Room> room;
  final OptionValue<Walls> walls;
  final OptionValue<List<Poster>> posters;

  /** The point around which the drones start, room frame [m]. */
  final OptionValue<Vec3> start;

  RoomOptions(OptionList optionList) {
    room =
        optionList
            .option(
                "--room",
                "WxDxH",
                "Width, depth and height of the room in cm, each "
                    + OptionTypes.bounds(Quantity.ROOM_EDGE)
                    + ".")
            .read(OptionTypes::roomSize, "500x500x300");
    walls =
        optionList
            .option(
                "--walls",
                "auto|textured|plain",
                "textured: walls and floor with patterns that cameras can see. plain: even colours."
                    + " auto: parquet and plaster, with windows and a door.")
            .readOneOf(Walls.values(), Walls::option, Decor.DEFAULT.walls());
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
                    + " Several drones stand in a row around it.")
            .read(OptionTypes::floorPoint, "0,0");
  }

  /** Whether any option for the room is given. */
  boolean given() {
    return Stream.of(room, walls, posters, start).anyMatch(OptionValue::given);
  }
}
