package tellosimulator.benchmark;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketTimeoutException;

/** Where an operator program takes a drone's video; counts pictures by their datagrams. */
final class VideoSocket implements AutoCloseable {

  private static final int FULL = 1460;
  private static final int PATIENCE_MS = 10_000;
  private static final int LARGEST_PARAMETERS = 64;

  private final DatagramSocket socket;
  private final DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
  private boolean inside;

  VideoSocket() throws IOException {
    socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    socket.setReceiveBufferSize(1 << 22);
    socket.setSoTimeout(PATIENCE_MS);
  }

  int port() {
    return socket.getLocalPort();
  }

  /** Waits for the first datagram of a picture at which decoding can begin. */
  void awaitKeyPicture() throws IOException {
    int type = 0;
    while (type != 5) {
      type = receive() ? packet.getData()[4] & 0x1f : 0;
    }
  }

  /** Waits for the last datagram of a picture. */
  void awaitPicture() throws IOException {
    int type = 7;
    while (type == 7 || type == 8) {
      receive();
      type = packet.getLength() < LARGEST_PARAMETERS ? packet.getData()[4] & 0x1f : 0;
      while (packet.getLength() == FULL) {
        receive();
      }
    }
  }

  /** How many pictures come until a moment on the clock of {@link System#nanoTime}. */
  int picturesUntil(long end) throws IOException {
    int pictures = 0;
    while (System.nanoTime() < end) {
      try {
        awaitPicture();
        pictures++;
      } catch (SocketTimeoutException e) {
        return pictures;
      }
    }
    return pictures;
  }

  /** Whether the datagram that came is the first of a NAL unit. */
  private boolean receive() throws IOException {
    socket.receive(packet);
    boolean first = !inside;
    inside = packet.getLength() == FULL;
    return first;
  }

  @Override
  public void close() {
    socket.close();
  }
}
