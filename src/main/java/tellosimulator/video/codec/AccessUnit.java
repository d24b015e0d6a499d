package tellosimulator.video.codec;

import java.nio.ByteBuffer;

/**
 * One encoded frame as an H.264 access unit in byte stream format (Annex B). It consists of NAL
 * units one after another, each with a start code of four bytes. An IDR access unit has three NAL
 * units (SPS, PPS and the slice); any other access unit has only the slice. An encoder reuses one
 * access unit for all frames. Used by one thread at a time.
 */
public interface AccessUnit {

  /** The byte stream itself, not a copy. Bytes beyond {@link #size} are undefined. */
  byte[] bytes();

  /** The size of the byte stream [bytes]. */
  int size();

  /** The number of NAL units. */
  int nalUnits();

  /**
   * Returns the offset of a NAL unit's start code.
   *
   * @param index from 0; for {@link #nalUnits}, the result is {@link #size}
   */
  int start(int index);

  /**
   * Returns a view of a NAL unit, including its start code.
   *
   * @param index from 0
   */
  default ByteBuffer nalUnit(int index) {
    return ByteBuffer.wrap(bytes(), start(index), start(index + 1) - start(index));
  }

  /** Whether this is an IDR access unit, at which decoding can start. */
  boolean idr();
}
