package tellosimulator.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenario.ScenarioFile;

/** Reads scenario files, and says all that is wrong with them; nothing flies. For one thread. */
final class CheckSubcommand implements Subcommand {

  private final OptionList optionList =
      OptionList.of(
          SubcommandName.CHECK,
          "Checks scenario files, and says all that is wrong with each, with line and column.",
          "Exit code 0: all can be flown; 2: something is wrong.");

  private final Supplier<List<Path>> files = optionList.files("FILE", "A scenario file.");

  @Override
  public CommandLine commandLine(IVersionProvider version) {
    return optionList.commandLine(version);
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    return () -> {
      int code = ExitCode.DONE;
      for (Path file : files.get()) {
        try {
          ScenarioOptions.checkPictures(ScenarioFile.read(file).config().arena());
          to.out().println(file + ": no mistakes");
        } catch (ScenarioException | IllegalArgumentException e) {
          String where = e instanceof ScenarioException ? "" : file + ": ";
          to.err().println(where + e.getMessage());
          code = ExitCode.WRONG_OPTIONS;
        }
      }
      return code;
    };
  }
}
