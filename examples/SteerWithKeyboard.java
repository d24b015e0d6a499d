import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * Steers a drone from the keyboard with {@code rc}, which moves four sticks.
 *
 * <p>Start the simulator first, in another terminal: {@code mvn javafx:run}, and switch the drone
 * on. Then start this, with nothing but a JDK:
 *
 * <pre>java examples/SteerWithKeyboard.java [host] [port]</pre>
 *
 * <p>Type letters, then Enter. Each letter steers for half a second, so {@code wwwwll} flies ahead
 * for two seconds and then turns right for one.
 *
 * <p>Without host and port it flies the simulator on this machine (127.0.0.1, port 8879). A real
 * Tello has host 192.168.10.1 and port 8889.
 */
public final class SteerWithKeyboard {

  /** A drone answers a motion only when it is over; a takeoff takes several seconds. */
  private static final int PATIENCE_MS = 20_000;

  /** Often enough to steer smoothly, and to keep the drone from landing by itself after 15 s. */
  private static final int PERIOD_MS = 100;

  private static final int TIMES_A_KEY = 5;

  /** For each key the sticks: right, forward, up, clockwise; each from -100 to 100. */
  private static final Map<Character, String> STICKS =
      Map.of(
          'w', "0 40 0 0",
          's', "0 -40 0 0",
          'a', "-40 0 0 0",
          'd', "40 0 0 0",
          'i', "0 0 40 0",
          'k', "0 0 -40 0",
          'j', "0 0 0 -40",
          'l', "0 0 0 40");

  private static final String HOVER = "0 0 0 0";
  private static final char QUIT = 'q';

  private final DatagramSocket socket;
  private final BlockingQueue<Character> keys = new LinkedBlockingQueue<>();

  private SteerWithKeyboard(DatagramSocket socket) {
    this.socket = socket;
  }

  public static void main(String[] args) throws InterruptedException {
    String host = args.length > 0 ? args[0] : "127.0.0.1";
    int port = args.length > 1 ? Integer.parseInt(args[1]) : 8879;
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.connect(new InetSocketAddress(host, port));
      socket.setSoTimeout(PATIENCE_MS);
      new SteerWithKeyboard(socket).fly();
    } catch (PortUnreachableException e) {
      fail("Nothing listens at %s:%d. Does the simulator run, and is the drone on?", host, port);
    } catch (SocketTimeoutException e) {
      fail("No reply from %s:%d. Is the drone on, and are host and port right?", host, port);
    } catch (IOException e) {
      fail("The flight failed: %s", e.getMessage());
    }
  }

  private void fly() throws IOException, InterruptedException {
    command("command");
    command("takeoff");
    try {
      System.out.println("w ahead, s back, a left, d right, i up, k down, j turn left, l right.");
      System.out.println("Type letters, then Enter; q lands and ends.");
      startReading();
      steer();
    } finally {
      send("rc " + HOVER); // the sticks keep their values, even over a landing
      command("land");
    }
  }

  /** Moves the sticks as the keys say, until it is time to land. */
  private void steer() throws IOException, InterruptedException {
    while (true) {
      Character key = keys.poll(PERIOD_MS, TimeUnit.MILLISECONDS);
      if (key == null) {
        send("rc " + HOVER);
      } else if (key == QUIT) {
        return;
      } else if (STICKS.containsKey(key)) {
        hold(STICKS.get(key));
      }
    }
  }

  private void hold(String sticks) throws IOException, InterruptedException {
    for (int i = 0; i < TIMES_A_KEY; i++) {
      send("rc " + sticks);
      Thread.sleep(PERIOD_MS);
    }
  }

  /** Reads on a thread of its own, because reading waits for the next key. */
  private void startReading() {
    Thread reader = new Thread(this::read, "keyboard");
    reader.setDaemon(true);
    reader.start();
  }

  private void read() {
    try {
      for (int key = System.in.read(); key >= 0; key = System.in.read()) {
        keys.add((char) key);
      }
    } catch (IOException e) {
      System.err.println("The keyboard cannot be read any more: " + e.getMessage());
    }
    keys.add(QUIT);
  }

  /** Sends a command that must be answered with {@code ok}. */
  private void command(String text) throws IOException {
    send(text);
    DatagramPacket packet = new DatagramPacket(new byte[1500], 1500);
    socket.receive(packet);
    String reply =
        new String(packet.getData(), 0, packet.getLength(), StandardCharsets.US_ASCII).strip();
    System.out.println(text + " -> " + reply);
    if (!reply.equals("ok")) {
      throw new IOException("the drone answered `%s` to `%s`".formatted(reply, text));
    }
  }

  /** Sends without waiting: {@code rc} is never answered. */
  private void send(String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    socket.send(new DatagramPacket(bytes, bytes.length));
  }

  private static void fail(String message, Object... values) {
    System.err.println(message.formatted(values));
    System.exit(1);
  }
}
