package tellosimulator.video.camera;

/**
 * A camera without distortion.
 *
 * @param width of the picture in pixels
 * @param height of the picture in pixels; pixels are square
 * @param fieldOfView from the left to the right edge [rad]
 */
public record Lens(int width, int height, double fieldOfView) {

  public Lens {
    if (!(fieldOfView > 0 && fieldOfView < Math.PI)) {
      throw new IllegalArgumentException(
          "fieldOfView is " + fieldOfView + ", but must be between 0 and pi");
    }
  }

  /** From the camera to a picture whose pixels have the size 1 [pixels]. */
  public double focalLength() {
    return width / 2.0 / Math.tan(fieldOfView / 2);
  }
}
