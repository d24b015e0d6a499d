package tellosimulator.cli;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;
import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.TypeConversionException;
import tellosimulator.export.ExportFormat;

/** What can be said after {@code export}. For one thread. */
public final class ExportOptions {

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

  private final OptionSpec format =
      OptionSpec.builder("--to")
          .paramLabel(words("|"))
          .description(
              "The format: pcap for Wireshark, mcap for Foxglove and PlotJuggler. flight.csv of the"
                  + " recording is a table already.")
          .type(ExportFormat.class)
          .converters(ExportOptions::format)
          .arity("1")
          .required(true)
          .build();

  private final OptionSpec output =
      OptionSpec.builder("-o", "--output")
          .paramLabel("FILE")
          .description("The file to write. Default: flight.pcap or flight.mcap in the folder.")
          .type(Path.class)
          .converters(PathConverter.INSTANCE)
          .arity("1")
          .build();

  /** Reads what comes after the subcommand into these options, and explains them. */
  public CommandLine commandLine(IVersionProvider version) {
    CommandSpec spec = CommandSpec.create().name("tello-simulator " + Subcommand.EXPORT.word());
    spec.usageMessage()
        .sortOptions(false)
        .autoWidth(true)
        .header("Writes a recorded flight in the format of another tool.")
        .footer("", "Exit code 0: written; 1: cannot be read or written; 2: wrong options.");
    spec.addPositional(folder).addOption(format).addOption(output);
    spec.mixinStandardHelpOptions(true).versionProvider(version);
    return new CommandLine(spec).setExpandAtFiles(false); // @ may begin the name of a folder
  }

  public Path folder() {
    return folder.getValue();
  }

  public ExportFormat format() {
    return format.getValue();
  }

  /** The file to write. */
  public Path output() {
    return Optional.<Path>ofNullable(output.getValue())
        .orElseGet(() -> folder().resolve("flight." + format().word()));
  }

  private static ExportFormat format(String word) {
    return Arrays.stream(ExportFormat.values())
        .filter(known -> known.word().equals(word))
        .findFirst()
        .orElseThrow(
            () ->
                new TypeConversionException(
                    "expected one of "
                        + words(", ")
                        + ", found "
                        + (word.isEmpty() ? "nothing" : word)));
  }

  private static String words(String between) {
    return Arrays.stream(ExportFormat.values())
        .map(ExportFormat::word)
        .collect(Collectors.joining(between));
  }
}
