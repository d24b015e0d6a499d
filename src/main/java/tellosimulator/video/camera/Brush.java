package tellosimulator.video.camera;

/**
 * Paints what of a triangle is in a row of the picture, where nothing nearer is. Prepared for each
 * triangle; for one thread.
 */
interface Brush {

  /**
   * Paints.
   *
   * @param from the first pixel's column
   * @param to one beyond the last one's
   */
  void row(int row, int from, int to);
}
