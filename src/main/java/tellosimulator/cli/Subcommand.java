package tellosimulator.cli;

import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;

/** A function of the program other than simulating, with its own options. Not thread-safe. */
public abstract class Subcommand {

  /** The options, to which each subcommand adds its own. */
  final OptionList optionList;

  /**
   * Creates a subcommand without options.
   *
   * @param does a sentence about the purpose of the subcommand
   * @param exitCodes a sentence about the meaning of its exit codes
   */
  Subcommand(SubcommandName name, String does, String exitCodes) {
    optionList = OptionList.of(name, does, exitCodes);
  }

  /** Returns a parser for the options of this subcommand. The parser also prints their help. */
  public CommandLine commandLine(IVersionProvider version) {
    return optionList.commandLine(version);
  }

  /**
   * Returns the action to run after the options have been parsed.
   *
   * @throws IllegalArgumentException if the options are inconsistent; the message is one sentence
   */
  public abstract Invocation.Action action(ProgramOutput output);
}
