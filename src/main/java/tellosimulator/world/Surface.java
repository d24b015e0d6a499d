package tellosimulator.world;

/** What a drone can run into. */
public enum Surface {
  FLOOR("the floor"),
  CEILING("the ceiling"),
  FRONT_WALL("the front wall"),
  BACK_WALL("the back wall"),
  LEFT_WALL("the left wall"),
  RIGHT_WALL("the right wall");

  private final String words;

  Surface(String words) {
    this.words = words;
  }

  /** For people. */
  public String words() {
    return words;
  }
}
