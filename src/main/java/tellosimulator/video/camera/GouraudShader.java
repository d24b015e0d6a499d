package tellosimulator.video.camera;

import java.util.Arrays;

/** Shades surfaces of a single colour with interpolated light (Gouraud shading). */
final class GouraudShader implements SpanShader {

  private final Gradients gradients;
  private final Span span;
  private FrameBuffer frameBuffer = FrameBuffer.forScreen(0, 0);
  private int color;

  GouraudShader(Gradients gradients, Span span) {
    this.gradients = gradients;
    this.span = span;
  }

  void setTarget(FrameBuffer newFrameBuffer) {
    frameBuffer = newFrameBuffer;
  }

  /**
   * Sets the colour.
   *
   * @param packed the colour, packed in the frame buffer's colour space
   */
  void setColor(int packed) {
    color = packed;
  }

  @Override
  public void shade(int row, int fromX, int toX) {
    double x = fromX + 0.5;
    double y = row + 0.5;
    double invZ = gradients.invZdx * x + gradients.invZdy * y + gradients.invZ;
    span.x = fromX;
    span.count = toX - fromX;
    Arrays.fill(span.first, 0, span.count, color >> 16 & 255);
    Arrays.fill(span.second, 0, span.count, color >> 8 & 255);
    Arrays.fill(span.third, 0, span.count, color & 255);
    interpolateLight(
        gradients.lightOverZdx * x + gradients.lightOverZdy * y + gradients.lightOverZ, invZ);
    span.modulate(frameBuffer.space());
    frameBuffer.draw(row, span, (float) invZ, (float) gradients.invZdx);
  }

  private void interpolateLight(double firstLightOverZ, double firstInvZ) {
    if (gradients.constantLight) { // avoids a division for each pixel
      Arrays.fill(span.light, 0, span.count, intensity(gradients.lightValue));
      return;
    }
    double lightOverZ = firstLightOverZ;
    double invZ = firstInvZ;
    for (int i = 0; i < span.count; i++) {
      span.light[i] = intensity(lightOverZ / invZ);
      lightOverZ += gradients.lightOverZdx;
      invZ += gradients.invZdx;
    }
  }

  private static int intensity(double light) {
    return Math.max(0, Math.min(256, (int) (256 * light + 0.5)));
  }
}
