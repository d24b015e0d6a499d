package tellosimulator.endurance;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import tellosimulator.command.GarbageSource;

/** A program that sends datagrams to a drone, evenly, and takes no answers. */
final class Stranger {

  /** Different texts; more would not fit into a cache, and sending them would take longer. */
  private static final int TEXTS = 4096;

  /** How often it looks what is due [ns]. */
  private static final long TICK = 500_000;

  private Stranger() {}

  /**
   * Prints {@code sending} after the first datagram and {@code sent N in S s} after the last.
   *
   * @param arguments address and port of the drone, datagrams a second, seconds, addresses to send
   *     from with commas between them, and what to send: {@code garbage}, {@code nonsense} (in
   *     which there are no commands), or a text; then, if there is one, how many at the most
   */
  public static void main(String[] arguments) throws IOException {
    InetSocketAddress drone = new InetSocketAddress(arguments[0], Integer.parseInt(arguments[1]));
    double rate = Double.parseDouble(arguments[2]);
    double seconds = Double.parseDouble(arguments[3]);
    List<DatagramChannel> sockets = new ArrayList<>();
    for (String address : arguments[4].split(",", -1)) {
      sockets.add(
          DatagramChannel.open().bind(new InetSocketAddress(InetAddress.getByName(address), 0)));
    }
    List<ByteBuffer> texts = texts(arguments[5]);
    long most = arguments.length > 6 ? Long.parseLong(arguments[6]) : Long.MAX_VALUE;
    long start = System.nanoTime();
    long sent = 0;
    while (sent < most && System.nanoTime() - start < seconds * 1e9) {
      long due = Math.min(most, (long) ((System.nanoTime() - start) * 1e-9 * rate) + 1);
      while (sent < due && System.nanoTime() - start < seconds * 1e9) {
        ByteBuffer text = texts.get((int) (sent % texts.size()));
        sockets.get((int) (sent % sockets.size())).send(text.rewind(), drone);
        if (sent++ == 0) {
          System.out.println("sending");
        }
      }
      LockSupport.parkNanos(TICK);
    }
    System.out.printf("sent %d in %.3f s%n", sent, (System.nanoTime() - start) * 1e-9);
  }

  private static List<ByteBuffer> texts(String what) {
    List<ByteBuffer> texts = new ArrayList<>();
    GarbageSource garbage = new GarbageSource(TEXTS);
    for (int i = 0; i < TEXTS; i++) {
      String text =
          switch (what) {
            case "garbage" -> garbage.next();
            case "nonsense" -> "nonsense " + i;
            default -> what;
          };
      byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
      texts.add(ByteBuffer.allocateDirect(bytes.length).put(bytes));
    }
    return texts;
  }
}
