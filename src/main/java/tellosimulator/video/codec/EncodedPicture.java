package tellosimulator.video.codec;

/**
 * A picture as H.264: its NAL units one after another, each with a start code of four bytes (Annex
 * B). A key picture has three: sequence parameters, picture parameters, and the one slice; others
 * have only the slice. Filled anew with each picture; for the encoder's thread.
 */
public interface EncodedPicture {

  /** The bytes themselves, not a copy; what lies beyond {@link #size} means nothing. */
  byte[] bytes();

  /** How many bytes there are. */
  int size();

  /** How many NAL units there are. */
  int units();

  /**
   * Where a NAL unit begins, with its start code.
   *
   * @param unit from 0; {@link #units} gives {@link #size}
   */
  int start(int unit);

  /** Whether decoding can begin here. */
  boolean key();
}
