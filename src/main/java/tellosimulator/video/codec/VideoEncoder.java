package tellosimulator.video.codec;

import tellosimulator.video.picture.Picture;

/** Encodes a sequence of frames of one size. Used by one thread at a time. */
public interface VideoEncoder {

  /** Creates encoders. Thread-safe. */
  @FunctionalInterface
  interface Factory {

    /**
     * Creates an encoder.
     *
     * @param width width of the frames [pixels], even
     * @param height height of the frames [pixels], even
     */
    VideoEncoder create(int width, int height);
  }

  /**
   * Sets the target bit rate from the next frame on.
   *
   * @param framesPerSecond frames a second
   * @param bitsPerSecond bits a second, on average
   */
  void setRate(int framesPerSecond, int bitsPerSecond);

  /**
   * Encodes the next frame.
   *
   * @param picture read only during the call
   * @param forceIdr whether the frame must be an IDR frame
   * @return the encoded frame, valid until the next call
   */
  AccessUnit encode(Picture picture, boolean forceIdr);
}
