package tellosimulator.video.codec;

import tellosimulator.video.picture.Picture;

/** Makes a stream of pictures of one size. For one thread at a time. */
public interface VideoEncoder {

  /**
   * How much may be sent from now on.
   *
   * @param framesPerSecond pictures a second
   * @param bitsPerSecond bits a second, on average
   */
  void setRate(int framesPerSecond, int bitsPerSecond);

  /**
   * Encodes the next picture.
   *
   * @param picture is read only during the call
   * @param key whether decoding shall be able to begin here
   * @return the encoded picture, valid until the next call
   */
  EncodedPicture encode(Picture picture, boolean key);
}
