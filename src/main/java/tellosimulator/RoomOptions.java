package tellosimulator;

import java.util.List;
import picocli.CommandLine.Option;
import tellosimulator.math.Vec3;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Walls;

/** The options that say what the room is like, and where in it the drones start. */
final class RoomOptions {

  @Option(
      names = "--room",
      paramLabel = "WxDxH",
      defaultValue = "500x500x300",
      converter = OptionTypes.RoomSize.class,
      description =
          "Width, depth and height of the room in cm, each 100 to 20000. Default: 500x500x300.")
  private Room room;

  @Option(
      names = "--walls",
      paramLabel = "textured|plain",
      defaultValue = "textured",
      converter = OptionTypes.WallsName.class,
      description =
          "textured: walls and floor with patterns that cameras can see. plain: even colours."
              + " Default: textured.")
  private Walls walls;

  @Option(
      names = "--poster",
      paramLabel = "WALL,ALONG,HEIGHT,WIDTH,FILE",
      converter = OptionTypes.PosterOnWall.class,
      description =
          "Hang an image file (PNG, JPEG, GIF or BMP) on a wall: front, back, left, right, floor or"
              + " ceiling. ALONG is from the middle of the wall to the right, HEIGHT from the floor"
              + " to the middle of the image (on floor and ceiling: from the middle upwards), and"
              + " WIDTH that of the image, all in cm. Can be given several times.")
  private List<Poster> posters = List.of();

  @Option(
      names = "--start",
      paramLabel = "X,Y",
      defaultValue = "0,0",
      converter = OptionTypes.FloorPoint.class,
      description =
          "Where the drone starts, in cm from the room's centre: X along its depth, Y to the left."
              + " Several drones stand in a row around it. Default: 0,0.")
  private OptionTypes.Point start;

  Room room() {
    return room;
  }

  Walls walls() {
    return walls;
  }

  List<Poster> posters() {
    return posters;
  }

  /** Around where the drones start, room frame [m]. */
  Vec3 start() {
    return start.inMetres();
  }
}
