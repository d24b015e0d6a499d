package tellosimulator.junit;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** A minimal operator program. */
final class ScriptedOperator {

  private static final int PATIENCE_MS = 30_000;

  private ScriptedOperator() {}

  /** Sends commands, each after the reply to the previous one, and returns the replies. */
  static List<String> fly(SimulatedDrone drone, String... commands) throws IOException {
    List<String> replies = new ArrayList<>();
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(PATIENCE_MS);
      for (String command : commands) {
        send(socket, drone, command);
        DatagramPacket reply = new DatagramPacket(new byte[2048], 2048);
        socket.receive(reply);
        replies.add(
            new String(reply.getData(), 0, reply.getLength(), StandardCharsets.ISO_8859_1).strip());
      }
    }
    return replies;
  }

  /** Sends commands without waiting for anything. */
  static void send(SimulatedDrone drone, String... commands) throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      for (String command : commands) {
        send(socket, drone, command);
      }
    }
  }

  private static void send(DatagramSocket socket, SimulatedDrone drone, String command)
      throws IOException {
    byte[] bytes = command.getBytes(StandardCharsets.ISO_8859_1);
    socket.send(new DatagramPacket(bytes, bytes.length, drone.address()));
  }
}
