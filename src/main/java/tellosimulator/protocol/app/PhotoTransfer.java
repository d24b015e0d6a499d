package tellosimulator.protocol.app;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import tellosimulator.protocol.app.Telemetry.Notification;
import tellosimulator.time.SimTime;

/**
 * A photo on its way to the app: first its size, then its pieces, each when the one before has been
 * acknowledged. What is not acknowledged is repeated. Measured: the formats of SMerrony/tello,
 * TelloLib and TelloPy, and a log of a photo (TelloPy 25). Confined to the simulation thread.
 */
final class PhotoTransfer {

  /** Time from the order to the first message [s]. Decided; the photo is rendered meanwhile. */
  private static final double TAKES = 1;

  /** Time after which a message that is not acknowledged is repeated [s]. Decided. */
  private static final double REPEATS_AFTER = 0.5;

  /** Number of times that a message is sent before the drone gives up. Decided. */
  private static final int ATTEMPTS = 10;

  /** Length of a chunk [bytes]. */
  private static final int CHUNK = 1024;

  /** Length of what precedes the data of a chunk [bytes]. */
  private static final int HEAD = 12;

  /** Number of chunks in a piece. */
  private static final int PIECE = 8;

  private static final byte JPEG = 1;

  /** The photo before its size has been acknowledged. */
  private static final int NO_PIECE = -1;

  private final int file;
  private final Supplier<byte[]> photo;
  private SimTime due;
  private byte[] bytes = {};
  private int piece = NO_PIECE;
  private int attempts;
  private boolean over;

  /**
   * Begins a transfer.
   *
   * @param file the number of the file, 16 bits
   * @param photo waits for the photo and supplies it as a JPEG file; empty if it failed
   */
  PhotoTransfer(int file, Supplier<byte[]> photo, SimTime now) {
    this.file = file;
    this.photo = photo;
    due = now.plus(TAKES);
  }

  /**
   * Whether nothing has been sent yet. Later, the transfer waits for the program, and time need not
   * pass.
   */
  boolean beingTaken() {
    return bytes.length == 0;
  }

  /** Whether all pieces have been acknowledged, or the drone has given up. */
  boolean over() {
    return over;
  }

  /** Returns what is due at the end of this step. */
  List<Notification> due(SimTime now) {
    if (over || now.compareTo(due) < 0) {
      return List.of();
    }
    if (bytes.length == 0) {
      bytes = photo.get();
    }
    over = bytes.length == 0 || attempts == ATTEMPTS;
    if (over) {
      return List.of();
    }
    attempts++;
    due = now.plus(REPEATS_AFTER);
    return piece == NO_PIECE ? List.of(size()) : chunks();
  }

  private Notification size() {
    byte[] payload = new byte[7];
    buffer(payload).put(JPEG).putInt(bytes.length).putShort((short) file);
    return new Notification(MessageId.FILE_SIZE, payload);
  }

  private List<Notification> chunks() {
    List<Notification> chunks = new ArrayList<>();
    for (int chunk = piece * PIECE; chunk < Math.min((piece + 1) * PIECE, chunkCount()); chunk++) {
      int from = chunk * CHUNK;
      int length = Math.min(CHUNK, bytes.length - from);
      byte[] payload = new byte[HEAD + length];
      ByteBuffer out = buffer(payload).putShort((short) file).putInt(piece).putInt(chunk);
      out.putShort((short) length).put(bytes, from, length);
      chunks.add(new Notification(MessageId.FILE_DATA, payload));
    }
    return chunks;
  }

  private int chunkCount() {
    return (bytes.length + CHUNK - 1) / CHUNK;
  }

  private static ByteBuffer buffer(byte[] payload) {
    return ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Handles the acknowledgement of the size. */
  void sizeAcknowledged(SimTime now) {
    acknowledged(NO_PIECE, now);
  }

  /**
   * Handles the acknowledgement of a piece.
   *
   * @param last whether the app has received everything; the number then has no meaning, because
   *     TelloLib sends a wrong one
   */
  void acknowledged(int number, boolean last, SimTime now) {
    if (last) {
      over = true;
    } else {
      acknowledged(number, now);
    }
  }

  private void acknowledged(int number, SimTime now) {
    if (bytes.length > 0 && number == piece) {
      piece++;
      attempts = 0;
      due = now;
      over = piece * PIECE >= chunkCount();
    }
  }
}
