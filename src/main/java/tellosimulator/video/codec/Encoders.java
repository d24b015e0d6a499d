package tellosimulator.video.codec;

/** Makes encoders. For any thread. */
@FunctionalInterface
public interface Encoders {

  /**
   * A new encoder.
   *
   * @param width of its pictures in pixels, even
   * @param height of its pictures in pixels, even
   */
  VideoEncoder encoder(int width, int height);
}
