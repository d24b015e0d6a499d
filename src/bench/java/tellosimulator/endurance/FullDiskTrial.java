package tellosimulator.endurance;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;
import tellosimulator.files.TemporaryFolder;

/** A flight with film is recorded onto a disk of 1 MB, which is full before the flight is over. */
final class FullDiskTrial {

  /** So that a user may mount something: for himself alone, and gone when he ends. */
  private static final List<String> ANYBODY =
      List.of("unshare", "--user", "--map-root-user", "--mount");

  /** Stays until its input ends, and with it what is mounted. */
  private static final String KEEPER =
      "mount -t tmpfs -o size=1m none \"$1\" && echo kept; exec cat";

  private static final double PATIENCE_SECONDS = 60;

  /** On a machine that is so busy that it films little, 1 MB takes a while. */
  private static final double FILLING_SECONDS = 180;

  /** What the recorder says of a file, and of the recording as a whole. */
  private static final String ENDED = " ended, because it cannot be written: ";

  /** FramePipeline and rest are written by two threads, either of which may be the first. */
  private static final int MOST_SENTENCES = 2;

  private FullDiskTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    try (TemporaryFolder folder = TemporaryFolder.create("disk")) {
      Path disk = Files.createDirectory(folder.path().resolve("full"));
      List<String> command = new ArrayList<>(ANYBODY);
      command.addAll(List.of("sh", "-c", KEEPER, "sh", disk.toString()));
      try (Program keeper = Host.HERE.start(command)) {
        Optional<String> obstacle = obstacle(keeper);
        return obstacle.isPresent()
            ? List.of(Measurement.beside("Disk that is full", "not measured: " + obstacle.get()))
            : fly(inside(keeper), disk, folder.path().resolve("report.html"));
      }
    }
  }

  private static Optional<String> obstacle(Program keeper) {
    try {
      keeper.await("kept", PATIENCE_SECONDS);
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  /** This machine, with the disk in its place. */
  private static Host inside(Program keeper) {
    return new Host(
        List.of(
            "nsenter",
            "--target",
            "" + keeper.process().pid(),
            "--user",
            "--mount",
            "--preserve-credentials"),
        Host.HERE.address());
  }

  private static List<Measurement> fly(Host host, Path disk, Path report) throws IOException {
    List<Measurement> rows = new ArrayList<>();
    try (DatagramSocket video = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        SimulatorProcess simulator =
            SimulatorProcess.start(
                host,
                List.of(),
                "--command-port",
                "0",
                "--video-port",
                "" + video.getLocalPort(),
                "--record",
                disk.toString())) {
      try (Operator operator = new Operator(simulator.drone(1).getPort())) {
        operator.expect("command", "ok");
        operator.expect("streamon", "ok");
        flyUntilFull(simulator, operator);
        List<String> told = told(simulator);
        told.forEach(System.out::println);
        rows.add(
            new Measurement(
                "Disk of 1 MB for a flight with film: it is told that it is full",
                "in a sentence, or one for the film and one for the rest",
                told.size() + " sentences",
                !told.isEmpty() && told.size() <= MOST_SENTENCES));
      }
      rows.add(LeakedInternals.row("… log", simulator));
      rows.add(Health.row("… after the flight, with landing", simulator));
    }
    rows.addAll(read(host, disk, report));
    return rows;
  }

  /** Each command must be answered as ever, before and after. */
  private static void flyUntilFull(SimulatorProcess simulator, Operator operator)
      throws IOException {
    operator.expect("takeoff", "ok");
    long begun = System.nanoTime();
    while (told(simulator).isEmpty() && System.nanoTime() - begun < FILLING_SECONDS * 1e9) {
      operator.expect("cw 180", "ok");
    }
    operator.expect("forward 50", "ok");
    operator.expect("back 50", "ok");
    operator.expect("land", "ok");
  }

  private static List<String> told(SimulatorProcess simulator) throws IOException {
    return simulator.program().log().lines().filter(line -> line.contains(ENDED)).toList();
  }

  private static List<Measurement> read(Host host, Path disk, Path report) throws IOException {
    try (Program list = host.start(List.of("ls", disk.toString()))) {
      List<String> folders = list.rest(PATIENCE_SECONDS);
      if (folders.size() != 1) {
        return List.of(new Measurement("… recordings", "1", "" + folders.size(), false));
      }
      Path folder = disk.resolve(folders.get(0));
      try (Program size = host.start(List.of("du", "-k", folder.toString()));
          Program reporting =
              host.start(
                  SimulatorProcess.command(
                      List.of(), "report", folder.toString(), "--output", report.toString()))) {
        int code = reporting.awaitExit(PATIENCE_SECONDS);
        boolean readable = code == 0 && Files.size(report) > 0;
        return List.of(
            Measurement.beside("… of the recording is left", kilobytes(size) + " kB"),
            new Measurement(
                "… a report of what is left",
                "is made",
                readable ? "is made" : "exit code " + code + ": " + reporting.errors(),
                readable));
      }
    }
  }

  private static String kilobytes(Program size) throws IOException {
    String line = size.rest(PATIENCE_SECONDS).get(0);
    return line.substring(0, line.indexOf('\t'));
  }
}
