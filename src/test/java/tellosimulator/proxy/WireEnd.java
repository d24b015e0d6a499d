package tellosimulator.proxy;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** A blocking socket of a test, used as an operator program or a drone. */
final class WireEnd implements AutoCloseable {

  private static final int PATIENCE_MS = 20_000;

  private final DatagramSocket socket;
  private InetSocketAddress sender;

  WireEnd(InetSocketAddress address) throws IOException {
    socket = new DatagramSocket(address);
    socket.setSoTimeout(PATIENCE_MS);
    socket.setReceiveBufferSize(1 << 20);
  }

  /** Opens a socket on a free port of loopback. */
  static WireEnd loopback() throws IOException {
    return new WireEnd(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
  }

  InetSocketAddress address() {
    return (InetSocketAddress) socket.getLocalSocketAddress();
  }

  int port() {
    return socket.getLocalPort();
  }

  void send(byte[] bytes, InetSocketAddress to) throws IOException {
    socket.send(new DatagramPacket(bytes, bytes.length, to));
  }

  void send(String text, InetSocketAddress to) throws IOException {
    send(text.getBytes(StandardCharsets.ISO_8859_1), to);
  }

  byte[] receiveBytes() throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[65_535], 65_535);
    socket.receive(packet);
    sender = (InetSocketAddress) packet.getSocketAddress();
    return Arrays.copyOf(packet.getData(), packet.getLength());
  }

  String receive() throws IOException {
    return new String(receiveBytes(), StandardCharsets.ISO_8859_1);
  }

  /** The sender of the last datagram. */
  InetSocketAddress sender() {
    return sender;
  }

  /** Returns whether nothing has arrived until now. */
  boolean isSilent() throws IOException {
    socket.setSoTimeout(1);
    try {
      receiveBytes();
      return false;
    } catch (SocketTimeoutException e) {
      return true;
    } finally {
      socket.setSoTimeout(PATIENCE_MS);
    }
  }

  @Override
  public void close() {
    socket.close();
  }
}
