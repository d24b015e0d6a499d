package tellosimulator.video;

import tellosimulator.model.VideoSettings;

/**
 * What a stream is like.
 *
 * @param width pixels
 * @param height pixels
 * @param framesPerSecond pictures a second
 * @param bitsPerSecond on average
 * @param downward whether the camera that looks at the floor films
 */
record VideoFormat(
    int width, int height, int framesPerSecond, int bitsPerSecond, boolean downward) {

  /**
   * Bit rate where none was asked for [bit/s]. Assumed: between the 1 Mbit/s that was measured on a
   * still scene and the 4 Mbit/s of another capture.
   */
  private static final int AUTOMATIC = 2_500_000;

  private static final int MEGABIT = 1_000_000;

  /** Documented: 960 by 720; measured: low is 648 by 478, the camera below gives 320 by 720. */
  static VideoFormat of(VideoSettings settings) {
    int bits = settings.megabits() == 0 ? AUTOMATIC : settings.megabits() * MEGABIT;
    int frames = settings.framesPerSecond();
    if (settings.downward()) {
      return new VideoFormat(320, 720, frames, bits, true);
    }
    return settings.lines() == VideoSettings.DEFAULT.lines()
        ? new VideoFormat(960, 720, frames, bits, false)
        : new VideoFormat(648, 478, frames, bits, false);
  }

  boolean sameSizeAs(VideoFormat other) {
    return width == other.width && height == other.height;
  }

  /** From picture to picture [ns]. */
  long period() {
    return 1_000_000_000L / framesPerSecond;
  }
}
