package tellosimulator.video;

/**
 * How a stream goes, over its last second. Immutable; for any thread.
 *
 * @param framesPerSecond pictures a second
 * @param bitsPerSecond bits a second; 0 while nothing is encoded
 * @param filmMs to take a picture, on average [ms]
 * @param encodeMs to encode it, on average [ms]
 */
public record VideoFigures(
    double framesPerSecond, double bitsPerSecond, double filmMs, double encodeMs) {

  /** Nothing has been filmed yet. */
  public static final VideoFigures NONE = new VideoFigures(0, 0, 0, 0);
}
