package tellosimulator.video.camera;

/** Paints a texture in changing light. */
final class LitBrush extends TextureBrush {

  private final long black;

  LitBrush(Slopes slopes, ColorSpace space) {
    super(slopes);
    black = Lanes.of(space.black());
  }

  @Override
  void piece(int from, int to) {
    int[] toPixels = pixels;
    float[] toNearness = nearness;
    long[] texels = level.texels();
    int uMask = level.width() - 1;
    int vMask = level.height() - 1;
    int below = level.width() + 1;
    float atNear = near;
    float addNear = nearStep;
    int atU = u;
    int addU = uStep;
    int atV = v;
    int addV = vStep;
    int atLight = light;
    int addLight = lightStep;
    long dark = black;
    for (int i = from; i < to; i++) {
      if (atNear > toNearness[i]) {
        toNearness[i] = atNear;
        int texel = ((atV >> 16) & vMask) * below + ((atU >> 16) & uMask);
        int right = (atU >> 8) & 255;
        int down = (atV >> 8) & 255;
        int both = (right * down) >> 8;
        long mixed =
            texels[texel] * (256 - right - down + both)
                + texels[texel + 1] * (right - both)
                + texels[texel + below] * (down - both)
                + texels[texel + below + 1] * both;
        int bright = atLight >> 16;
        long shaded = Lanes.mean(mixed) * bright + dark * (256 - bright);
        toPixels[i] = Lanes.packed(Lanes.mean(shaded));
      }
      atNear += addNear;
      atU += addU;
      atV += addV;
      atLight += addLight;
    }
  }
}
