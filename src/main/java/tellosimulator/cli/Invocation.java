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
 * Reads a command line, and does what it asks for; help, version and mistakes are the same for the
 * simulator and all subcommands. For one thread.
 */
public final class Invocation {

  private static final String HINT = " Try --help.";

  /** What is done once the options are read. */
  @FunctionalInterface
  public interface Action {
    /** Returns the {@link ExitCode}. */
    int run() throws UnreadableRecordingException, PortTakenException, InterruptedException;
  }

  private final CommandLine commandLine;
  private final Collection<String> subcommands;
  private final ProgramOutput output;

  /**
   * Does nothing yet.
   *
   * @param subcommands words that may come first on the command line; what is read here begins with
   *     none of them
   */
  public Invocation(CommandLine commandLine, Collection<String> subcommands, ProgramOutput output) {
    this.commandLine = commandLine;
    this.subcommands = List.copyOf(subcommands);
    this.output = output;
  }

  /**
   * Reads the words, and carries out what they ask for, unless that is help or the version.
   *
   * @param reading looks whether the options fit together, and says what is to be done; its {@link
   *     IllegalArgumentException} is told as a mistake in the options, and none of the action's
   * @return the {@link ExitCode}, after a sentence where something is wrong
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
          + Spelling.meant(word.replaceFirst("=.*", ""), known)
              .map(meant -> ", did you mean " + meant + "?")
              .orElse(".")
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
