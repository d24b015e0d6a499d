package tellosimulator.endurance;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.time.Duration;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;
import tellosimulator.files.TemporaryFolder;

/**
 * The wall clock jumps an hour forward in flight, and back in the next one, as when the system sets
 * it by a server. libfaketime (Debian package of that name) stands between program and system.
 */
final class ClockTrial {

  /** Where distributions have it; MT is for programs with threads. */
  private static final List<Path> LIBRARIES =
      List.of(Path.of("/usr/lib"), Path.of("/usr/lib64"), Path.of("/usr/local/lib"));

  private static final PathMatcher LIBRARY =
      FileSystems.getDefault().getPathMatcher("glob:**/faketime/libfaketimeMT.so.1");

  private static final int DEPTH = 3;

  /** Offsets of the clock [s], as libfaketime reads them from its file. */
  private static final String RIGHT = "+0";

  private static final String HOUR_AHEAD = "+3600";

  private static final double HOUR_SECONDS = 3600;

  /** What flights may be apart, beside the hour [s]. */
  private static final double TOLERANCE_SECONDS = 300;

  private static final double WATCHED_SECONDS = 4;

  /** A flight is over when the drone has been down for 3 s. */
  private static final double OVER_SECONDS = 4;

  private static final double JUMP_SECONDS = 1;

  private static final double PATIENCE_SECONDS = 60;
  private static final Pattern BEGUN = Pattern.compile("\"begun\" ?: ?\"([^\"]+)\"");

  private final SimulatorProcess simulator;
  private final Operator operator;
  private final Arrivals states;
  private final Path offset;

  private ClockTrial(SimulatorProcess simulator, Operator operator, Arrivals states, Path offset) {
    this.simulator = simulator;
    this.operator = operator;
    this.states = states;
    this.offset = offset;
  }

  static List<Measurement> run(double minutes) throws IOException {
    Optional<Path> library = library();
    if (library.isEmpty()) {
      return List.of(
          Measurement.beside("Clock that jumps", "not measured: libfaketime is not installed"));
    }
    try (TemporaryFolder folder = TemporaryFolder.create("clock")) {
      Path offset = Files.writeString(folder.path().resolve("offset"), RIGHT);
      Path recordings = folder.path().resolve("recordings");
      List<Measurement> rows = new ArrayList<>();
      try (DatagramSocket stateSocket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
          SimulatorProcess simulator =
              SimulatorProcess.start(
                  faked(library.get(), offset),
                  List.of(),
                  "--command-port",
                  "0",
                  "--state-port",
                  "" + stateSocket.getLocalPort(),
                  "--record",
                  recordings.toString());
          Operator operator = new Operator(simulator.drone(1).getPort())) {
        operator.expect("command", "ok");
        ClockTrial trial = new ClockTrial(simulator, operator, Arrivals.at(stateSocket), offset);
        rows.addAll(trial.fly("Clock jumps an hour forward in flight", HOUR_AHEAD));
        rows.addAll(trial.fly("Clock jumps an hour back in flight", RIGHT));
        trial.fly("", RIGHT);
        rows.add(LeakedInternals.row("… log", simulator));
        rows.add(Health.row("… after that", simulator));
      }
      rows.addAll(read(recordings, folder.path()));
      return rows;
    }
  }

  private static Optional<Path> library() throws IOException {
    for (Path folder : LIBRARIES) {
      if (Files.isDirectory(folder)) {
        try (Stream<Path> files = Files.find(folder, DEPTH, (file, is) -> LIBRARY.matches(file))) {
          Optional<Path> found = files.findFirst();
          if (found.isPresent()) {
            return found;
          }
        }
      }
    }
    return Optional.empty();
  }

  /**
   * This machine, with another wall clock for a program. The monotonic clock stays the system's,
   * and waiting by it too: what is called a fix there ends each wait of the Java machine at once.
   */
  private static Host faked(Path library, Path offset) {
    return new Host(
        List.of(
            "env",
            "LD_PRELOAD=" + library,
            "FAKETIME_TIMESTAMP_FILE=" + offset,
            "FAKETIME_NO_CACHE=1",
            "FAKETIME_DONT_FAKE_MONOTONIC=1",
            "FAKETIME_FORCE_MONOTONIC_FIX=0",
            "DONT_FAKE_MONOTONIC=1"),
        Host.HERE.address());
  }

  /** A flight in which the clock is set. */
  private List<Measurement> fly(String what, String newOffset) throws IOException {
    operator.expect("takeoff", "ok");
    double before = simulator.simulatedSeconds();
    OtherLoad others = new OtherLoad();
    long begun = System.nanoTime();
    Files.writeString(offset, newOffset);
    Waiting.pass(JUMP_SECONDS);
    operator.expect("forward 50", "ok");
    Waiting.pass(WATCHED_SECONDS - (System.nanoTime() - begun) * 1e-9);
    double simulated = simulator.simulatedSeconds() - before;
    long now = System.nanoTime();
    double seconds = (now - begun) * 1e-9;
    double share = others.share();
    operator.expect("land", "ok");
    Waiting.pass(OVER_SECONDS);
    Arrivals.Figures came = states.between(begun, now);
    Measurement period = StopTrial.statePeriod(came);
    return List.of(
        OtherLoad.judged(
            new Measurement(
                what + ": simulated time",
                "does not jump",
                String.format(Locale.ROOT, "%.1f s in %.1f s", simulated, seconds),
                Math.abs(simulated - seconds) <= 1),
            share),
        OtherLoad.judged(period, share),
        OtherLoad.judged(
            Measurement.atMost("… longest time without a state line", 500, came.gapMs()), share));
  }

  /** The recordings, in the order in which they were made. */
  private static List<Measurement> read(Path recordings, Path folder) throws IOException {
    List<Path> flights;
    try (Stream<Path> files = Files.list(recordings)) {
      flights = files.sorted(ClockTrial::byAge).toList();
    }
    List<OffsetDateTime> begun = new ArrayList<>();
    int readable = 0;
    for (Path flight : flights) {
      Matcher matcher = BEGUN.matcher(Files.readString(flight.resolve("run.json")));
      if (matcher.find()) {
        begun.add(OffsetDateTime.parse(matcher.group(1)));
      }
      readable += readable(flight, folder.resolve("report.html")) ? 1 : 0;
    }
    String jumps = jumps(begun);
    return List.of(
        new Measurement(
            "… the clock, from flight to flight",
            "an hour forward, an hour back",
            jumps,
            begun.size() == 3
                && isHour(begun.get(0), begun.get(1))
                && isHour(begun.get(2), begun.get(1))),
        new Measurement(
            "… recordings of which a report is made",
            "3",
            readable + " of " + flights.size(),
            readable == 3 && flights.size() == 3));
  }

  /** By the file that is written last; the machine's own clock does not jump. */
  private static int byAge(Path one, Path other) {
    return Long.compare(
        one.resolve("run.json").toFile().lastModified(),
        other.resolve("run.json").toFile().lastModified());
  }

  private static boolean isHour(OffsetDateTime earlier, OffsetDateTime later) {
    double seconds = Duration.between(earlier, later).toMillis() * 1e-3;
    return Math.abs(seconds - HOUR_SECONDS) <= TOLERANCE_SECONDS;
  }

  private static String jumps(List<OffsetDateTime> begun) {
    List<String> jumps = new ArrayList<>();
    for (int i = 1; i < begun.size(); i++) {
      double seconds = Duration.between(begun.get(i - 1), begun.get(i)).toMillis() * 1e-3;
      jumps.add(String.format(Locale.ROOT, "%+.0f s", seconds));
    }
    return String.join(", ", jumps);
  }

  private static boolean readable(Path flight, Path report) throws IOException {
    List<String> command =
        SimulatorProcess.command(
            List.of(), "report", flight.toString(), "--output", report.toString());
    try (Program reporting = Host.HERE.start(command)) {
      int code = reporting.awaitExit(PATIENCE_SECONDS);
      if (code != 0) {
        System.out.println(reporting.errors());
      }
      return code == 0;
    }
  }
}
