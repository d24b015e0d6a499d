package tellosimulator.cli;

import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;

/** What the program does instead of simulating: options, and what follows. For one thread. */
public interface Subcommand {

  /** Reads what comes after the subcommand into its options, and explains them. */
  CommandLine commandLine(IVersionProvider version);

  /**
   * What is to be done, once its options are read.
   *
   * @throws IllegalArgumentException with a sentence, if the options do not fit together
   */
  Invocation.Action action(ProgramOutput output);
}
