package tellosimulator.export;

import java.io.IOException;
import java.io.OutputStream;
import java.net.Inet4Address;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Optional;
import tellosimulator.json.JsonRecords;
import tellosimulator.recording.RecordedDatagram;
import tellosimulator.recording.RecordedRun;

/**
 * Exports the datagrams of a recording as a capture file that Wireshark and tcpdump read. For video
 * datagrams, the file contains only the headers, because the payload is not recorded. Not
 * thread-safe.
 *
 * <p>Sources: libpcap's pcap-savefile page for the file format; RFC 791 and RFC 768 for the
 * headers.
 */
final class PcapExport {

  private static final int MAGIC = 0xa1b2c3d4;
  private static final short MAJOR = 2;
  private static final short MINOR = 4;
  private static final int LONGEST = 65_535;

  /** Link type LINKTYPE_IPV4: each packet begins with the IPv4 header. */
  private static final int LINK_TYPE = 228;

  private static final int FILE_HEADER = 24;
  private static final int RECORD_HEADER = 16;
  private static final int IP_HEADER = 20;
  private static final int UDP_HEADER = 8;

  private static final int TTL = 64;
  private static final int UDP = 17;

  private final OutputStream out;
  private final ExportFormat.Clock clock;
  private boolean empty = true;

  private PcapExport(OutputStream out, RecordedRun run) {
    this.out = out;
    this.clock = new ExportFormat.Clock(run);
  }

  /**
   * Writes the file.
   *
   * @throws IOException if the recording cannot be read, or the file cannot be written
   */
  static void write(Path folder, RecordedRun run, OutputStream out) throws IOException {
    out.write(
        ByteBuffer.allocate(FILE_HEADER)
            .putInt(MAGIC)
            .putShort(MAJOR)
            .putShort(MINOR)
            .putInt(0)
            .putInt(0)
            .putInt(LONGEST)
            .putInt(LINK_TYPE)
            .array());
    PcapExport export = new PcapExport(out, run);
    RecordedDatagram.readAll(folder, export::add);
    if (export.empty) {
      throw new IOException("no datagram of it is known");
    }
  }

  private void add(RecordedDatagram datagram) throws IOException {
    Optional<InetSocketAddress> from = place(datagram.from());
    Optional<InetSocketAddress> to = place(datagram.to());
    if (from.isPresent() && to.isPresent() && datagram.isPossible()) {
      add(datagram, from.get(), to.get());
    }
  }

  private void add(RecordedDatagram datagram, InetSocketAddress from, InetSocketAddress to)
      throws IOException {
    byte[] payload = datagram.payload();
    int kept = IP_HEADER + UDP_HEADER + payload.length;
    int whole = IP_HEADER + UDP_HEADER + datagram.length();
    long micros = clock.micros(datagram.time());
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
        .putShort((short) (whole - IP_HEADER))
        .putShort((short) 0); // no checksum
    record.put(payload);
    out.write(record.array());
    empty = false;
  }

  /** Parses an address with a port; empty if the text is not an IPv4 address with a port. */
  private static Optional<InetSocketAddress> place(String text) {
    try {
      return Optional.of(JsonRecords.socketAddress(text))
          .filter(address -> address.getAddress() instanceof Inet4Address);
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static void putIpHeader(
      ByteBuffer record, InetSocketAddress from, InetSocketAddress to, int length) {
    ByteBuffer header = ByteBuffer.allocate(IP_HEADER);
    header
        .put((byte) 0x45) // version 4, header of five words
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
