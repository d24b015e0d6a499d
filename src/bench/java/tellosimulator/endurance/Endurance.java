package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import tellosimulator.benchmark.Measurement;

/**
 * Attacks the program as a process, and prints one table of what came of it: {@code mvn -Pendurance
 * verify}, or longer {@code mvn -Pendurance -Dendurance.minutes=60 verify}, or only some rows
 * {@code mvn -Pendurance -Dendurance.rows=flood,reflector verify}. Fails when a row is missed.
 */
public final class Endurance {

  private static final String DEFAULT_MINUTES = "5";

  /** So often what depends on the machine's other work is measured where it is missed at first. */
  private static final int RUNS = 3;

  /** Some rows of the table. */
  @FunctionalInterface
  private interface Trial {
    List<Measurement> run(double minutes) throws IOException;
  }

  /** When a trial runs. */
  private enum Lane {
    /** Its numbers are times, so nothing runs beside it. */
    ALONE,
    /** It takes little, but long: it runs beside all that come after it. */
    BESIDE,
    IN_TURN
  }

  private record Entry(Lane lane, Trial trial) {}

  private Endurance() {}

  /** Runs all trials, or those of the property {@code endurance.rows}. */
  public static void main(String[] arguments) {
    double minutes = Double.parseDouble(System.getProperty("endurance.minutes", DEFAULT_MINUTES));
    Map<String, Entry> chosen = chosen(System.getProperty("endurance.rows", ""));
    Map<String, CompletableFuture<List<Measurement>>> running = new LinkedHashMap<>();
    for (Lane lane : Lane.values()) {
      chosen.forEach(
          (name, entry) -> {
            if (entry.lane() == lane) {
              running.put(name, begin(name, entry, minutes));
            }
          });
    }
    List<Measurement> rows = new ArrayList<>();
    chosen.keySet().forEach(name -> rows.addAll(running.get(name).join()));
    System.out.printf(
        "%nJava %s, %s, %d processors, %s minutes%n%n",
        System.getProperty("java.version"),
        System.getProperty("os.name"),
        Runtime.getRuntime().availableProcessors(),
        Double.toString(minutes).replace(".0", ""));
    Measurement.print(rows, System.out);
    List<Measurement> missed = rows.stream().filter(row -> !row.reached()).toList();
    System.out.printf("%n%d of %d rows missed%n", missed.size(), rows.size());
    if (!missed.isEmpty()) {
      Measurement.print(missed, System.out);
    }
    System.exit(missed.isEmpty() ? 0 : 1);
  }

  private static CompletableFuture<List<Measurement>> begin(
      String name, Entry entry, double minutes) {
    if (entry.lane() == Lane.BESIDE) {
      return CompletableFuture.supplyAsync(
          () -> run(name, entry.trial(), minutes), trial -> Daemon.start(name, trial));
    }
    return CompletableFuture.completedFuture(run(name, entry.trial(), minutes));
  }

  /** A trial that cannot be run is missed, and the others go on. */
  private static List<Measurement> run(String name, Trial trial, double minutes) {
    long start = System.nanoTime();
    List<Measurement> rows;
    try {
      rows = trial.run(minutes);
    } catch (IOException | RuntimeException e) { // whatever it is, the other trials go on
      rows = List.of(new Measurement(name, "a measurement", "none: " + e, false));
    }
    System.out.printf("%n%s: %.0f s%n", name, (System.nanoTime() - start) * 1e-9);
    Measurement.print(rows, System.out);
    return rows;
  }

  /**
   * @param only names of trials with commas between them; all if empty
   */
  private static Map<String, Entry> chosen(String only) {
    Map<String, Entry> all = trials();
    if (only.isEmpty()) {
      return all;
    }
    List<String> names = List.of(only.split(",", -1));
    if (!all.keySet().containsAll(names)) {
      throw new IllegalArgumentException(
          "endurance.rows is " + only + ", but must be of " + all.keySet());
    }
    Map<String, Entry> chosen = new LinkedHashMap<>(all);
    chosen.keySet().retainAll(names);
    return chosen;
  }

  private static Map<String, Entry> trials() {
    Map<String, Entry> trials = new LinkedHashMap<>();
    trials.put("flood", new Entry(Lane.ALONE, inNetwork(again(FloodTrial::run))));
    trials.put("reflector", new Entry(Lane.IN_TURN, inNetwork(ReflectorTrial::run)));
    trials.put("silent", new Entry(Lane.BESIDE, inNetwork(ReflectorTrial::runSilent)));
    trials.put("outbox", new Entry(Lane.IN_TURN, OutboxTrial::run));
    trials.put("heap", new Entry(Lane.IN_TURN, SmallHeapTrial::run));
    trials.put("garbage", new Entry(Lane.IN_TURN, again(GarbageTrial::run)));
    trials.put("stop", new Entry(Lane.ALONE, again(StopTrial::run)));
    trials.put("interface", new Entry(Lane.ALONE, inNetwork(again(InterfaceTrial::run))));
    trials.put("link", new Entry(Lane.BESIDE, inNetwork(again(LinkTrial::run))));
    trials.put("disk", new Entry(Lane.BESIDE, FullDiskTrial::run));
    trials.put("clock", new Entry(Lane.ALONE, again(ClockTrial::run)));
    trials.put("power", new Entry(Lane.IN_TURN, PowerTrial::run));
    trials.put("address", new Entry(Lane.IN_TURN, inNetwork(NewAddressTrial::run)));
    trials.put("files", new Entry(Lane.ALONE, again(FilesTrial::run)));
    trials.put("recording", new Entry(Lane.IN_TURN, RecordingTrial::run));
    trials.put("replay", new Entry(Lane.BESIDE, ReplayTrial::run));
    trials.put("determinism", new Entry(Lane.IN_TURN, DeterminismTrial::run));
    trials.put("ending", new Entry(Lane.IN_TURN, again(EndingTrial::landsTooEarly)));
    trials.put("timeout", new Entry(Lane.IN_TURN, again(EndingTrial::neverTakesOff)));
    trials.put("window", new Entry(Lane.ALONE, again(WindowTrial::run)));
    trials.put("class", new Entry(Lane.IN_TURN, inNetwork(ClassTrial::run)));
    trials.put("kit", new Entry(Lane.IN_TURN, KitTrial::run));
    trials.put("soak", new Entry(Lane.IN_TURN, SoakTrial::run));
    trials.put("day", new Entry(Lane.BESIDE, DayTrial::run));
    return trials;
  }

  /**
   * A row that is missed is measured twice more, and counts if its median is enough. A trial that
   * could not be run is tried twice more.
   */
  private static Trial again(Trial trial) {
    return minutes -> {
      List<List<Measurement>> runs = new ArrayList<>();
      for (int run = 1; run <= RUNS && !allReached(runs); run++) {
        try {
          runs.add(trial.run(minutes));
        } catch (IOException e) {
          if (run == RUNS && runs.isEmpty()) {
            throw e;
          }
        }
      }
      List<Measurement> rows = new ArrayList<>();
      for (int i = 0; i < runs.get(0).size(); i++) {
        int row = i;
        rows.add(Measurement.ofRuns(runs.stream().map(run -> run.get(row)).toList()));
      }
      return rows;
    };
  }

  private static boolean allReached(List<List<Measurement>> runs) {
    return !runs.isEmpty() && runs.get(0).stream().allMatch(Measurement::reached);
  }

  /** Where nobody can make a private network, the rows are not measured, which is no miss. */
  private static Trial inNetwork(Trial trial) {
    return minutes -> {
      Optional<String> obstacle = PrivateNetwork.obstacle();
      return obstacle.isPresent()
          ? List.of(Measurement.beside("In a private network", "not measured: " + obstacle.get()))
          : trial.run(minutes);
    };
  }
}
