package tellosimulator.model;

/**
 * The settings of {@code setfps}, {@code setbitrate}, {@code setresolution} and {@code downvision}.
 */
public enum VideoOption {
  /** Frame rate [frames/s]. */
  FRAMES_PER_SECOND,
  /** Bit rate [Mbit/s]; 0 for automatic. */
  BIT_RATE,
  /** Height of a frame [lines]. */
  LINES,
  /** 1 for 16:9, 0 for 4:3; set by the app. */
  WIDE,
  /** 1 for the downward camera, 0 for the forward one. */
  DOWNWARD
}
