package tellosimulator.export;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Locale;
import tellosimulator.files.AtomicFile;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedRun;
import tellosimulator.time.WallTime;

/** The formats in which a recording can be exported. */
public enum ExportFormat {
  /** A capture file of the datagrams, for Wireshark and tcpdump. */
  PCAP {
    @Override
    void write(Path folder, RecordedFlight flight, OutputStream out) throws IOException {
      PcapExport.write(folder, flight.run(), out);
    }
  },
  /** Channels of JSON messages, for Foxglove and PlotJuggler. */
  MCAP {
    @Override
    void write(Path folder, RecordedFlight flight, OutputStream out) throws IOException {
      McapExport.write(folder, flight, out);
    }
  };

  /** Returns the word that selects the format. It is also the file extension. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  abstract void write(Path folder, RecordedFlight flight, OutputStream out) throws IOException;

  /**
   * Writes a recording to a file.
   *
   * @param folder the recording's folder
   * @param flight the recording as read from that folder
   * @throws IOException if the recording cannot be read, or the file cannot be written
   */
  public void export(Path folder, RecordedFlight flight, Path file) throws IOException {
    AtomicFile.write(file, out -> write(folder, flight, out));
  }

  /**
   * The clock of exported files. It shows the wall-clock time of the takeoff plus the simulated
   * time since then, so that a flight at maximum speed looks like one in real time. If the
   * wall-clock time of the takeoff is unknown or impossible, the clock counts from 1970. Immutable.
   */
  static final class Clock {

    private static final double MICROS = 1e6;

    /** The latest time that a capture file can hold [µs]; the format stores seconds in 32 bits. */
    private static final double LAST = 0xffff_ffffL * MICROS;

    private final double origin;

    Clock(RecordedRun run) {
      double begun = WallTime.micros(run.begun()).orElse(0);
      origin = (begun >= 0 && begun <= LAST ? begun : 0) - run.started() * MICROS;
    }

    /**
     * Converts a time.
     *
     * @param time the time since the simulation began [simulated s]
     * @return the time since 1970 [µs]
     */
    long micros(double time) {
      return Math.round(Math.max(0, Math.min(LAST, origin + time * MICROS)));
    }
  }
}
