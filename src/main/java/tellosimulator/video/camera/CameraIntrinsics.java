package tellosimulator.video.camera;

/**
 * The intrinsics of a pinhole camera with square pixels, a principal point in the middle of the
 * image, and no distortion.
 *
 * @param width width of the image [pixels]
 * @param height height of the image [pixels]
 * @param fieldOfView horizontal field of view, from the left to the right edge [rad]
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
