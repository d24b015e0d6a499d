package tellosimulator.launcher;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;

/**
 * Copies the output of a program up to a limit. Output beyond the limit is read and discarded, so
 * that the program does not block. Confined to the thread of its worker.
 */
final class BoundedCopy implements Agent {

  /**
   * Default of the number of bytes to copy. Decided: enough for a program that prints each state
   * line for hours.
   */
  static final int LIMIT = 10_000_000;

  private final InputStream from;
  private final OutputStream to;
  private final byte[] buffer = new byte[8192];
  private final int limit;
  private int left;
  private final AtomicLong printed = new AtomicLong();

  /**
   * Creates a copy.
   *
   * @param limit maximum number of bytes to copy
   */
  BoundedCopy(InputStream from, OutputStream to, int limit) {
    this.from = from;
    this.to = to;
    this.limit = limit;
    this.left = limit;
  }

  /** Returns the number of bytes that the program has printed. Thread-safe. */
  long printed() {
    return printed.get();
  }

  /**
   * Copies in one call until the output ends. If the copying took several calls, the last output
   * would be lost when the worker is ended.
   */
  @Override
  public Outcome doWork() throws IOException {
    boolean cut = false;
    for (int count = read(); count >= 0; count = read()) {
      int copied = Math.min(count, left);
      left -= copied;
      printed.addAndGet(count);
      to.write(buffer, 0, copied);
      if (copied < count && !cut) {
        to.write(cut());
        cut = true;
      }
    }
    return Outcome.FINISHED;
  }

  private int read() {
    try {
      return from.read(buffer);
    } catch (IOException e) {
      return -1; // the program was killed
    }
  }

  private byte[] cut() {
    String most = limit < 1_000_000 ? limit + " bytes" : limit / 1_000_000 + " MB";
    return ("\n[The program printed more than " + most + "; the rest is left out.]\n")
        .getBytes(StandardCharsets.US_ASCII);
  }

  @Override
  public ErrorPolicy onError(Throwable failure) {
    return ErrorPolicy.goOn("What the program prints was not written");
  }
}
