package tellosimulator.benchmark;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What the operating system and the JVM's own tools tell of a running Java program. */
public final class ProcessFigures {

  private static final Pattern USED = Pattern.compile("used (\\d+)K");

  private static final Pattern COMPILER = Pattern.compile("C[12] Compiler");

  private final Process process;

  public ProcessFigures(Process process) {
    this.process = process;
  }

  /** Resident memory [MB]. */
  public double residentMegabytes() {
    String line = run("ps", "-o", "rss=", "-p", "" + process.pid()).get(0);
    return Long.parseLong(line.strip()) / 1024.0;
  }

  /** Processor time that it has used, on all processors together [s]. */
  public double processorSeconds() {
    return process.info().totalCpuDuration().orElseThrow().toNanos() * 1e-9;
  }

  /** What of it the compilers of the Java machine have used; only on Linux [s]. */
  public double compilerSeconds() {
    try (Stream<Path> threads = Files.list(Path.of("/proc", "" + process.pid(), "task"))) {
      return threads.mapToDouble(ProcessFigures::compilerSeconds).sum();
    } catch (IOException e) {
      throw new UncheckedIOException("the threads cannot be seen", e);
    }
  }

  /** Documented: proc(5); user and system time are fields 14 and 15, in hundredths of a second. */
  private static double compilerSeconds(Path thread) {
    try {
      String stat = Files.readString(thread.resolve("stat"));
      int end = stat.lastIndexOf(')');
      if (!COMPILER.matcher(stat.substring(stat.indexOf('(') + 1, end)).lookingAt()) {
        return 0;
      }
      String[] fields = stat.substring(end + 2).split(" ", -1); // from field 3 on
      return (Long.parseLong(fields[11]) + Long.parseLong(fields[12])) / 100.0;
    } catch (IOException e) {
      return 0; // it has ended
    }
  }

  /** How many threads it has. */
  public int threads() {
    return Integer.parseInt(run("ps", "-o", "nlwp=", "-p", "" + process.pid()).get(0).strip());
  }

  /** Used heap after a full collection [MB]. */
  public double heapMegabytes() {
    run(tool("jcmd"), "" + process.pid(), "GC.run");
    double kilobytes = 0;
    for (String line : run(tool("jcmd"), "" + process.pid(), "GC.heap_info")) {
      Matcher matcher = USED.matcher(line);
      if (!line.contains("Metaspace") && !line.contains("class space") && matcher.find()) {
        kilobytes += Double.parseDouble(matcher.group(1));
      }
    }
    return kilobytes / 1024;
  }

  /** A program of the JDK that runs this. */
  public static String tool(String name) {
    return Path.of(System.getProperty("java.home"), "bin", name).toString();
  }

  private static List<String> run(String... command) {
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(
                new ProcessBuilder(command).redirectErrorStream(true).start().getInputStream(),
                StandardCharsets.UTF_8))) {
      return lines.lines().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(command[0] + " cannot be run", e);
    }
  }
}
