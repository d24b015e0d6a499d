package tellosimulator.endurance;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import tellosimulator.benchmark.Measurement;

/** Opens files that were made to do harm, each with a program of its own. */
final class FilesTrial {

  /** Of processor time, with the start of the program. */
  private static final double LONGEST_SECONDS = 5;

  /** Programs at a time. */
  private static final int AT_A_TIME = 2;

  private static final double MOST_MEGABYTES = 400;

  /** Then nobody waits any longer. */
  private static final double PATIENCE_SECONDS = 20;

  /** The exit code for wrong options and files. Source: docs/scenarios.md. */
  private static final int REFUSED = 2;

  private static final Pattern PEAK = Pattern.compile("VmHWM:\\s+(\\d+) kB");

  /** How a program fared with a file. */
  private record Opening(String name, boolean told, double seconds, double megabytes) {}

  private FilesTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    Map<String, Path> files = HostileFiles.in(Files.createTempDirectory("hostile"));
    ExecutorService programs = Executors.newFixedThreadPool(AT_A_TIME);
    List<CompletableFuture<Opening>> opened = new ArrayList<>();
    files.forEach(
        (name, file) ->
            opened.add(CompletableFuture.supplyAsync(() -> open(name, file), programs)));
    List<Opening> openings = opened.stream().map(CompletableFuture::join).toList();
    programs.shutdown();
    long told = openings.stream().filter(Opening::told).count();
    Opening slowest = openings.stream().max(Comparator.comparing(Opening::seconds)).orElseThrow();
    Opening largest = openings.stream().max(Comparator.comparing(Opening::megabytes)).orElseThrow();
    return List.of(
        new Measurement(
            "Hostile scenarios that are refused with a sentence",
            "all of " + openings.size(),
            told + " of " + openings.size(),
            told == openings.size()),
        new Measurement(
            "… processor time of the longest",
            String.format(Locale.ROOT, "at most %.0f s", LONGEST_SECONDS),
            String.format(Locale.ROOT, "%.1f s (%s)", slowest.seconds(), slowest.name()),
            slowest.seconds() <= LONGEST_SECONDS),
        new Measurement(
            "… resident memory of the largest",
            String.format(Locale.ROOT, "at most %.0f MB", MOST_MEGABYTES),
            String.format(Locale.ROOT, "%.0f MB (%s)", largest.megabytes(), largest.name()),
            largest.megabytes() <= MOST_MEGABYTES));
  }

  private static Opening open(String name, Path file) {
    long begun = System.nanoTime();
    try (Program program =
        Host.HERE.start(
            SimulatorProcess.command(
                List.of(), "--headless", "--command-port", "0", "--scenario", file.toString()))) {
      double megabytes = 0;
      double seconds = 0;
      while (program.process().isAlive()
          && System.nanoTime() - begun < PATIENCE_SECONDS * 1e9
          && !program.said("ready")) {
        megabytes = Math.max(megabytes, peakMegabytes(program));
        seconds = Math.max(seconds, processorSeconds(program));
        Waiting.pass(Waiting.SHORT);
      }
      boolean refused = program.endsWithin(0) && program.process().exitValue() == REFUSED;
      boolean told =
          refused && !program.log().isBlank() && LeakedInternals.first(program.log()).isEmpty();
      if (!told || seconds > LONGEST_SECONDS || megabytes > MOST_MEGABYTES) {
        System.out.printf(
            "%s: %.1f s, %.0f MB, %s%n",
            name,
            seconds,
            megabytes,
            program.endsWithin(0) ? "ended with " + program.process().exitValue() : "goes on");
        System.out.println(program.errors());
      }
      return new Opening(name, told, seconds, megabytes);
    } catch (IOException e) {
      throw new CompletionException(e);
    }
  }

  /** Processor time until now; 0 when it has ended. */
  private static double processorSeconds(Program program) {
    return program.process().info().totalCpuDuration().orElse(Duration.ZERO).toNanos() * 1e-9;
  }

  /** The largest resident memory until now; 0 where the system does not tell. */
  private static double peakMegabytes(Program program) {
    Path status = Path.of("/proc/" + program.process().pid() + "/status");
    try {
      Matcher matcher = PEAK.matcher(Files.readString(status, StandardCharsets.US_ASCII));
      return matcher.find() ? Double.parseDouble(matcher.group(1)) / 1024 : 0;
    } catch (IOException e) {
      return 0; // it has ended
    }
  }
}
