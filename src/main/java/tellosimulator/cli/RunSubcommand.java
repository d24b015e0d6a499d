package tellosimulator.cli;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import tellosimulator.files.IoReason;
import tellosimulator.operator.ProgramRun;
import tellosimulator.operator.ProgramRun.Ends;
import tellosimulator.operator.ProgramRun.ExitCodes;
import tellosimulator.operator.ProgramRun.Plan;
import tellosimulator.operator.UnavailableException;
import tellosimulator.scenario.Scenario;

/**
 * Runs an unchanged operator program in a network in which drones are where real ones are. For one
 * thread.
 */
final class RunSubcommand implements Subcommand {

  private static final String SEPARATOR = "--";

  /** What this subcommand decides by itself. */
  private static final List<String> DECIDED =
      List.of("--bind", "--command-port", "--lan", "--port-per-drone", "--replay", "--scenarios");

  private final OptionList optionList =
      OptionList.of(
          SubcommandName.RUN,
          "Runs an unchanged program in a private network, in which the drone has 192.168.10.1:8889"
              + " and the program 192.168.10.2, as with a real drone; several drones have"
              + " 192.168.10.11, 192.168.10.12, and so on. Linux only.",
          "Exit code: that of the program; if that is 0, the simulator's: 3 if goals were missed; 1:"
              + " no private network can be had; 2: wrong options.");

  private IVersionProvider version = () -> new String[0];

  @Override
  public CommandLine commandLine(IVersionProvider newVersion) {
    version = newVersion;
    optionList.anyWords(
        "[OPTION...] -- PROGRAM [ARGUMENT...]",
        "Options of the simulator, such as --headless or --scenario slalom; and after --, your"
            + " program. Without a window, a scenario with goals ends with the verdict on them.");
    return optionList.commandLine(newVersion);
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

  private Plan plan(List<String> words, List<String> program) {
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
    Scenario scenario = options.launch().scenario().scenario();
    int drones = scenario.config().drones().size();
    if (drones > ProgramRun.MOST_DRONES) {
      throw new IllegalArgumentException(
          "run has addresses for " + ProgramRun.MOST_DRONES + " drones, but there are " + drones);
    }
    List<String> simulator = new ArrayList<>(ownCommand());
    simulator.addAll(words);
    Ends ends = Ends.WITH_WINDOW;
    if (options.headless()) {
      ends = scenario.challenge().goals().isEmpty() ? Ends.AT_ONCE : Ends.WITH_VERDICT;
      if (ends == Ends.WITH_VERDICT && !options.exitWhenDone()) {
        simulator.add(ScenarioOptions.EXIT_WHEN_DONE);
      }
    } else if (!options.on()) {
      simulator.add("--on");
    }
    return new Plan(simulator, program, drones, ends);
  }

  /** The words that start this program once more. */
  private static List<String> ownCommand() {
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

  private static int run(Plan plan, ProgramOutput to) throws InterruptedException {
    try (ProgramRun run = new ProgramRun(plan, to.out())) {
      to.input().atEnd().accept(run::close);
      Optional<ExitCodes> codes = run.run();
      if (codes.isEmpty()) {
        return ExitCode.FAILED;
      }
      return codes.get().program() != 0 ? codes.get().program() : codes.get().simulator();
    } catch (UnavailableException e) {
      to.err().println(e.getMessage());
    } catch (IOException e) {
      to.err().println("The program was not run: " + IoReason.of(e) + ".");
    }
    return ExitCode.FAILED;
  }
}
