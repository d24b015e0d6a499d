package tellosimulator.testing;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Deque;
import tellosimulator.Main;

/** The program as users start it, with a guest that fills its memory when something is typed. */
public final class HungryProgram {

  private static final int LEAST_BYTE = 16;

  private HungryProgram() {}

  /** Takes the arguments of the program. */
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

  /** Takes whatever becomes free, too. */
  private static void eat() {
    Deque<byte[]> eaten = new ArrayDeque<>();
    for (int size = 1 << 20; !eaten.isEmpty() || size > 0; ) {
      try {
        eaten.add(new byte[size]);
      } catch (OutOfMemoryError e) {
        size = Math.max(LEAST_BYTE, size / 2);
      }
    }
  }
}
