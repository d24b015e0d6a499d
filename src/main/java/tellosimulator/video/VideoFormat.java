package tellosimulator.video;

import tellosimulator.model.VideoSettings;

/**
 * The format of a stream.
 *
 * @param width width of the pictures [pixels]
 * @param height height of the pictures [pixels]
 * @param framesPerSecond pictures a second
 * @param bitsPerSecond average bit rate [bit/s]
 * @param downward whether the pictures come from the downward camera rather than the forward camera
 */
record VideoFormat(
    int width, int height, int framesPerSecond, int bitsPerSecond, boolean downward) {

  /**
   * Bit rate if the operator requested none [bit/s]. Assumed: a value between the 1 Mbit/s measured
   * for a still scene and the 4 Mbit/s of another capture.
   */
  private static final int AUTOMATIC = 2_500_000;

  private static final int MEGABIT = 1_000_000;

  /**
   * Returns the format for the drone's settings. Documented: the default format is 960 by 720
   * pixels. Measured: the low setting gives 648 by 478 pixels, the downward camera 320 by 720, and
   * the wide setting 1280 by 720 (TelloPy), which cuts off the upper and the lower edge.
   */
  static VideoFormat of(VideoSettings settings) {
    int bits = settings.megabits() == 0 ? AUTOMATIC : settings.megabits() * MEGABIT;
    int frames = settings.framesPerSecond();
    if (settings.downward()) {
      return new VideoFormat(320, 720, frames, bits, true);
    }
    if (settings.wide()) {
      return new VideoFormat(1280, 720, frames, bits, false);
    }
    return settings.lines() == VideoSettings.DEFAULT.lines()
        ? new VideoFormat(960, 720, frames, bits, false)
        : new VideoFormat(648, 478, frames, bits, false);
  }

  boolean sameSizeAs(VideoFormat other) {
    return width == other.width && height == other.height;
  }

  /** The interval between pictures [ns]. */
  long period() {
    return 1_000_000_000L / framesPerSecond;
  }
}
