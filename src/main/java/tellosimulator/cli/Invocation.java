package tellosimulator.cli;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.function.Supplier;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.words.Spelling;

/**
 * Parses a command line and executes it. Help, version and errors are handled in the same way for
 * the simulator and all subcommands. Not thread-safe.
 */
public final class Invocation {

  private static final String HINT = " Try --help.";

  /** The action to run once the options are parsed. */
  @FunctionalInterface
  public interface Action {
    /** Runs the action; returns the {@link ExitCode}. */
    int run() throws UnreadableRecordingException, PortTakenException, InterruptedException;
  }

  private final CommandLine commandLine;
  private final Collection<String> subcommands;
  private final ProgramOutput output;

  /**
   * Creates an invocation without running it.
   *
   * @param subcommands the names of all subcommands; candidates for a suggestion if the first
   *     argument is misspelt
   */
  public Invocation(CommandLine commandLine, Collection<String> subcommands, ProgramOutput output) {
    this.commandLine = commandLine;
    this.subcommands = List.copyOf(subcommands);
    this.output = output;
  }

  /**
   * Parses the arguments and executes them, unless they request help or the version.
   *
   * @param reading checks the options and returns the action; an {@link IllegalArgumentException}
   *     thrown by this supplier is reported as an error in the options, but one thrown by the
   *     action is not
   * @return the {@link ExitCode}; if there was an error, a message has been printed
   */
  public int run(String[] args, Supplier<Action> reading) {
    Action action;
    try {
      ParseResult parsed = commandLine.parseArgs(args);
      if (parsed.isUsageHelpRequested()) {
        commandLine.usage(output.help());
        return ExitCode.DONE;
      }
      if (parsed.isVersionHelpRequested()) {
        commandLine.printVersionHelp(output.help());
        return ExitCode.DONE;
      }
      action = reading.get();
    } catch (ParameterException | IllegalArgumentException e) {
      output.err().println(diagnostic(e, args));
      return ExitCode.WRONG_OPTIONS;
    }
    return run(action);
  }

  private int run(Action action) {
    try {
      return action.run();
    } catch (UnreadableRecordingException | PortTakenException e) {
      output.err().println(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return ExitCode.FAILED;
  }

  private String diagnostic(RuntimeException e, String... args) {
    if (e instanceof UnmatchedArgumentException unmatched) {
      String word = unmatched.getUnmatched().get(0);
      if (ScenarioOptions.isFile(word)) {
        return "Beside options, a scenario file is named by --scenario " + word + "." + HINT;
      }
      List<String> known = new ArrayList<>(commandLine.getCommandSpec().optionsMap().keySet());
      if (word.equals(args[0])) {
        known.addAll(subcommands);
      }
      return "There is no option "
          + word
          + Spelling.hint(word.replaceFirst("=.*", ""), known, ".")
          + HINT;
    }
    return e.getCause() instanceof ScenarioException wrong
        ? wrong.getMessage()
        : sentence(Objects.requireNonNullElse(e.getMessage(), "")) + HINT;
  }

  private static String sentence(String message) {
    String line = message.lines().findFirst().orElse("The options are wrong");
    String capital = Character.toUpperCase(line.charAt(0)) + line.substring(1);
    return capital.matches(".*[.?]") ? capital : capital + ".";
  }
}
