package tellosimulator.video.camera;

import java.util.Optional;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.picture.Picture;

/** Provides the frames of the drones' cameras. Each video thread has its own source. */
public interface FrameSource {

  /**
   * Fills a picture with the camera's image before it returns.
   *
   * @param snapshot the state to be rendered
   * @param picture receives the image, in the size of the picture
   */
  void film(SimSnapshot snapshot, CameraId camera, Picture picture);

  /** Returns a black picture in the size of photos. */
  default Picture blankPhoto() {
    return new Picture(DroneOptics.DEFAULT.photoWidth(), DroneOptics.DEFAULT.photoHeight());
  }

  /**
   * Returns everything that determines a frame of a snapshot, except the noise; empty if this
   * source cannot determine it.
   */
  default Optional<CameraView> view(SimSnapshot snapshot, CameraId camera) {
    return Optional.empty();
  }
}
