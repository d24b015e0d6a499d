package tellosimulator.video.camera;

import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.picture.Picture;

/** A source of frames of the drones' cameras. Each video thread has its own. */
public interface FrameSource {

  /**
   * Fills a picture with the camera's image. Returns when it is filled.
   *
   * @param snapshot the moment
   * @param picture receives the image, in the picture's size
   */
  void film(SimSnapshot snapshot, CameraId camera, Picture picture);

  /**
   * What the camera sees, as a value: where two are equal, so are the frames of one size that this
   * source takes. A source that cannot tell gives one that equals no other.
   */
  default Object sight(SimSnapshot snapshot, CameraId camera) {
    return new Object();
  }
}
