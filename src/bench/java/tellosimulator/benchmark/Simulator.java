package tellosimulator.benchmark;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The program in a process of its own, as users run it: the runnable jar, or the app image. */
final class Simulator implements AutoCloseable {

  private static final Pattern PORT = Pattern.compile("drone \\d+ at [0-9.]+:(\\d+)");
  private static final Pattern FRAMES = Pattern.compile("([0-9.]+) frames a second");
  private static final String USABLE = "The window can be used";

  private final Process process;
  private final ProcessFigures figures;
  private final long start;
  private final double startSeconds;
  private final List<Integer> ports = new ArrayList<>();
  private final List<Double> frameRates = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Double> usableSeconds = new CompletableFuture<>();

  /** Starts it without a window, and waits until it is ready. */
  Simulator(String... options) throws IOException {
    this(jar(), "--headless", List.of(options), settings());
  }

  private Simulator(List<String> program, String way, List<String> options, Path settings)
      throws IOException {
    List<String> command = new ArrayList<>(program);
    command.add(way);
    command.addAll(options);
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("XDG_CONFIG_HOME", settings.toString());
    builder.environment().put("XDG_DATA_HOME", settings.toString());
    start = System.nanoTime();
    process = builder.start();
    figures = new ProcessFigures(process);
    Thread errors = new Thread(this::readErrors, "errors");
    errors.setDaemon(true);
    errors.start();
    BufferedReader output =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    String ready = output.readLine();
    startSeconds = secondsSinceStart();
    if (ready == null || !ready.startsWith("ready")) {
      throw new IOException("the simulator did not start: " + ready);
    }
    Matcher matcher = PORT.matcher(ready);
    while (matcher.find()) {
      ports.add(Integer.parseInt(matcher.group(1)));
    }
  }

  /** An empty folder: whoever starts with it starts for the first time. */
  private static Path settings() throws IOException {
    return Files.createTempDirectory("settings");
  }

  private static List<String> jar() {
    return List.of(ProcessFigures.tool("java"), "-jar", System.getProperty("simulator.jar"));
  }

  /** Starts the app image without a window, and waits until it is ready. */
  static Simulator ofImage(Path launcher, String... options) throws IOException {
    return new Simulator(List.of(launcher.toString()), "--headless", List.of(options), settings());
  }

  /** Starts it with a window as a first user sees it, and waits until that can be used. */
  static Simulator inFirstWindow(String... options) throws IOException {
    return inWindow(settings(), options);
  }

  /** The same as it starts later, when the gallery does not lie over the room. */
  static Simulator inWindow(String... options) throws IOException {
    Path settings = settings();
    Path file = settings.resolve("tello-simulator").resolve("settings.properties");
    Files.createDirectories(file.getParent());
    Files.writeString(file, "show.inset=false\n");
    return inWindow(settings, options);
  }

  private static Simulator inWindow(Path settings, String... options) throws IOException {
    List<String> all = new ArrayList<>(List.of("--log-level", "debug"));
    all.addAll(List.of(options));
    Simulator simulator = new Simulator(jar(), "--on", all, settings);
    simulator.usableSeconds();
    return simulator;
  }

  /** Starts it as a proxy for a drone of this machine, and waits until it is ready. */
  static Simulator asProxy(int dronePort, String recordings) throws IOException {
    return new Simulator(
        jar(),
        "proxy",
        List.of(
            "--command-port",
            "0",
            "--drone-state-port",
            "0",
            "--drone-video-port",
            "0",
            "--drone",
            "127.0.0.1:" + dronePort,
            "--record",
            recordings),
        settings());
  }

  private void readErrors() {
    try {
      lines(process.getErrorStream(), this::note);
    } catch (UncheckedIOException e) {
      usableSeconds.completeExceptionally(e); // the process has ended
    }
  }

  private void note(String line) {
    if (line.contains(USABLE)) {
      usableSeconds.complete(secondsSinceStart());
    }
    Matcher matcher = FRAMES.matcher(line);
    if (matcher.find()) {
      frameRates.add(Double.parseDouble(matcher.group(1)));
    }
  }

  private double secondsSinceStart() {
    return (System.nanoTime() - start) * 1e-9;
  }

  /** From the start of the process to its first line [s]. */
  double startSeconds() {
    return startSeconds;
  }

  /** From the start of the process to a window that can be used [s]. */
  double usableSeconds() {
    return usableSeconds.join();
  }

  /** What the window has shown in each ten seconds until now [frames/s]. */
  List<Double> frameRates() {
    return List.copyOf(frameRates);
  }

  /** The port of a drone at 127.0.0.1. */
  int port(int drone) {
    return ports.get(drone - 1);
  }

  /** What it costs. */
  ProcessFigures figures() {
    return figures;
  }

  private static void lines(InputStream stream, Consumer<String> taker) {
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8))) {
      lines.lines().forEach(taker);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() {
    process.destroy();
    process.onExit().join();
  }
}
