package tellosimulator.model;

/**
 * The video settings of a drone, as set by its operator. Immutable.
 *
 * @param on whether video is sent
 * @param starts the number of times that video has been started since power-on
 * @param framesPerSecond the frame rate [frames/s]
 * @param megabits the bit rate [Mbit/s]; 0 for automatic
 * @param lines the height of a frame
 * @param wide whether the frame is 16:9 instead of 4:3, and shows a part of the view
 * @param downward whether the picture of the downward camera is sent
 * @param keyPictures the number of key pictures that have been requested since power-on
 */
public record VideoSettings(
    boolean on,
    int starts,
    int framesPerSecond,
    int megabits,
    int lines,
    boolean wide,
    boolean downward,
    int keyPictures) {

  /** The settings at power-on. Measured: 960 by 720 pixels at 30 frames per second. */
  public static final VideoSettings DEFAULT =
      new VideoSettings(false, 0, 30, 0, 720, false, false, 0);

  /** Returns a copy that is switched on. This counts as a new start even if video was on. */
  public VideoSettings started() {
    return new VideoSettings(
        true, starts + 1, framesPerSecond, megabits, lines, wide, downward, keyPictures);
  }

  /** Returns a copy that is switched off. */
  public VideoSettings stopped() {
    return new VideoSettings(
        false, starts, framesPerSecond, megabits, lines, wide, downward, keyPictures);
  }

  /** Returns a copy with another value of an option. */
  public VideoSettings with(VideoOption option, int value) {
    return new VideoSettings(
        on,
        starts,
        option == VideoOption.FRAMES_PER_SECOND ? value : framesPerSecond,
        option == VideoOption.BIT_RATE ? value : megabits,
        option == VideoOption.LINES ? value : lines,
        option == VideoOption.WIDE ? value == 1 : wide,
        option == VideoOption.DOWNWARD ? value == 1 : downward,
        keyPictures);
  }

  /** Returns a copy that requests one more key picture. */
  public VideoSettings withKeyPicture() {
    return new VideoSettings(
        on, starts, framesPerSecond, megabits, lines, wide, downward, keyPictures + 1);
  }
}
