package tellosimulator.world;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * A room with its contents, except for the drones. Immutable.
 *
 * @param decor the appearance of the room
 * @param obstacles the obstacles, in the order of their numbers
 * @param pads the mission pads; each id occurs at most once
 * @param wind the motion of the air
 */
public record Arena(
    Room room, Decor decor, List<Obstacle> obstacles, List<MissionPad> pads, Wind wind) {

  /** The default arena: the default room without contents. */
  public static final Arena DEFAULT = empty(Room.DEFAULT, Decor.DEFAULT);

  public Arena {
    obstacles = List.copyOf(obstacles);
    pads = List.copyOf(pads);
    Set<Integer> ids = new HashSet<>();
    for (MissionPad pad : pads) {
      if (!ids.add(pad.id())) {
        throw new IllegalArgumentException(
            "pads are " + pads + ", but each may be there only once");
      }
    }
  }

  /** Returns an arena without contents and without wind. */
  public static Arena empty(Room room, Decor decor) {
    return new Arena(room, decor, List.of(), List.of(), Wind.CALM);
  }

  public Arena withRoom(Room newRoom) {
    return new Arena(newRoom, decor, obstacles, pads, wind);
  }

  public Arena withDecor(Decor newDecor) {
    return new Arena(room, newDecor, obstacles, pads, wind);
  }

  public Arena withObstacles(List<Obstacle> newObstacles) {
    return new Arena(room, decor, newObstacles, pads, wind);
  }

  public Arena withPads(List<MissionPad> newPads) {
    return new Arena(room, decor, obstacles, newPads, wind);
  }

  public Arena withWind(Wind newWind) {
    return new Arena(room, decor, obstacles, pads, newWind);
  }

  /** Returns the image files that the room refers to. */
  public Stream<String> pictures() {
    Stream<String> onWalls = decor.posters().stream().map(Poster::picture);
    Stream<String> onObstacles =
        obstacles.stream().flatMap(each -> each.appearance().pictures().values().stream());
    return Stream.concat(onWalls, onObstacles).distinct();
  }
}
