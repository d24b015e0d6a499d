package tellosimulator.world;

/** What floor, walls and ceiling are covered with. */
public enum Walls {
  /** Textured where a drone films, and calm where people look into the room. */
  AUTO("auto"),
  /** Even colours. */
  PLAIN("plain"),
  /** Patterns with detail, so that programs can see where the drone is. */
  TEXTURED("textured");

  private final String option;

  Walls(String option) {
    this.option = option;
  }

  /** Its word on the command line. */
  public String option() {
    return option;
  }
}
