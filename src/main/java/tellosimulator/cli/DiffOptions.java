package tellosimulator.cli;

import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** What can be said after {@code diff}. For one thread. */
public final class DiffOptions {

  private final PositionalParamSpec first = folder("A", 0);
  private final PositionalParamSpec second = folder("B", 1);

  private final OptionSpec output =
      OptionSpec.builder("-o", "--output")
          .paramLabel("FILE")
          .description("Also write the table and charts of both as an HTML file.")
          .type(Path.class)
          .converters(PathConverter.INSTANCE)
          .arity("1")
          .build();

  private static PositionalParamSpec folder(String label, int index) {
    return PositionalParamSpec.builder()
        .paramLabel(label)
        .description("The folder of a recording.")
        .type(Path.class)
        .converters(PathConverter.INSTANCE)
        .index(Integer.toString(index))
        .arity("1")
        .required(true)
        .build();
  }

  /** Reads what comes after the subcommand into these options, and explains them. */
  public CommandLine commandLine(IVersionProvider version) {
    CommandSpec spec = CommandSpec.create().name("tello-simulator " + Subcommand.DIFF.word());
    spec.usageMessage()
        .sortOptions(false)
        .autoWidth(true)
        .header(
            "Compares two recorded flights, command by command: replies, durations, and how the"
                + " drones moved as their state lines tell it.")
        .footer(
            "",
            "Exit code 0: alike; 4: they differ; 1: cannot be read or written; 2: wrong options.");
    spec.addPositional(first).addPositional(second).addOption(output);
    spec.mixinStandardHelpOptions(true).versionProvider(version);
    return new CommandLine(spec).setExpandAtFiles(false); // @ may begin the name of a folder
  }

  public Path first() {
    return first.getValue();
  }

  public Path second() {
    return second.getValue();
  }

  /** The file to write; empty for none. */
  public Optional<Path> output() {
    return Optional.ofNullable(output.getValue());
  }
}
