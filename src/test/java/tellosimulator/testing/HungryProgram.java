package tellosimulator.testing;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.locks.LockSupport;
import tellosimulator.Main;

/** The program with a thread that fills its memory as soon as a line is typed. */
public final class HungryProgram {

  private static final int LEAST_BYTE = 16;

  /**
   * Pause between two failed allocations [ns]: each costs two collections of the whole heap, which
   * take seconds on a busy machine, and the program must get processor time.
   */
  private static final long REST_NANOS = 1_000_000_000;

  private HungryProgram() {}

  /** Accepts the arguments of the program. */
  public static void main(String[] args) {
    InputStream typed = System.in;
    System.setIn(InputStream.nullInputStream());
    Thread guest = new Thread(() -> eatWhenToldTo(typed), "guest");
    guest.setDaemon(true);
    guest.start();
    Main.main(args);
  }

  private static void eatWhenToldTo(InputStream typed) {
    try {
      if (typed.read() >= 0) {
        eat();
      }
    } catch (IOException e) {
      throw new IllegalStateException("nobody can say when to eat", e);
    }
  }

  /** Fills the heap, and also all memory that becomes free later. */
  private static void eat() {
    Deque<byte[]> eaten = new ArrayDeque<>();
    for (int size = 1 << 20; !eaten.isEmpty() || size > 0; ) {
      try {
        eaten.add(new byte[size]);
      } catch (OutOfMemoryError e) {
        if (size == LEAST_BYTE) {
          LockSupport.parkNanos(REST_NANOS);
        }
        size = Math.max(LEAST_BYTE, size / 2);
      }
    }
  }
}
