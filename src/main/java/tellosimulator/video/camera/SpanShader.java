package tellosimulator.video.camera;

/**
 * Shades the spans of a triangle and writes them to a frame buffer. A shader is set up for each
 * triangle by its {@link Gradients}. Not thread-safe.
 */
interface SpanShader {

  /**
   * Shades a span.
   *
   * @param y the scanline
   * @param fromX the first pixel
   * @param toX the pixel after the last one
   */
  void shade(int y, int fromX, int toX);
}
