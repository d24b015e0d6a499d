package tellosimulator.benchmark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;

/** What an operator program sees of the video of the runnable jar on the same machine. */
final class StreamBenchmark {

  private static final int STARTS = 7;
  private static final int DRONES = 4;

  private StreamBenchmark() {}

  static List<Measurement> all(double minutes) throws IOException {
    List<Measurement> rows = new ArrayList<>();
    rows.addAll(firstPictures());
    rows.add(LatencyBenchmark.latency());
    rows.addAll(oneDrone(minutes));
    rows.addAll(fourDrones());
    return rows;
  }

  /** From the first {@code streamon} after {@code ready} to a picture that can be decoded. */
  private static List<Measurement> firstPictures() throws IOException {
    return List.of(
        Measurement.atMost(
            "From the first `streamon` right after `ready` to the first byte of an IDR, median of "
                + STARTS,
            100,
            firstPicture(List.of(), List.of())),
        Measurement.atMost(
            "… in scenario `slalom`",
            100,
            firstPicture(List.of("--scenario", "slalom"), List.of())),
        Measurement.beside(
            "… after `setresolution low`, for which no picture was made in advance",
            String.format(
                Locale.ROOT,
                "%.1f ms",
                firstPicture(List.of("--profile", "tt"), List.of("setresolution low")))));
  }

  /**
   * The median of several starts [ms].
   *
   * @param before what the operator commands before it asks for pictures
   */
  private static double firstPicture(List<String> options, List<String> before) throws IOException {
    List<Double> times = new ArrayList<>();
    for (int i = 0; i < STARTS; i++) {
      try (VideoSocket video = new VideoSocket();
          Simulator simulator = new Simulator(options(video, options));
          Operator operator = new Operator(simulator.port(1))) {
        operator.expect("command", "ok");
        for (String command : before) {
          operator.expect(command, "ok");
        }
        long asked = System.nanoTime();
        operator.send("streamon");
        video.awaitKeyPicture();
        times.add((System.nanoTime() - asked) * 1e-6);
      }
    }
    return new Statistics(times).median();
  }

  private static String[] options(VideoSocket video, List<String> more) {
    List<String> all = new ArrayList<>(List.of("--command-port", "0"));
    all.addAll(List.of("--video-port", "" + video.port()));
    all.addAll(more);
    return all.toArray(String[]::new);
  }

  private static List<Measurement> oneDrone(double minutes) throws IOException {
    try (VideoSocket video = new VideoSocket();
        Simulator simulator =
            new Simulator("--command-port", "0", "--video-port", "" + video.port());
        Operator operator = new Operator(simulator.port(1));
        Circling circling = new Circling(simulator.port(1))) {
      circling.startWithFilm(operator, video);
      double cpu = simulator.figures().processorSeconds();
      long begun = System.nanoTime();
      int pictures = video.picturesUntil(begun + (long) (minutes * 60e9));
      double seconds = (System.nanoTime() - begun) * 1e-9;
      return List.of(
          pace(
              String.format(
                  Locale.ROOT, "One drone films headless for %.0f minutes in flight", minutes),
              30,
              pictures / seconds),
          cores("… processors used", 1, (simulator.figures().processorSeconds() - cpu) / seconds));
    }
  }

  /** Four drones of profile tt, each told to film 15 pictures a second. */
  private static List<Measurement> fourDrones() throws IOException {
    List<VideoSocket> sockets = new ArrayList<>();
    for (int i = 0; i < DRONES; i++) {
      sockets.add(new VideoSocket());
    }
    String ports =
        sockets.stream().map(socket -> "" + socket.port()).collect(Collectors.joining(","));
    try (Simulator simulator =
        new Simulator(
            "--command-port",
            "0",
            "--drones",
            "" + DRONES,
            "--port-per-drone",
            "--bind",
            "127.0.0.1",
            "--profile",
            "tt",
            "--video-port",
            ports)) {
      List<Circling> circling = new ArrayList<>();
      for (int drone = 1; drone <= DRONES; drone++) {
        circling.add(begin(simulator.port(drone)));
      }
      long begun = System.nanoTime() + 5_000_000_000L; // until all run steadily
      sockets.forEach(socket -> picturesUntil(socket, begun));
      double cpu = simulator.figures().processorSeconds();
      long end = begun + 60_000_000_000L;
      List<CompletableFuture<Integer>> counts =
          sockets.stream()
              .map(socket -> CompletableFuture.supplyAsync(() -> picturesUntil(socket, end)))
              .toList();
      double slowest = counts.stream().mapToInt(CompletableFuture::join).min().orElse(0) / 60.0;
      double used = (simulator.figures().processorSeconds() - cpu) / 60;
      circling.forEach(Circling::close);
      return List.of(
          pace("Four drones film headless for a minute, the slowest of them", 15, slowest),
          cores("… processors used", 2, used));
    } finally {
      sockets.forEach(VideoSocket::close);
    }
  }

  private static Circling begin(int port) throws IOException {
    try (Operator operator = new Operator(port)) {
      operator.expect("command", "ok");
      operator.expect("takeoff", "ok");
      operator.expect("setfps middle", "ok");
      operator.expect("streamon", "ok");
    }
    Circling circling = new Circling(port);
    circling.start();
    return circling;
  }

  private static int picturesUntil(VideoSocket socket, long end) {
    try {
      return socket.picturesUntil(end);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A pace counts as reached with a hundredth less: the first and last picture are cut off. */
  private static Measurement pace(String what, int target, double measured) {
    return new Measurement(
        what,
        target + " pictures/s",
        String.format(Locale.ROOT, "%.2f pictures/s", measured),
        measured >= target * 0.99);
  }

  private static Measurement cores(String what, int target, double measured) {
    return new Measurement(
        what,
        "at most " + target,
        String.format(Locale.ROOT, "%.2f", measured),
        measured <= target);
  }
}
