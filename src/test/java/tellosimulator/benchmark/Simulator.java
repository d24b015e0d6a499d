package tellosimulator.benchmark;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The runnable jar in a process of its own, as users run it. */
final class Simulator implements AutoCloseable {

  private static final Pattern PORT = Pattern.compile("drone \\d+ at [0-9.]+:(\\d+)");

  private final Process process;
  private final double startSeconds;
  private final List<Integer> ports = new ArrayList<>();

  /** Starts it and waits until it is ready. */
  Simulator(String... options) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-jar", System.getProperty("simulator.jar"), "--headless"));
    command.addAll(List.of(options));
    long start = System.nanoTime();
    process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    BufferedReader output =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    String ready = output.readLine();
    startSeconds = (System.nanoTime() - start) * 1e-9;
    if (ready == null || !ready.startsWith("ready")) {
      throw new IOException("the simulator did not start: " + ready);
    }
    Matcher matcher = PORT.matcher(ready);
    while (matcher.find()) {
      ports.add(Integer.parseInt(matcher.group(1)));
    }
  }

  /** From the start of the process to its first line [s]. */
  double startSeconds() {
    return startSeconds;
  }

  /** The port of a drone at 127.0.0.1. */
  int port(int drone) {
    return ports.get(drone - 1);
  }

  /** Resident memory [MB]. */
  double residentMegabytes() {
    try {
      Process ps = new ProcessBuilder("ps", "-o", "rss=", "-p", "" + process.pid()).start();
      try (BufferedReader lines =
          new BufferedReader(new InputStreamReader(ps.getInputStream(), StandardCharsets.UTF_8))) {
        return Long.parseLong(lines.readLine().strip()) / 1024.0;
      }
    } catch (IOException e) {
      throw new UncheckedIOException("ps cannot be run", e);
    }
  }

  @Override
  public void close() {
    process.destroy();
    process.onExit().join();
  }
}
