package tellosimulator.video.camera;

/** Paints a translucent texture over what is there. */
final class DecalBrush extends TextureBrush {

  /**
   * How much nearer a decal counts than it is. Decided: far more than rounding does to what lies in
   * the same plane, and at 5 m still only 2.5 mm.
   */
  private static final float IN_FRONT = 1.0005f;

  private static final int OPAQUE = 0xff000000;

  private int opacity;
  private float forward = 1;

  DecalBrush(Slopes slopes) {
    super(slopes);
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
  void piece(int from, int to) {
    int[] toPixels = pixels;
    float[] toNearness = nearness;
    long[] texels = level.texels();
    int uMask = level.width() - 1;
    int vMask = level.height() - 1;
    int below = level.width() + 1;
    float atNear = near * forward;
    float addNear = nearStep * forward;
    int share = opacity;
    int atU = u;
    int addU = uStep;
    int atV = v;
    int addV = vStep;
    for (int i = from; i < to; i++) {
      if (atNear >= toNearness[i]) {
        int texel = ((atV >> 16) & vMask) * below + ((atU >> 16) & uMask);
        int right = (atU >> 8) & 255;
        int down = (atV >> 8) & 255;
        int both = (right * down) >> 8;
        long mixed =
            texels[texel] * (256 - right - down + both)
                + texels[texel + 1] * (right - both)
                + texels[texel + below] * (down - both)
                + texels[texel + below + 1] * both;
        long over = Lanes.mean(Lanes.mean(mixed) * share);
        int covered = (int) (over >>> 48);
        long under = Lanes.mean(Lanes.of(toPixels[i]) * (256 - covered - (covered >> 7)));
        toPixels[i] = OPAQUE | Lanes.packed(over + under);
      }
      atNear += addNear;
      atU += addU;
      atV += addV;
    }
  }
}
