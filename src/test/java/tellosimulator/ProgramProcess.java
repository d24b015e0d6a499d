package tellosimulator;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import tellosimulator.testing.Jvm;
import tellosimulator.testing.Tool;

/** The program in its own process, with drone 1 on a free port of 127.0.0.1. */
final class ProgramProcess implements AutoCloseable {

  static final int PATIENCE_SECONDS = 240;

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private final Process process;
  private final BufferedReader printed;
  private final Path errors;

  private ProgramProcess(Process process, Path errors) {
    this.process = process;
    this.errors = errors;
    printed = process.inputReader(StandardCharsets.UTF_8);
  }

  /**
   * Starts the program.
   *
   * @param hidden an environment variable that is removed for it
   */
  static ProgramProcess start(Class<?> main, String options, String hidden) throws IOException {
    return start(main, options, hidden, "-XX:+IgnoreUnrecognizedVMOptions");
  }

  /**
   * Starts the program.
   *
   * @param hidden an environment variable that is removed for it
   * @param heap a JVM option
   */
  static ProgramProcess start(Class<?> main, String options, String hidden, String heap)
      throws IOException {
    List<String> words = new ArrayList<>(List.of("--bind", "127.0.0.1", "--command-port", "0"));
    words.addAll(List.of(options.split(" ", -1)));
    if (!options.contains("--state-port")) {
      words.addAll(List.of("--state-port", "9"));
    }
    return launch(main, words, hidden, heap);
  }

  private static ProgramProcess launch(
      Class<?> main, List<String> words, String hidden, String heap) throws IOException {
    Path errors = Files.createTempFile("program", ".err");
    String[] arguments = words.toArray(String[]::new);
    List<String> command =
        main == Main.class ? Jvm.commandOfProgram(main, arguments) : Jvm.commandOf(main, arguments);
    List<String> options =
        List.of(
            "-XX:+IgnoreUnrecognizedVMOptions",
            heap,
            "--enable-native-access=ALL-UNNAMED",
            "--sun-misc-unsafe-memory-access=allow");
    command.addAll(1, options);
    ProcessBuilder builder = Jvm.process(command).redirectError(errors.toFile());
    builder.environment().remove(hidden);
    String nothing = Path.of("target", "no-settings").toAbsolutePath().toString();
    List.of("XDG_CONFIG_HOME", "XDG_DATA_HOME", "APPDATA", "LOCALAPPDATA")
        .forEach(variable -> builder.environment().put(variable, nothing));
    return new ProgramProcess(builder.start(), errors);
  }

  /** Starts the program without a window. */
  static ProgramProcess headless() throws IOException {
    return start(Main.class, "--headless", "");
  }

  /**
   * Starts the program with a window on a recorded flight.
   *
   * @param hidden an environment variable that is removed for it
   */
  static ProgramProcess replay(Path recording, String hidden) throws IOException {
    return launch(
        Main.class,
        List.of("--replay", recording.toString()),
        hidden,
        "-XX:+IgnoreUnrecognizedVMOptions");
  }

  /** Starts the program with words, and nothing else. */
  static ProgramProcess with(String words) throws IOException {
    return launch(
        Main.class, List.of(words.split(" ", -1)), "", "-XX:+IgnoreUnrecognizedVMOptions");
  }

  /** Starts the program as a proxy for a drone of this machine. */
  static ProgramProcess proxy(int dronePort, Path recordings) throws IOException {
    String options =
        "proxy --command-port 0 --drone-state-port 0 --drone-video-port 0 --drone 127.0.0.1:";
    List<String> words = new ArrayList<>(List.of((options + dronePort).split(" ", -1)));
    words.addAll(List.of("--record", recordings.toString()));
    return launch(Main.class, words, "", "-XX:+IgnoreUnrecognizedVMOptions");
  }

  /** Starts the program with its own operator program. */
  static ProgramProcess run(List<String> words) throws IOException {
    List<String> all = new ArrayList<>(List.of("run", "--headless", "--log-level", "error"));
    all.add("--");
    all.addAll(words);
    return launch(Main.class, all, "", "-XX:+IgnoreUnrecognizedVMOptions");
  }

  /** Waits for the ready line, and returns drone 1's port. */
  int port() throws IOException {
    String ready = String.valueOf(printed.readLine());
    if (!ready.matches("ready: drone 1 at 127\\.0\\.0\\.1:[0-9]+")) {
      throw new AssertionError("not ready: " + ready + "\n" + errors());
    }
    return Integer.parseInt(ready.replaceAll(".*:", ""));
  }

  /** Returns the next line that it prints. */
  String line() throws IOException {
    return String.valueOf(printed.readLine());
  }

  /** Types a text, and ends the input. */
  void type(String text) throws IOException {
    process.outputWriter(StandardCharsets.UTF_8).append(text).close();
  }

  /** Interrupts the program, as Ctrl-C does. */
  void interrupt() throws IOException, InterruptedException {
    Tool.SH.command("-c", "kill -s INT " + process.pid()).start().waitFor();
  }

  /** Asks the program to end, as {@code kill} does; its remaining output can be read. */
  void terminate() {
    process.toHandle().destroy(); // Process.destroy would close the streams
  }

  /** Kills the program, as {@code kill -9} does. */
  void kill() throws InterruptedException {
    process.destroyForcibly();
    process.waitFor();
  }

  Stream<ProcessHandle> descendants() {
    return process.descendants();
  }

  boolean isAlive() {
    return process.isAlive();
  }

  /** Waits until the program has exited. */
  int exitCode() throws InterruptedException {
    if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
      throw new AssertionError("it does not end");
    }
    return process.exitValue();
  }

  /** Returns its output to standard error until now. */
  String errors() throws IOException {
    return Files.readString(errors);
  }

  @Override
  public void close() throws IOException {
    process.destroyForcibly();
    printed.close();
    Files.deleteIfExists(errors);
  }

  /** Sends a command and waits for the reply. */
  static String ask(String text, int port) throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(PATIENCE_SECONDS * 1000);
      byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
      socket.send(new DatagramPacket(bytes, bytes.length, LOOPBACK, port));
      DatagramPacket reply = new DatagramPacket(new byte[1500], 1500);
      socket.receive(reply);
      return new String(reply.getData(), 0, reply.getLength(), StandardCharsets.US_ASCII);
    }
  }

  static boolean isFree(int port) {
    try (DatagramSocket socket = new DatagramSocket(new InetSocketAddress(LOOPBACK, port))) {
      return socket.isBound();
    } catch (SocketException e) {
      return false;
    }
  }
}
