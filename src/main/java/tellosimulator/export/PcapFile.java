package tellosimulator.export;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Writes UDP datagrams as a capture file that Wireshark and tcpdump read. For one thread.
 *
 * <p>Sources: libpcap's pcap-savefile for the file, RFC 791 and RFC 768 for the headers.
 */
final class PcapFile {

  private static final int MAGIC = 0xa1b2c3d4;
  private static final short MAJOR = 2;
  private static final short MINOR = 4;
  private static final int LONGEST = 65_535;

  /** Packets begin with the header of IPv4: LINKTYPE_IPV4. */
  private static final int LINK_TYPE = 228;

  private static final int FILE_HEADER = 24;
  private static final int RECORD_HEADER = 16;
  private static final int IP_HEADER = 20;
  private static final int UDP_HEADER = 8;

  private static final int TTL = 64;
  private static final int UDP = 17;

  private final OutputStream out;
  private long datagrams;

  /** Begins a file. */
  PcapFile(OutputStream out) throws IOException {
    this.out = out;
    out.write(
        ByteBuffer.allocate(FILE_HEADER)
            .order(ByteOrder.BIG_ENDIAN)
            .putInt(MAGIC)
            .putShort(MAJOR)
            .putShort(MINOR)
            .putInt(0)
            .putInt(0)
            .putInt(LONGEST)
            .putInt(LINK_TYPE)
            .array());
  }

  /**
   * Adds a datagram.
   *
   * @param micros when, since 1970
   * @param payload what is kept of it
   * @param length how long the payload was
   */
  void add(long micros, InetSocketAddress from, InetSocketAddress to, byte[] payload, int length)
      throws IOException {
    int kept = IP_HEADER + UDP_HEADER + payload.length;
    int whole = IP_HEADER + UDP_HEADER + length;
    ByteBuffer record = ByteBuffer.allocate(RECORD_HEADER + kept);
    record
        .putInt((int) Math.floorDiv(micros, 1_000_000L))
        .putInt((int) Math.floorMod(micros, 1_000_000L))
        .putInt(kept)
        .putInt(whole);
    putIpHeader(record, from, to, whole);
    record
        .putShort((short) from.getPort())
        .putShort((short) to.getPort())
        .putShort((short) (UDP_HEADER + length))
        .putShort((short) 0); // no checksum
    record.put(payload);
    out.write(record.array());
    datagrams++;
  }

  /** How many datagrams were added. */
  long datagrams() {
    return datagrams;
  }

  private static void putIpHeader(
      ByteBuffer record, InetSocketAddress from, InetSocketAddress to, int length) {
    ByteBuffer header = ByteBuffer.allocate(IP_HEADER);
    header
        .put((byte) 0x45) // version 4, five words
        .put((byte) 0)
        .putShort((short) length)
        .putInt(0)
        .put((byte) TTL)
        .put((byte) UDP)
        .putShort((short) 0)
        .put(from.getAddress().getAddress())
        .put(to.getAddress().getAddress());
    int sum = 0;
    for (int i = 0; i < IP_HEADER; i += 2) {
      sum += header.getShort(i) & 0xffff;
    }
    sum = (sum & 0xffff) + (sum >> 16);
    sum = (sum & 0xffff) + (sum >> 16);
    header.putShort(10, (short) ~sum);
    record.put(header.array());
  }
}
