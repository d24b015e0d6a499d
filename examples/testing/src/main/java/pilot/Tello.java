package pilot;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;

/** A drone, as a program sees it: a text goes out, a text comes back. */
public final class Tello implements AutoCloseable {

  private static final int TRIES = 3;

  private final DatagramSocket socket;
  private final InetSocketAddress drone;

  public Tello(InetSocketAddress drone, Duration timeout) throws IOException {
    this.drone = drone;
    this.socket = new DatagramSocket();
    socket.setSoTimeout((int) timeout.toMillis());
  }

  /** Sends a command, and waits for the reply; throws an exception if there is none. */
  public String send(String command) throws IOException {
    byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
    socket.send(new DatagramPacket(bytes, bytes.length, drone));
    DatagramPacket reply = new DatagramPacket(new byte[1024], 1024);
    socket.receive(reply);
    return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII).strip();
  }

  /** Asks a question again if no reply comes; what moves the drone must not be sent twice. */
  public String ask(String question) throws IOException {
    for (int i = 1; i < TRIES; i++) {
      try {
        return send(question);
      } catch (SocketTimeoutException e) {
        // lost on the way
      }
    }
    return send(question);
  }

  @Override
  public void close() {
    socket.close();
  }
}
