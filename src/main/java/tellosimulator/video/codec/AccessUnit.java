package tellosimulator.video.codec;

/**
 * One encoded frame as an H.264 access unit in byte stream format (Annex B): its NAL units one
 * after another, each with a start code of four bytes. An IDR access unit has three (SPS, PPS and
 * the slice), any other just the slice. The encoder refills it for each frame; for the encoder's
 * thread.
 */
public interface AccessUnit {

  /** The byte stream itself, not a copy; bytes beyond {@link #size} are undefined. */
  byte[] bytes();

  /** The size of the byte stream. */
  int size();

  /** The number of NAL units. */
  int nalUnits();

  /**
   * The offset of a NAL unit's start code.
   *
   * @param index from 0; {@link #nalUnits} gives {@link #size}
   */
  int start(int index);

  /** Whether this is an IDR access unit, with which decoding can begin. */
  boolean idr();
}
