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

/** What an operator program does with video: takes datagrams, puts them together and decodes. */
public final class VideoReceiver implements AutoCloseable {

  /** Longest time until the next datagram [ms]. */
  private static final int PATIENCE_MS = 60_000;

  /** A datagram's length by which a client knows that the NAL unit goes on. */
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

  /** Where the latest datagram came from. */
  InetSocketAddress sender() {
    return sender;
  }

  /** The lengths of all datagrams so far. */
  List<Integer> lengths() {
    return List.copyOf(lengths);
  }

  /** The next NAL unit with its start code. */
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
   * Takes what is on its way, until for as long as ten pictures nothing comes.
   *
   * @return whether that happens; false if the stream goes on
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

  /** What kind of NAL unit it is. */
  public static int type(byte[] unit) {
    return unit[4] & 0x1f;
  }

  /** Leaves out everything before the next sequence parameters, which it returns. */
  public byte[] nextSps() throws IOException {
    byte[] unit = unit();
    while (type(unit) != SPS) {
      unit = unit();
    }
    return unit;
  }

  /** Decodes the next picture that is complete: with its parameters if it has some. */
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

  /** Decodes pictures until one begins anew, which it returns. */
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
