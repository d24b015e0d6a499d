package tellosimulator.video.camera;

/** Paints a texture that hides what is behind it, as it is or in changing light. */
final class SurfaceBrush extends TextureBrush {

  SurfaceBrush(Slopes slopes, Strip strip) {
    super(slopes, strip, false);
  }

  @Override
  void paint(int row, float near, float step) {
    if (lit()) {
      strip.shade(raster.space());
    }
    raster.draw(row, strip, near, step);
  }
}
