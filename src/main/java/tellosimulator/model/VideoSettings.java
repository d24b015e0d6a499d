package tellosimulator.model;

/**
 * What an operator asked of the video. Immutable.
 *
 * @param on whether it is sent
 * @param framesPerSecond pictures a second
 * @param megabits bit rate in Mbit/s; 0 for automatic
 * @param lines height of a picture
 * @param downward whether the camera that looks down is sent
 */
public record VideoSettings(
    boolean on, int framesPerSecond, int megabits, int lines, boolean downward) {

  /** Measured: 960 by 720 pixels at 30 pictures a second. */
  public static final VideoSettings DEFAULT = new VideoSettings(false, 30, 0, 720, false);

  public VideoSettings withOn(boolean newOn) {
    return new VideoSettings(newOn, framesPerSecond, megabits, lines, downward);
  }

  public VideoSettings withFramesPerSecond(int newFramesPerSecond) {
    return new VideoSettings(on, newFramesPerSecond, megabits, lines, downward);
  }

  public VideoSettings withMegabits(int newMegabits) {
    return new VideoSettings(on, framesPerSecond, newMegabits, lines, downward);
  }

  public VideoSettings withLines(int newLines) {
    return new VideoSettings(on, framesPerSecond, megabits, newLines, downward);
  }

  public VideoSettings withDownward(boolean newDownward) {
    return new VideoSettings(on, framesPerSecond, megabits, lines, newDownward);
  }
}
