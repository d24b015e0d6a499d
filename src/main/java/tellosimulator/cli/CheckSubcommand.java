package tellosimulator.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenario.ScenarioFile;

/**
 * Reads scenario files and prints all errors in them, without simulating anything. Not thread-safe.
 */
final class CheckSubcommand extends Subcommand {

  /**
   * Number of courses that are drawn of a file with ranges. Decided: one that rarely fits fails.
   */
  private static final int COURSES = 20;

  private final Supplier<List<Path>> files = optionList.files("FILE", "A scenario file.");

  CheckSubcommand() {
    super(
        SubcommandName.CHECK,
        "Checks scenario files, and says all that is wrong with each, with line and column.",
        "Exit code 0: all can be flown; 2: something is wrong.");
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    return () -> {
      int code = ExitCode.DONE;
      for (Path file : files.get()) {
        try {
          OpenedScenario opened = OpenedScenario.of(ScenarioFile.open(file), file);
          ScenarioOptions.checkPictures(opened.scenario().config().arena());
          to.out().println(file + ": no mistakes" + courses(opened));
        } catch (ScenarioException | IllegalArgumentException e) {
          String where = e instanceof ScenarioException ? "" : file + ": ";
          to.err().println(where + e.getMessage());
          code = ExitCode.WRONG_OPTIONS;
        }
      }
      return code;
    };
  }

  /** Draws some courses if there are ranges, and returns a remark about them. */
  private static String courses(OpenedScenario opened) throws ScenarioException {
    for (long seed = 1; seed <= COURSES && opened.varies(); seed++) {
      opened.drawnFrom(seed);
    }
    return opened.varies() ? ", also with the seeds 1 to " + COURSES : "";
  }
}
