package tellosimulator.export;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.recording.RecordedDatagram;
import tellosimulator.recording.RecordedRun;

/**
 * The datagrams of a recording as a capture file, with the times of {@link ExportClock}. Video is
 * there with its length alone, since its bytes are not kept. For one thread.
 */
final class PcapExport {

  private static final Pattern PLACE =
      Pattern.compile("(\\d{1,3}\\.\\d{1,3}\\.\\d{1,3}\\.\\d{1,3}):(\\d{1,5})");

  private static final int LAST_PORT = 65_535;

  private final PcapFile file;
  private final ExportClock clock;

  private PcapExport(PcapFile file, RecordedRun run) {
    this.file = file;
    this.clock = new ExportClock(run);
  }

  /**
   * Writes the file.
   *
   * @throws IOException if the recording cannot be read, or the file cannot be written
   */
  static void write(Path folder, RecordedRun run, OutputStream out) throws IOException {
    PcapExport export = new PcapExport(new PcapFile(out), run);
    try {
      RecordedDatagram.readAll(folder, export::add);
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    if (export.file.datagrams() == 0) {
      throw new IOException("no datagram of it is known");
    }
  }

  private void add(RecordedDatagram datagram) {
    Optional<InetSocketAddress> from = place(datagram.from());
    Optional<InetSocketAddress> to = place(datagram.to());
    if (from.isEmpty() || to.isEmpty() || !datagram.isPossible()) {
      return;
    }
    try {
      file.add(
          clock.micros(datagram.time()),
          from.get(),
          to.get(),
          datagram.payload(),
          datagram.length());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Optional<InetSocketAddress> place(String text) {
    Matcher matcher = PLACE.matcher(text);
    if (!matcher.matches() || Integer.parseInt(matcher.group(2)) > LAST_PORT) {
      return Optional.empty();
    }
    try {
      InetAddress host = InetAddress.getByName(matcher.group(1)); // digits: nobody is asked
      return Optional.of(new InetSocketAddress(host, Integer.parseInt(matcher.group(2))));
    } catch (UnknownHostException e) {
      return Optional.empty();
    }
  }
}
