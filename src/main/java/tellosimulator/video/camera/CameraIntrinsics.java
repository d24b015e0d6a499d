package tellosimulator.video.camera;

/**
 * The intrinsics of a pinhole camera: square pixels, principal point in the middle, no distortion.
 *
 * @param width of the image in pixels
 * @param height of the image in pixels
 * @param fieldOfView horizontal, from the left to the right edge [rad]
 */
public record CameraIntrinsics(int width, int height, double fieldOfView) {

  public CameraIntrinsics {
    if (!(fieldOfView > 0 && fieldOfView < Math.PI)) {
      throw new IllegalArgumentException(
          "fieldOfView is " + fieldOfView + ", but must be between 0 and pi");
    }
  }

  /** The focal length [pixels]. */
  public double focalLength() {
    return width / 2.0 / StrictMath.tan(fieldOfView / 2);
  }
}
