package tellosimulator.grade;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import tellosimulator.launcher.Confinement;
import tellosimulator.launcher.ExceededLimit;
import tellosimulator.launcher.ProgramRun;
import tellosimulator.launcher.ProgramRun.Distrust;
import tellosimulator.launcher.ProgramRun.ExitCodes;
import tellosimulator.launcher.ProgramRun.NetworkChoice;
import tellosimulator.launcher.ProgramRun.Plan;
import tellosimulator.launcher.UnavailableException;
import tellosimulator.recording.FlightResult;
import tellosimulator.scenario.Assignment;
import tellosimulator.scenario.Assignment.Pace;
import tellosimulator.scenario.Assignment.Setup;
import tellosimulator.words.Phrase;

/**
 * A flight of a hand-in on a course: a simulator and the program, each in a process. Works on the
 * calling thread; {@link #close} is thread-safe.
 */
final class HandInFlight implements AutoCloseable {

  /** The name of the recording within the folder of the flight. */
  static final String RECORDING = "flight";

  private static final String RESULT = "result.json";
  private static final String LOG = "simulator.txt";

  /** Exit codes of a simulator after a verdict. */
  private static final List<Integer> VERDICTS = List.of(0, 3);

  /**
   * Exit codes of a program that could not be confined, is not executable, or was not found, if it
   * sent nothing; other programs may use them, too. Documented: confine.sh; POSIX, sh.
   */
  private static final List<Integer> NOT_STARTED = List.of(125, 126, 127);

  private final GradingPlan plan;
  private final SeededCourse course;
  private final Path folder;
  private volatile Optional<ProgramRun> run = Optional.empty();
  private volatile boolean closed;

  /**
   * Creates a flight without starting it.
   *
   * @param folder an empty folder for the files of the flight
   */
  HandInFlight(GradingPlan plan, SeededCourse course, Path folder) {
    this.plan = plan;
    this.course = course;
    this.folder = folder;
  }

  /**
   * The outcome of a flight.
   *
   * @param program how the program ended
   * @param time {@code max} or {@code real}; empty if there was no flight
   * @param problem why there was no flight; empty if {@code program} says it
   */
  record Outcome(FlightResult result, String program, String time, Optional<Phrase> problem) {

    Outcome(FlightResult result, String program, String time) {
      this(result, program, time, Optional.empty());
    }
  }

  /**
   * Flies until the verdict, the end of the program, or a limit.
   *
   * @param files the folder with the files of the program, or a tar archive of it
   * @param file the file to start
   * @param stash an empty folder
   * @throws IOException if the simulator failed, or a file cannot be written; the message is a
   *     clause
   */
  Outcome fly(Path files, String file, Path stash)
      throws IOException, UnavailableException, InterruptedException {
    Optional<List<String>> command = Commands.start(plan.assignment(), file);
    if (command.isEmpty()) {
      return new Outcome(course.unflown(), "did not start", "");
    }
    Confinement confinement = plan.confinement(files, stash);
    Pace pace = plan.assignment().setup().pace();
    if (pace == Pace.MAX || (pace == Pace.AUTO && !course.lasting())) {
      Optional<Outcome> fast = fly(command.get(), confinement, pace == Pace.AUTO, true);
      if (fast.isPresent()) {
        return fast.get();
      }
      Grader.clear(folder);
    }
    return fly(command.get(), confinement, false, false).orElseThrow();
  }

  /**
   * Flies once.
   *
   * @param waiting whether the flight is given up if the program does not wait for replies
   * @param fast whether time passes as fast as possible
   * @return empty if the flight was given up
   */
  private Optional<Outcome> fly(
      List<String> program, Confinement confinement, boolean waiting, boolean fast)
      throws IOException, UnavailableException, InterruptedException {
    List<String> simulator = simulator(fast);
    if (waiting) {
      simulator.add("--await-replies");
    }
    Distrust distrust = new Distrust(confinement, folder.resolve(LOG));
    Plan processes =
        new Plan(
            simulator,
            program,
            course.drones(),
            plan.confined() ? NetworkChoice.PRIVATE : NetworkChoice.SHIM,
            false,
            Optional.of(folder.resolve(GradedFlight.OUTPUT)),
            Optional.of(distrust));
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    try (ProgramRun started = new ProgramRun(processes, nowhere)) {
      run = Optional.of(started);
      if (closed) {
        throw new InterruptedException();
      }
      Optional<ExitCodes> codes = started.run();
      if (closed) {
        throw new InterruptedException();
      }
      if (waiting && codes.isPresent() && codes.get().simulator() == ProgramRun.NOT_WAITING) {
        return Optional.empty();
      }
      if (codes.isEmpty() || !VERDICTS.contains(codes.get().simulator())) {
        throw new IOException("the simulator failed: " + lastLine(folder.resolve(LOG)));
      }
      FlightResult result = result();
      keepRecording();
      String how = program(started.exceeded(), codes.get().program(), result);
      return Optional.of(new Outcome(result, how, fast ? "max" : "real"));
    } finally {
      run = Optional.empty();
    }
  }

  private List<String> simulator(boolean fast) {
    Assignment assignment = plan.assignment();
    List<String> words = new ArrayList<>(plan.simulator());
    words.addAll(List.of("--headless", "--exit-when-done", "--await-program"));
    words.addAll(List.of("--scenario", course.scenario(), "--log-level", "warn"));
    words.addAll(List.of("--timeout", Double.toString(assignment.limits().simulatedSeconds())));
    words.addAll(List.of("--record", folder.toString()));
    words.addAll(List.of("--result", folder.resolve(RESULT).toString()));
    words.addAll(List.of("--time-factor", fast ? "max" : "1"));
    words.addAll(List.of("--seed", Long.toString(course.seed())));
    Setup setup = assignment.setup();
    setup.profile().ifPresent(each -> words.addAll(List.of("--profile", each.option())));
    setup.behavior().ifPresent(each -> words.addAll(List.of("--behaviour", each.option())));
    setup
        .link()
        .ifPresent(each -> words.addAll(List.of("--link", each.name().toLowerCase(Locale.ROOT))));
    setup.faults().forEach(each -> words.addAll(List.of("--fault", each.text())));
    return words;
  }

  private FlightResult result() throws IOException {
    try {
      return FlightResult.read(Files.readString(folder.resolve(RESULT)));
    } catch (IllegalArgumentException | NoSuchFileException e) {
      throw new IOException("the simulator wrote no result", e);
    }
  }

  /** Gives the recording of the last flight a name that is always the same. */
  private void keepRecording() throws IOException {
    List<Path> recordings;
    try (Stream<Path> children = Files.list(folder)) {
      recordings = children.filter(Files::isDirectory).sorted().toList();
    }
    for (int i = 0; i < recordings.size(); i++) {
      boolean last = i == recordings.size() - 1;
      String name = last ? RECORDING : RECORDING + "-" + (i + 1);
      Files.move(recordings.get(i), folder.resolve(name));
    }
  }

  private String program(Optional<ExceededLimit> exceeded, OptionalInt code, FlightResult result) {
    if (exceeded.isPresent()) {
      return switch (exceeded.get()) {
        case TIME ->
            String.format(
                Locale.ROOT, "killed after %.0f s", plan.assignment().limits().wallSeconds());
        case OUTPUT -> "killed: too much output";
        case MEMORY -> "killed: too much memory";
        case PROCESSES -> "killed: too many processes";
      };
    }
    if (code.isEmpty()) {
      return "stopped after the verdict";
    }
    int exit = code.getAsInt();
    boolean silent = result.commands() == 0;
    if (exit == 0) {
      return silent ? "no command" : "ended";
    }
    return silent && NOT_STARTED.contains(exit) ? "did not start" : "exit " + exit;
  }

  private static String lastLine(Path file) throws IOException {
    List<String> lines = Files.readAllLines(file);
    return lines.isEmpty() ? "it does not say why" : lines.get(lines.size() - 1);
  }

  /** Ends the flight. */
  @Override
  public void close() {
    closed = true;
    run.ifPresent(ProgramRun::close);
  }
}
