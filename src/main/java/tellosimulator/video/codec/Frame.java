package tellosimulator.video.codec;

import tellosimulator.video.picture.Picture;

/**
 * A 4:2:0 frame that consists of whole macroblocks and has padded borders. The encoder has three of
 * them: the source frame, the reconstructed frame, and the reference frame, which is the
 * reconstruction of the previous frame.
 */
final class Frame {

  /**
   * Padding of the luma plane [samples]. Decided: motion vectors may point up to 24 samples beyond
   * the edge, and the six-tap filter needs up to eight more.
   */
  static final int BORDER = 32;

  final Plane luma;
  final Plane cb;
  final Plane cr;
  final int widthInMbs;
  final int heightInMbs;

  Frame(int widthInMbs, int heightInMbs) {
    this.widthInMbs = widthInMbs;
    this.heightInMbs = heightInMbs;
    luma = new Plane(16 * widthInMbs, 16 * heightInMbs, BORDER);
    cb = new Plane(8 * widthInMbs, 8 * heightInMbs, BORDER / 2);
    cr = new Plane(8 * widthInMbs, 8 * heightInMbs, BORDER / 2);
  }

  void load(Picture picture) {
    luma.load(picture.y(), picture.width());
    cb.load(picture.u(), picture.width() / 2);
    cr.load(picture.v(), picture.width() / 2);
  }

  void expandBorders() {
    luma.expandBorders();
    cb.expandBorders();
    cr.expandBorders();
  }
}
