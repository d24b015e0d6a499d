package tellosimulator.video.codec;

import tellosimulator.video.picture.Picture;

/** Encodes a sequence of frames of one size. For one thread at a time. */
public interface VideoEncoder {

  /** Creates encoders. For any thread. */
  @FunctionalInterface
  interface Factory {

    /**
     * Creates an encoder.
     *
     * @param width of its frames in pixels, even
     * @param height of its frames in pixels, even
     */
    VideoEncoder create(int width, int height);
  }

  /**
   * Sets the target bit rate, from the next frame on.
   *
   * @param framesPerSecond frames a second
   * @param bitsPerSecond bits a second, on average
   */
  void setRate(int framesPerSecond, int bitsPerSecond);

  /**
   * Encodes the next frame.
   *
   * @param picture is read only during the call
   * @param forceIdr whether the frame must be an IDR frame
   * @return the encoded frame, valid until the next call
   */
  AccessUnit encode(Picture picture, boolean forceIdr);
}
