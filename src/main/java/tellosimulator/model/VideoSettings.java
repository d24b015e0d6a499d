package tellosimulator.model;

/**
 * What an operator asked of the video. Immutable.
 *
 * @param on whether it is sent
 * @param starts how often an operator asked for it since power-on
 * @param framesPerSecond pictures a second
 * @param megabits bit rate in Mbit/s; 0 for automatic
 * @param lines height of a picture
 * @param downward whether the camera that looks down is sent
 */
public record VideoSettings(
    boolean on, int starts, int framesPerSecond, int megabits, int lines, boolean downward) {

  /** Measured: 960 by 720 pixels at 30 pictures a second. */
  public static final VideoSettings DEFAULT = new VideoSettings(false, 0, 30, 0, 720, false);

  /** On, as if it had been off: an operator asked for it, perhaps once more. */
  public VideoSettings started() {
    return new VideoSettings(true, starts + 1, framesPerSecond, megabits, lines, downward);
  }

  /** Off. */
  public VideoSettings stopped() {
    return new VideoSettings(false, starts, framesPerSecond, megabits, lines, downward);
  }

  public VideoSettings withFramesPerSecond(int newFramesPerSecond) {
    return new VideoSettings(on, starts, newFramesPerSecond, megabits, lines, downward);
  }

  public VideoSettings withMegabits(int newMegabits) {
    return new VideoSettings(on, starts, framesPerSecond, newMegabits, lines, downward);
  }

  public VideoSettings withLines(int newLines) {
    return new VideoSettings(on, starts, framesPerSecond, megabits, newLines, downward);
  }

  public VideoSettings withDownward(boolean newDownward) {
    return new VideoSettings(on, starts, framesPerSecond, megabits, lines, newDownward);
  }
}
