package tellosimulator.model;

/**
 * The video settings of a drone, as set by its operator. Immutable.
 *
 * @param on whether video is sent
 * @param starts the number of times that video has been started since power-on
 * @param framesPerSecond the frame rate [frames/s]
 * @param megabits the bit rate [Mbit/s]; 0 for automatic
 * @param lines the height of a frame
 * @param downward whether the picture of the downward camera is sent
 */
public record VideoSettings(
    boolean on, int starts, int framesPerSecond, int megabits, int lines, boolean downward) {

  /** The settings at power-on. Measured: 960 by 720 pixels at 30 frames per second. */
  public static final VideoSettings DEFAULT = new VideoSettings(false, 0, 30, 0, 720, false);

  /** Returns a copy that is switched on. This counts as a new start even if video was on. */
  public VideoSettings started() {
    return new VideoSettings(true, starts + 1, framesPerSecond, megabits, lines, downward);
  }

  /** Returns a copy that is switched off. */
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
