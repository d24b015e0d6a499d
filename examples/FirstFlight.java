import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;

/**
 * A first flight: take off, fly a metre ahead, turn to the right, land.
 *
 * <p>Start the simulator first, in another terminal: {@code mvn javafx:run}. Then start this, with
 * nothing but a JDK:
 *
 * <pre>java examples/FirstFlight.java [host] [port]</pre>
 *
 * <p>Without host and port it flies the simulator on this machine (127.0.0.1, port 8879). A real
 * Tello has host 192.168.10.1 and port 8889.
 */
public final class FirstFlight {

  /** A drone answers a motion only when it is over; a takeoff takes several seconds. */
  private static final int PATIENCE_MS = 20_000;

  private final DatagramSocket socket;

  private FirstFlight(DatagramSocket socket) {
    this.socket = socket;
  }

  public static void main(String[] args) {
    String host = args.length > 0 ? args[0] : "127.0.0.1";
    int port = args.length > 1 ? Integer.parseInt(args[1]) : 8879;
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.connect(new InetSocketAddress(host, port));
      socket.setSoTimeout(PATIENCE_MS);
      new FirstFlight(socket).fly();
    } catch (PortUnreachableException e) {
      fail("Nothing listens at %s:%d. Does the simulator run, and is the drone on?", host, port);
    } catch (SocketTimeoutException e) {
      fail("No reply from %s:%d. Is the drone on, and are host and port right?", host, port);
    } catch (IOException e) {
      fail("The flight failed: %s", e.getMessage());
    }
  }

  private void fly() throws IOException {
    command("command"); // turns the SDK mode on; before it, the drone ignores everything else
    System.out.println("Battery: " + ask("battery?") + " %");
    command("takeoff");
    try {
      command("forward 100");
      command("cw 90");
    } finally {
      command("land"); // whatever went wrong: never leave a drone in the air
    }
    System.out.println("Landed.");
  }

  /** Sends a command that must be answered with {@code ok}. */
  private void command(String text) throws IOException {
    String reply = ask(text);
    System.out.println(text + " -> " + reply);
    if (!reply.equals("ok")) {
      throw new IOException("the drone answered `%s` to `%s`".formatted(reply, text));
    }
  }

  /** Sends a text and waits for the answer. */
  private String ask(String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    socket.send(new DatagramPacket(bytes, bytes.length));
    DatagramPacket reply = new DatagramPacket(new byte[1500], 1500);
    socket.receive(reply);
    return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII).strip();
  }

  private static void fail(String message, Object... values) {
    System.err.println(message.formatted(values));
    System.exit(1);
  }
}
