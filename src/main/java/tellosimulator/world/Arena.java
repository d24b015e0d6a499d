package tellosimulator.world;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * A room with all that is in it, but for the drones. Immutable.
 *
 * @param decor what the room looks like
 * @param obstacles in the order of their numbers
 * @param pads mission pads, none of them twice
 * @param wind how the air moves
 */
public record Arena(
    Room room, Decor decor, List<Obstacle> obstacles, List<MissionPad> pads, Wind wind) {

  /** The default room, empty. */
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

  /** A room with nothing in it. */
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
}
