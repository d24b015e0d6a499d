package tellosimulator.operator;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;

/**
 * Copies what a program prints, up to a limit; what is beyond is read all the same, so that the
 * program goes on. For the thread of its worker.
 */
final class BoundedCopy implements Agent {

  /** Bytes that are copied. Decided: hours of a program that prints each state line. */
  static final int LIMIT = 10_000_000;

  private static final byte[] CUT =
      "\n[The program printed more than 10 MB; the rest is left out.]\n"
          .getBytes(StandardCharsets.US_ASCII);

  private final InputStream from;
  private final OutputStream to;
  private final byte[] buffer = new byte[8192];
  private int left = LIMIT;

  BoundedCopy(InputStream from, OutputStream to) {
    this.from = from;
    this.to = to;
  }

  /** Copies to the end; otherwise the last output is lost when the worker is ended. */
  @Override
  public Outcome doWork() throws IOException {
    boolean cut = false;
    for (int count = from.read(buffer); count >= 0; count = from.read(buffer)) {
      int copied = Math.min(count, left);
      left -= copied;
      to.write(buffer, 0, copied);
      if (copied < count && !cut) {
        to.write(CUT);
        cut = true;
      }
    }
    return Outcome.FINISHED;
  }

  @Override
  public ErrorPolicy onError(Throwable failure) {
    return ErrorPolicy.goOn("What the program prints was not written");
  }
}
