package tellosimulator.cli;

import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** What can be said after {@code report}. For one thread. */
public final class ReportOptions {

  /** Where the report goes if nobody says so, in the folder of the recording. */
  private static final String USUAL_NAME = "report.html";

  private final PositionalParamSpec folder =
      PositionalParamSpec.builder()
          .paramLabel("FOLDER")
          .description("The folder of a recording.")
          .type(Path.class)
          .converters(PathConverter.INSTANCE)
          .index("0")
          .arity("1")
          .required(true)
          .build();

  private final OptionSpec output =
      OptionSpec.builder("-o", "--output")
          .paramLabel("FILE")
          .description("The file to write. Default: " + USUAL_NAME + " in the folder.")
          .type(Path.class)
          .converters(PathConverter.INSTANCE)
          .arity("1")
          .build();

  /** Reads what comes after the subcommand into these options, and explains them. */
  public CommandLine commandLine(IVersionProvider version) {
    CommandSpec spec = CommandSpec.create().name("tello-simulator " + Subcommand.REPORT.word());
    spec.usageMessage()
        .sortOptions(false)
        .autoWidth(true)
        .header(
            "Makes a report of a recorded flight: one HTML file that opens in any browser,"
                + " without a network.")
        .footer("", "Exit code 0: written; 1: cannot be read or written; 2: wrong options.");
    spec.addPositional(folder).addOption(output);
    spec.mixinStandardHelpOptions(true).versionProvider(version);
    return new CommandLine(spec).setExpandAtFiles(false); // @ may begin the name of a folder
  }

  public Path folder() {
    return folder.getValue();
  }

  /** The file to write. */
  public Path output() {
    return Optional.<Path>ofNullable(output.getValue())
        .orElseGet(() -> folder().resolve(USUAL_NAME));
  }
}
