package tellosimulator.video.camera;

/**
 * Shades spans of a triangle and writes them to a frame buffer. Set up for each triangle by its
 * {@link Gradients}; for one thread.
 */
interface SpanShader {

  /**
   * Shades a span.
   *
   * @param y the scanline
   * @param fromX the first pixel
   * @param toX one beyond the last pixel
   */
  void shade(int y, int fromX, int toX);
}
