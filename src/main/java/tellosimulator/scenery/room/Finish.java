package tellosimulator.scenery.room;

import tellosimulator.world.Walls;

/** What floor, walls and ceiling of a scene are finished with. */
public enum Finish {
  /** Even colours, with lines at each metre. */
  PLAIN,
  /** Patterns with detail, for programs that look at a drone's film. */
  TEXTURED,
  /** Fine parquet and plaster, in front of which people see drones, gates and paths at once. */
  CALM;

  /** That of a scene for people. */
  public static Finish forPeople(Walls walls) {
    return walls == Walls.AUTO ? CALM : chosen(walls);
  }

  /** That of a scene that a drone films. */
  public static Finish forFilm(Walls walls) {
    return walls == Walls.AUTO ? TEXTURED : chosen(walls);
  }

  private static Finish chosen(Walls walls) {
    return walls == Walls.PLAIN ? PLAIN : TEXTURED;
  }
}
