package tellosimulator.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Locale;
import tellosimulator.files.AtomicFile;
import tellosimulator.recording.RecordedFlight;

/** The formats of other tools in which a recording can be written. */
public enum ExportFormat {
  /** A capture file of what was on the wire, for Wireshark and tcpdump. */
  PCAP {
    @Override
    void write(Path folder, RecordedFlight flight, OutputStream out) throws IOException {
      PcapExport.write(folder, flight.run(), out);
    }
  },
  /** Channels of messages in JSON, for Foxglove and PlotJuggler. */
  MCAP {
    @Override
    void write(Path folder, RecordedFlight flight, OutputStream out) throws IOException {
      McapExport.write(folder, flight, out);
    }
  };

  /** The word that chooses it, and how its files end. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  abstract void write(Path folder, RecordedFlight flight, OutputStream out) throws IOException;

  /**
   * Writes a recording.
   *
   * @param folder in which the recording is
   * @param flight the same, as it was read
   * @throws IOException if the recording cannot be read, or the file cannot be written
   */
  public void export(Path folder, RecordedFlight flight, Path file) throws IOException {
    AtomicFile.write(file, out -> write(folder, flight, out));
  }
}
