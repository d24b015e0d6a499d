package tellosimulator.endurance;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * A student's program: takes off, flies a metre there and back, lands, and is told ok each time.
 */
final class StudentProgram {

  private static final List<String> COMMANDS =
      List.of("command", "takeoff", "forward 50", "cw 180", "forward 50", "land");

  private static final int PATIENCE_MS = 10_000;

  private StudentProgram() {}

  /**
   * Prints {@code flown}, or ends with an error.
   *
   * @param arguments address and port of the drone
   */
  public static void main(String[] arguments) throws IOException {
    InetSocketAddress drone = new InetSocketAddress(arguments[0], Integer.parseInt(arguments[1]));
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.connect(drone);
      socket.setSoTimeout(PATIENCE_MS);
      for (String command : COMMANDS) {
        String reply = ask(socket, command);
        if (!reply.equals("ok")) {
          throw new IOException("`" + command + "` was answered `" + reply + "`");
        }
      }
    }
    System.out.println("flown");
  }

  /** Sends a text, and waits for the reply. */
  static String ask(DatagramSocket socket, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    socket.send(new DatagramPacket(bytes, bytes.length));
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    socket.receive(packet);
    return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.ISO_8859_1);
  }
}
