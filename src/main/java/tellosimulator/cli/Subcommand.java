package tellosimulator.cli;

import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;

/** A function of the program other than simulating, with its own options. Not thread-safe. */
public interface Subcommand {

  /** Returns a parser for the options of this subcommand. The parser also prints their help. */
  CommandLine commandLine(IVersionProvider version);

  /**
   * Returns the action to run after the options have been parsed.
   *
   * @throws IllegalArgumentException if the options are inconsistent; the message is one sentence
   */
  Invocation.Action action(ProgramOutput output);
}
