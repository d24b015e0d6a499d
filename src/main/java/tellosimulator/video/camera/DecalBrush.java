package tellosimulator.video.camera;

/** Paints a translucent texture over what is there. */
final class DecalBrush extends TextureBrush {

  /**
   * How much nearer a decal counts than it is. Decided: far more than rounding does to what lies in
   * the same plane, and at 5 m still only 2.5 mm.
   */
  private static final float IN_FRONT = 1.0005f;

  private int opacity;
  private float forward = 1;

  DecalBrush(Slopes slopes, Strip strip) {
    super(slopes, strip, true);
  }

  /**
   * From now on all is that translucent.
   *
   * @param newOpacity 0 to 1
   * @param flat whether it lies on something
   */
  void opacity(double newOpacity, boolean flat) {
    forward = flat ? IN_FRONT : 1;
    opacity = (int) Math.round(256 * Math.max(0, Math.min(1, newOpacity)));
  }

  @Override
  void paint(int row, float near, float step) {
    raster.blend(row, strip, near * forward, step * forward, opacity);
  }
}
