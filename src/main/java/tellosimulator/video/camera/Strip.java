package tellosimulator.video.camera;

/**
 * What a part of a row gets: a number for each pixel and channel, before it is known which of the
 * pixels are hidden. Where a colour space has colours for every second pixel only ({@link
 * ColorSpace#coarse()}), its second and third channel are those of even columns. Arrays are used
 * again for each; for one thread.
 */
final class Strip {

  /** The column of the first pixel. */
  int from;

  /** How many pixels there are. */
  int count;

  /** 0 to 255, as all channels. */
  int[] first = new int[0];

  int[] second = new int[0];
  int[] third = new int[0];

  /** How far each pixel covers what is behind it, 0 to 255; only translucent ones have it. */
  int[] opacity = new int[0];

  /** The same for the second and third channel. */
  int[] colorOpacity = new int[0];

  /** How much of each pixel's opacity counts, 0 to 256; nothing where it is hidden. */
  int[] shares = new int[0];

  /** Brightness of each pixel, 0 to 256; only lighted ones have it. */
  int[] light = new int[0];

  /** From now on there is room for so many pixels. */
  void room(int most) {
    if (first.length < most) {
      first = new int[most];
      second = new int[most];
      third = new int[most];
      opacity = new int[most];
      colorOpacity = new int[most];
      shares = new int[most];
      light = new int[most];
    }
  }

  /** The number of the first pixel in an even column. */
  int odd() {
    return from & 1;
  }

  /** How many pixels are in even columns. */
  int evenCount() {
    return (count - odd() + 1) / 2;
  }

  /** Leaves the shares of even columns. */
  void halveShares() {
    int odd = odd();
    int size = evenCount();
    for (int i = 0; i < size; i++) {
      shares[i] = shares[2 * i + odd];
    }
  }

  /** Mixes all channels with black, as far as there is no light. */
  void shade(ColorSpace space) {
    int black = space.black();
    shade(first, 0, 1, count, black >> 16 & 255);
    int start = space.coarse() ? odd() : 0;
    int step = space.coarse() ? 2 : 1;
    int colors = space.coarse() ? evenCount() : count;
    shade(second, start, step, colors, black >> 8 & 255);
    shade(third, start, step, colors, black & 255);
  }

  private void shade(int[] values, int start, int step, int size, int black) {
    int[] lights = light;
    int at = start;
    for (int i = 0; i < size; i++, at += step) {
      int bright = lights[at];
      values[i] = (values[i] * bright + black * (256 - bright)) >> 8;
    }
  }
}
