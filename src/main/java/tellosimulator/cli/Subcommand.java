package tellosimulator.cli;

import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.UnreadableRecordingException;

/** What the program does instead of simulating: options, and what follows. For one thread. */
public interface Subcommand {

  /** Reads what comes after the subcommand into its options, and explains them. */
  CommandLine commandLine(IVersionProvider version);

  /**
   * Does it, once its options are read.
   *
   * @return the {@link ExitCode}
   * @throws UnreadableRecordingException if a recording that is named cannot be used
   * @throws PortTakenException if a port or an address cannot be had
   * @throws InterruptedException if the program is to end
   */
  int run(ProgramOutput output)
      throws UnreadableRecordingException, PortTakenException, InterruptedException;
}
