package tellosimulator.benchmark;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;

/** A small operator program: sends a command and waits for the reply. */
public final class Operator implements AutoCloseable {

  private static final int LONGEST_WAIT_MS = 30_000;

  private final DatagramSocket socket;
  private final int port;
  private final int tries;
  private final byte[] buffer = new byte[2048];
  private int sentAgain;

  public Operator(int dronePort) throws IOException {
    this(dronePort, LONGEST_WAIT_MS);
  }

  /**
   * @param patienceMs how long it waits for a reply [ms]
   */
  public Operator(int dronePort, int patienceMs) throws IOException {
    this(dronePort, patienceMs, 1);
  }

  /**
   * @param patienceMs how long it waits for a reply [ms]
   * @param tries how often it sends a command to which no reply comes, as client packages do
   */
  public Operator(int dronePort, int patienceMs, int tries) throws IOException {
    this.tries = tries;
    socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    socket.setSoTimeout(patienceMs);
    port = dronePort;
  }

  public void send(String command) throws IOException {
    byte[] bytes = command.getBytes(StandardCharsets.ISO_8859_1);
    socket.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
  }

  public String receive() throws IOException {
    DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
    socket.receive(packet);
    return new String(buffer, 0, packet.getLength(), StandardCharsets.ISO_8859_1);
  }

  public String ask(String command) throws IOException {
    for (int i = 1; i < tries; i++) {
      try {
        send(command);
        return receive();
      } catch (SocketTimeoutException e) {
        sentAgain++;
      }
    }
    send(command);
    return receive();
  }

  /** How many commands it has sent again. */
  public int sentAgain() {
    return sentAgain;
  }

  /** Asks, and complains if the answer is another one. */
  public void expect(String command, String reply) throws IOException {
    String answer = ask(command);
    if (!answer.equals(reply)) {
      throw new IOException("`" + command + "` was answered `" + answer + "`");
    }
  }

  int localPort() {
    return socket.getLocalPort();
  }

  @Override
  public void close() {
    socket.close();
  }
}
