package tellosimulator.command;

/** What {@code setfps}, {@code setbitrate}, {@code setresolution} and {@code downvision} set. */
public enum VideoOption {
  /** Pictures a second. */
  FRAMES_PER_SECOND,
  /** Megabits a second; 0 for automatic. */
  BIT_RATE,
  /** Lines of a picture. */
  LINES,
  /** 1 for the camera that looks down, 0 for the one that looks ahead. */
  DOWNWARD
}
