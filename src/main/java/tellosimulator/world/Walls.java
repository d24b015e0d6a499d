package tellosimulator.world;

/** The finish of the floor, the walls and the ceiling. */
public enum Walls {
  /** Parquet and plaster, with windows and a door. */
  AUTO("auto"),
  /** Uniform colours. */
  PLAIN("plain"),
  /** Detailed patterns, so that programs that process the video find features everywhere. */
  TEXTURED("textured");

  private final String option;

  Walls(String option) {
    this.option = option;
  }

  /** Returns the word that selects this finish on the command line. */
  public String option() {
    return option;
  }
}
