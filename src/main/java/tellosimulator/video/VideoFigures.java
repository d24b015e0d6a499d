package tellosimulator.video;

/**
 * The figures of a stream over the last second. Immutable.
 *
 * @param framesPerSecond pictures a second
 * @param bitsPerSecond bits a second; 0 while nothing is encoded
 * @param filmMs average time to render a picture [ms]
 * @param encodeMs average time to encode a picture [ms]
 */
public record VideoFigures(
    double framesPerSecond, double bitsPerSecond, double filmMs, double encodeMs) {

  /** The figures before the first picture. */
  public static final VideoFigures NONE = new VideoFigures(0, 0, 0, 0);
}
