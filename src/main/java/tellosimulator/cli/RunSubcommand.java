package tellosimulator.cli;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import tellosimulator.concurrent.FatalExit;
import tellosimulator.concurrent.TerminationSignals;
import tellosimulator.files.IoReason;
import tellosimulator.launcher.ProgramRun;
import tellosimulator.launcher.ProgramRun.ExitCodes;
import tellosimulator.launcher.ProgramRun.NetworkChoice;
import tellosimulator.launcher.ProgramRun.Plan;
import tellosimulator.launcher.UnavailableException;
import tellosimulator.scenario.Scenario;

/**
 * Runs an unmodified operator program in a network where the simulated drones have the addresses of
 * real ones. Not thread-safe.
 */
final class RunSubcommand extends Subcommand {

  private static final String SEPARATOR = "--";
  private static final String PROGRAM_OUTPUT = "--program-output";
  private static final String SHIM = "--shim";

  /** Options that cannot be combined with this subcommand. */
  private static final List<String> DECIDED =
      List.of("--bind", "--command-port", "--lan", "--port-per-drone", "--replay", "--scenarios");

  /** Exit codes of a simulator that ended normally. */
  private static final List<Integer> VERDICTS = List.of(ExitCode.DONE, ExitCode.GOALS_MISSED);

  private final OptionValue<Optional<Path>> output =
      optionList
          .option(
              PROGRAM_OUTPUT,
              "FILE",
              "Write what your program prints into a file, of which it keeps the first 10 MB, and not"
                  + " between the lines of the simulator.")
          .readIfGiven(OptionTypes::fileOrFolder);

  private final OptionValue<Boolean> shim =
      optionList.flag(SHIM, "Use the shim even where there can be a private network.");

  private IVersionProvider version = () -> new String[0];

  RunSubcommand() {
    super(
        SubcommandName.RUN,
        "Runs an unchanged program in a private network, in which the drone has 192.168.10.1:8889"
            + " and the program 192.168.10.2, as with a real drone; several drones have"
            + " 192.168.10.11, 192.168.10.12, and so on. Where there can be no private network, a"
            + " shim gives programs in Python, Java and Node.js the same addresses.",
        "Exit code: that of the program, which the line \"program: exit code N\" says; if it is 0,"
            + " or the program had to be ended, 0, or 3 if goals were missed, which the line"
            + " \"goals: ...\" says. Without a line of the program: 1: it cannot be started; 2:"
            + " wrong options. 70: the simulator ended too early; 130: Ctrl-C.");
  }

  @Override
  public CommandLine commandLine(IVersionProvider newVersion) {
    version = newVersion;
    optionList.anyWords(
        "[OPTION...] -- PROGRAM [ARGUMENT...]",
        "Options of the simulator, such as --headless or --scenario slalom; and after --, your"
            + " program. Without a window, a scenario with goals ends with the verdict on them.");
    return super.commandLine(newVersion);
  }

  @Override
  public Invocation.Action action(ProgramOutput output) {
    List<String> words = optionList.words();
    int separator = words.indexOf(SEPARATOR);
    if (separator < 0 || separator == words.size() - 1) {
      throw new IllegalArgumentException(
          "run needs your program after --, such as: run --headless -- python3 fly.py");
    }
    List<String> ours = words.subList(1, separator);
    Plan plan = plan(ours, words.subList(separator + 1, words.size()));
    return () -> run(plan, output);
  }

  private Plan plan(List<String> all, List<String> program) {
    List<String> words = simulatorOptions(all);
    Options options = new Options();
    List<String> given =
        options
            .commandLine(version)
            .parseArgs(words.toArray(String[]::new))
            .matchedOptions()
            .stream()
            .map(option -> option.longestName())
            .toList();
    for (String decided : DECIDED) {
      if (given.contains(decided)) {
        throw new IllegalArgumentException(decided + " does not go with run, which decides that");
      }
    }
    Scenario scenario = options.launch().scenario();
    int drones = scenario.config().drones().size();
    if (drones > ProgramRun.MOST_DRONES) {
      throw new IllegalArgumentException(
          "run has addresses for " + ProgramRun.MOST_DRONES + " drones, but there are " + drones);
    }
    List<String> simulator = new ArrayList<>(ownCommand());
    simulator.addAll(words);
    if (!options.headless() && !options.on()) {
      simulator.add("--on");
    }
    if (options.headless() && !scenario.challenge().goals().isEmpty()) {
      simulator.add(ScenarioOptions.AWAIT_PROGRAM);
      if (!options.exitWhenDone()) {
        simulator.add(ScenarioOptions.EXIT_WHEN_DONE);
      }
    }
    return new Plan(
        simulator,
        program,
        drones,
        shim.value() ? NetworkChoice.SHIM : NetworkChoice.EITHER,
        !options.headless(),
        output.value().map(Path::toAbsolutePath),
        Optional.empty());
  }

  /**
   * Returns the words without the options of this subcommand; all of them are passed to the
   * simulator.
   */
  private static List<String> simulatorOptions(List<String> words) {
    List<String> left = new ArrayList<>(words);
    left.removeIf(SHIM::equals);
    left.removeIf(word -> word.startsWith(PROGRAM_OUTPUT + "="));
    int index = left.indexOf(PROGRAM_OUTPUT);
    if (index >= 0) {
      left.subList(index, Math.min(index + 2, left.size())).clear();
    }
    return left;
  }

  /** Returns the command that starts another process of this program. */
  static List<String> ownCommand() {
    Optional<String> image = Optional.ofNullable(System.getProperty("jpackage.app-path"));
    if (image.isPresent()) {
      return List.of(image.get());
    }
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    List<String> paths = new ArrayList<>();
    for (String path : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      paths.add(Path.of(path).toAbsolutePath().toString());
    }
    return List.of(java, "-cp", String.join(File.pathSeparator, paths), "tellosimulator.Main");
  }

  @SuppressWarnings("try") // the signal handler only needs to be kept open
  private static int run(Plan plan, ProgramOutput to) throws InterruptedException {
    AtomicInteger signal = new AtomicInteger();
    try (ProgramRun run = new ProgramRun(plan, to.out());
        TerminationSignals signals = TerminationSignals.take(number -> end(run, signal, number))) {
      to.input().atEnd().accept(run::close);
      Optional<ExitCodes> codes = run.run();
      return signal.get() != 0 ? 128 + signal.get() : exitCode(codes, to);
    } catch (UnavailableException e) {
      to.err().println(e.getMessage());
    } catch (IOException e) {
      to.err().println("The program was not run: " + IoReason.of(e) + ".");
    }
    return ExitCode.FAILED;
  }

  private static void end(ProgramRun run, AtomicInteger signal, int number) {
    signal.compareAndSet(0, number);
    try {
      run.interrupt();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static int exitCode(Optional<ExitCodes> codes, ProgramOutput to) {
    if (codes.isEmpty()) {
      return ExitCode.FAILED;
    }
    int simulator = codes.get().simulator();
    if (!VERDICTS.contains(simulator)) {
      to.err()
          .println(
              "The simulator ended before it was asked to, with exit code "
                  + simulator
                  + "; it was killed, its display has gone, or its own message says why.");
      return FatalExit.CODE;
    }
    int program = codes.get().program().orElse(0);
    return program != 0 ? program : simulator;
  }
}
