package tellosimulator.video.camera;

import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.picture.Picture;

/** Where the pictures of a drone's camera come from. Each video thread has its own. */
public interface FrameSource {

  /**
   * Fills a picture with what the camera sees. Returns when it is filled.
   *
   * @param snapshot the moment
   * @param picture gets the picture; its size is that of the picture
   */
  void film(SimSnapshot snapshot, Shot shot, Picture picture);

  /**
   * What there is to see, as a value: where two of them are equal, so are the pictures of one size
   * that this source takes. A source that cannot tell gives one that equals no other.
   */
  default Object sight(SimSnapshot snapshot, Shot shot) {
    return new Object();
  }
}
