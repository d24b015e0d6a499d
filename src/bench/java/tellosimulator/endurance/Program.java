package tellosimulator.endurance;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * A process that somebody talks to by lines. What it writes to standard error is kept in a file. It
 * is gone when this is closed. For one thread.
 */
final class Program implements AutoCloseable {

  /** How much of the log a complaint quotes [characters]. */
  private static final int QUOTED = 2000;

  private final List<String> command;
  private final Path log = Files.createTempFile("endurance", ".log");
  private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
  private final Process process;
  private final BufferedWriter input;
  private final Thread reader;

  Program(List<String> command) throws IOException {
    this.command = command;
    process = new ProcessBuilder(command).redirectError(log.toFile()).start();
    input =
        new BufferedWriter(
            new OutputStreamWriter(process.getOutputStream(), StandardCharsets.UTF_8));
    reader = Daemon.start("lines", this::readLines);
  }

  private void readLines() {
    try (BufferedReader output =
        new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
      output.lines().forEach(lines::add);
    } catch (IOException | UncheckedIOException e) {
      return; // the process has ended
    }
  }

  Process process() {
    return process;
  }

  /** The next line that begins so; those before it are lost. */
  String await(String beginning, double seconds) throws IOException {
    return await(List.of(beginning), seconds);
  }

  /** The next line that begins in one of these ways; those before it are lost. */
  String await(List<String> beginnings, double seconds) throws IOException {
    long end = System.nanoTime() + (long) (seconds * 1e9);
    while (System.nanoTime() < end) {
      String line = nextLine();
      if (line != null && beginnings.stream().anyMatch(line::startsWith)) {
        return line;
      }
      if (line == null && !process.isAlive() && lines.isEmpty()) {
        break;
      }
    }
    throw new IOException(
        "no line `%s` from %s %s: %s"
            .formatted(
                String.join("` or `", beginnings),
                command.get(command.size() - 1),
                process.isAlive() ? "in time" : "before its end",
                errors()));
  }

  private String nextLine() {
    try {
      return lines.poll(50, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted", e);
    }
  }

  /** Whether a line that begins so waits to be taken. */
  boolean said(String beginning) {
    return lines.stream().anyMatch(line -> line.startsWith(beginning));
  }

  /** All lines from now to its end; fails if there is no end in time. */
  List<String> rest(double seconds) throws IOException {
    awaitExit(seconds);
    try {
      reader.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return List.copyOf(lines);
  }

  /** Types a line. */
  void type(String line) throws IOException {
    input.write(line + "\n");
    input.flush();
  }

  /** The exit code; fails if there is none in time. */
  int awaitExit(double seconds) throws IOException {
    if (!endsWithin(seconds)) {
      throw new IOException(command.get(command.size() - 1) + " did not end");
    }
    return process.exitValue();
  }

  boolean endsWithin(double seconds) {
    try {
      return process.waitFor((long) (seconds * 1000), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted", e);
    }
  }

  /** As by {@code kill -9}. */
  void kill() {
    process.destroyForcibly();
    process.onExit().join();
  }

  /** How much it has written to standard error [bytes]. */
  long logBytes() throws IOException {
    return Files.size(log);
  }

  /** All that it has written to standard error. */
  String log() throws IOException {
    return Files.readString(log, StandardCharsets.ISO_8859_1);
  }

  Path logFile() {
    return log;
  }

  /** The end of what it wrote to standard error. */
  String errors() throws IOException {
    String all = log();
    return all.substring(Math.max(0, all.length() - QUOTED)).strip();
  }

  /** Ends it, with force if it does not end by itself when its input is over. */
  @Override
  public void close() {
    kill();
    try {
      input.close();
    } catch (IOException e) {
      // Nobody reads what was still to be typed.
    }
    try {
      Files.deleteIfExists(log);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
