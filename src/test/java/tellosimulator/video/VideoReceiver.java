package tellosimulator.video;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jcodec.codecs.h264.H264Decoder;
import org.jcodec.common.model.Picture;

/** The video part of an operator program: receives datagrams, reassembles and decodes them. */
public final class VideoReceiver implements AutoCloseable {

  /** Maximum time until the next datagram [ms]. */
  private static final int PATIENCE_MS = 60_000;

  /** Length of a datagram after which a NAL unit continues. */
  private static final int FULL = 1460;

  public static final int IDR = 5;
  static final int SPS = 7;
  static final int PPS = 8;

  private final DatagramSocket socket;
  private final H264Decoder decoder = new H264Decoder();
  private byte[][] planes = new byte[3][0];
  private InetSocketAddress sender;
  private final List<Integer> lengths = new ArrayList<>();

  private VideoReceiver(DatagramSocket socket) {
    this.socket = socket;
  }

  /**
   * Listens on loopback.
   *
   * @param port 0 for a free one
   */
  public static VideoReceiver open(int port) throws IOException {
    DatagramSocket socket =
        new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    socket.setReceiveBufferSize(1 << 20);
    socket.setSoTimeout(PATIENCE_MS);
    return new VideoReceiver(socket);
  }

  public int port() {
    return socket.getLocalPort();
  }

  /** The source of the latest datagram. */
  InetSocketAddress sender() {
    return sender;
  }

  /** The lengths of all datagrams so far. */
  List<Integer> lengths() {
    return List.copyOf(lengths);
  }

  /** Returns the next NAL unit with its start code. */
  public byte[] unit() throws IOException {
    ByteArrayOutputStream unit = new ByteArrayOutputStream();
    byte[] packet;
    do {
      packet = packet();
      unit.writeBytes(packet);
    } while (packet.length == FULL);
    return unit.toByteArray();
  }

  /**
   * Receives pending datagrams until none arrives for the duration of ten pictures.
   *
   * @return whether that happens; false if the stream continues
   */
  public boolean fallsSilent() throws IOException {
    socket.setSoTimeout(333);
    try {
      for (int i = 0; i < 1000; i++) {
        packet();
      }
      return false;
    } catch (SocketTimeoutException e) {
      return true;
    } finally {
      socket.setSoTimeout(PATIENCE_MS);
    }
  }

  /** Returns the type of a NAL unit. */
  public static int type(byte[] unit) {
    return unit[4] & 0x1f;
  }

  /** Skips everything before the next sequence parameter set, and returns the set. */
  public byte[] nextSps() throws IOException {
    byte[] unit = unit();
    while (type(unit) != SPS) {
      unit = unit();
    }
    return unit;
  }

  /** Decodes the next complete picture, with its parameter sets if it has some. */
  Picture picture() throws IOException {
    ByteArrayOutputStream access = new ByteArrayOutputStream();
    byte[] unit = unit();
    while (type(unit) == SPS || type(unit) == PPS) {
      access.writeBytes(unit);
      unit = unit();
    }
    access.writeBytes(unit);
    return decode(access.toByteArray());
  }

  /** Decodes pictures until a key picture, and returns it. */
  Picture keyPicture() throws IOException {
    ByteArrayOutputStream access = new ByteArrayOutputStream();
    access.writeBytes(nextSps());
    access.writeBytes(unit());
    access.writeBytes(unit());
    return decode(access.toByteArray());
  }

  private Picture decode(byte[] access) {
    int enough = 1024 * 1024;
    if (planes[0].length < enough) {
      planes = new byte[][] {new byte[enough], new byte[enough], new byte[enough]};
    }
    return decoder.decodeFrame(ByteBuffer.wrap(access), planes).cloneCropped();
  }

  private byte[] packet() throws IOException {
    byte[] buffer = new byte[2048];
    DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
    socket.receive(packet);
    sender = (InetSocketAddress) packet.getSocketAddress();
    lengths.add(packet.getLength());
    return Arrays.copyOf(buffer, packet.getLength());
  }

  @Override
  public void close() {
    socket.close();
  }
}
