package pilot;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;

/** A drone, as a program sees it: a text goes out, a text comes back. */
public final class Tello implements AutoCloseable {

  private final DatagramSocket socket;
  private final InetSocketAddress drone;

  public Tello(InetSocketAddress drone, Duration timeout) throws IOException {
    this.drone = drone;
    this.socket = new DatagramSocket();
    socket.setSoTimeout((int) timeout.toMillis());
  }

  /** Sends a text and returns the reply; throws an exception if none comes in time. */
  public String send(String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    socket.send(new DatagramPacket(bytes, bytes.length, drone));
    DatagramPacket reply = new DatagramPacket(new byte[1024], 1024);
    socket.receive(reply);
    return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII).strip();
  }

  /** Sends a command; throws an exception unless the reply is {@code ok}. */
  public void command(String command) throws IOException {
    String reply = send(command);
    if (!reply.equals("ok")) {
      throw new IOException("the drone answered `" + reply + "` to `" + command + "`");
    }
  }

  @Override
  public void close() {
    socket.close();
  }
}
