package tellosimulator.video.camera;

import java.util.Optional;
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

  /** Everything that a frame of this snapshot shows; empty if this source cannot tell. */
  default Optional<CameraView> view(SimSnapshot snapshot, CameraId camera) {
    return Optional.empty();
  }
}
