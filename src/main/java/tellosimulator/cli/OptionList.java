package tellosimulator.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/**
 * The options of a command line, in the order of the help. They are made by calls, because finding
 * them as annotations costs 80 ms of the start. Measured: a program of as many options alone, in
 * turns, medians of 21, 288 rather than 368 ms.
 */
final class OptionList {

  private static final String[] FOOTER = {
    "",
    "Two changes make an existing program fly the simulator on the same machine:",
    "the drone's address becomes 127.0.0.1, and the command port becomes 8879.",
    "",
    "While it runs, type: help, reset [N], power on|off [N], battery PERCENT [N],",
    "fault TEXT, pause, resume, state or quit. N is a drone's number; without it, all drones.",
    "",
    "A word in the place of the options does something else; it has a --help of its own:"
  };

  private static final String PROGRAM = "tello-simulator";

  private final CommandSpec spec;

  private OptionList(String name, String header, String... footer) {
    spec = CommandSpec.create().name(name);
    spec.usageMessage().sortOptions(false).autoWidth(true).header(header).footer(footer);
  }

  /** Those of the simulator. */
  static OptionList ofSimulator() {
    return new OptionList(
        PROGRAM,
        "Simulates Tello drones: programs fly them over UDP as they fly real ones.",
        Stream.concat(Stream.of(FOOTER), Stream.of(SubcommandName.values()).map(OptionList::row))
            .toArray(String[]::new));
  }

  private static String row(SubcommandName subcommand) {
    return String.format(Locale.ROOT, "  %-7s %s", subcommand.word(), subcommand.does());
  }

  /**
   * Those of a subcommand.
   *
   * @param does a sentence
   * @param exitCodes what they mean, in a sentence
   */
  static OptionList of(SubcommandName subcommand, String does, String exitCodes) {
    return new OptionList(PROGRAM + " " + subcommand.word(), does, "", exitCodes);
  }

  /** Reads the command line into the option values, and explains them. */
  CommandLine commandLine(IVersionProvider version) {
    spec.mixinStandardHelpOptions(true).versionProvider(version);
    return new CommandLine(spec).setExpandAtFiles(false); // @ may begin the name of a file
  }

  /** The options that were read last. */
  List<String> given() {
    return spec.commandLine().getParseResult().matchedOptions().stream()
        .map(OptionSpec::longestName)
        .toList();
  }

  /** The subcommand and the words that were read last, as they were typed. */
  List<String> words() {
    return Stream.concat(
            Stream.of(spec.name().replaceFirst(".* ", "")),
            spec.commandLine().getParseResult().originalArgs().stream())
        .toList();
  }

  /**
   * The folder of a recording, which must be named after those that are added before.
   *
   * @param label what stands for it in the help
   */
  Supplier<Path> recording(String label) {
    PositionalParamSpec folder =
        PositionalParamSpec.builder()
            .paramLabel(label)
            .description("The folder of a recording, or its run.json.")
            .type(Path.class)
            .converters((ITypeConverter<Path>) OptionTypes::recording)
            .index(Integer.toString(spec.positionalParameters().size()))
            .arity("1")
            .required(true)
            .build();
    spec.addPositional(folder);
    return folder::getValue;
  }

  /**
   * Files, at least one.
   *
   * @param label what stands for each in the help
   */
  Supplier<List<Path>> files(String label, String description) {
    PositionalParamSpec files =
        PositionalParamSpec.builder()
            .paramLabel(label)
            .description(description)
            .type(List.class)
            .auxiliaryTypes(Path.class)
            .converters((ITypeConverter<Path>) OptionTypes::fileOrFolder)
            .index("0..*")
            .arity("1..*")
            .required(true)
            .build();
    spec.addPositional(files);
    return files::getValue;
  }

  /**
   * Lets any words follow, also such as look like options; {@link #words} has them.
   *
   * @param label what stands for them in the help
   */
  void anyWords(String label, String description) {
    spec.parser().unmatchedOptionsArePositionalParams(true);
    spec.addPositional(
        PositionalParamSpec.builder()
            .paramLabel(label)
            .description(description)
            .type(List.class)
            .auxiliaryTypes(String.class)
            .index("0..*")
            .arity("0..*")
            .hideParamSyntax(true)
            .build());
  }

  /** The file that a subcommand writes. */
  OptionValue<Optional<Path>> output(String description) {
    return new Valued(valued(description, "FILE", "-o", "--output"))
        .readIfGiven(OptionTypes::outputFile);
  }

  /** An option without a value. */
  OptionValue<Boolean> flag(String name, String description) {
    return new OptionValue<>(
        added(OptionSpec.builder(name).description(description).type(boolean.class).arity("0")),
        false);
  }

  /** An option without a value that the program gives to itself; the help leaves it out. */
  OptionValue<Boolean> hiddenFlag(String name) {
    return new OptionValue<>(
        added(OptionSpec.builder(name).hidden(true).type(boolean.class).arity("0")), false);
  }

  private OptionSpec added(OptionSpec.Builder builder) {
    OptionSpec option = builder.build();
    spec.addOption(option);
    return option;
  }

  /**
   * An option with a value.
   *
   * @param label what stands for the value in the help
   */
  Valued option(String name, String label, String description) {
    return new Valued(valued(description, label, name));
  }

  private static OptionSpec.Builder valued(String description, String label, String... names) {
    return OptionSpec.builder(names)
        .paramLabel(label)
        .description(description)
        .type(Object.class)
        .arity("1");
  }

  /** An option with a value, of which it is still to be said how it is read. */
  final class Valued {

    private final OptionSpec.Builder builder;

    private Valued(OptionSpec.Builder builder) {
      this.builder = builder;
    }

    /**
     * The value is always there.
     *
     * @param byDefault what is read if the option is not given
     */
    <T> OptionValue<T> read(ITypeConverter<T> converter, String byDefault) {
      return new OptionValue<>(
          added(builder.converters(converter)), converted(converter, byDefault));
    }

    /** The value is there if the option is given. */
    <T> OptionValue<Optional<T>> readIfGiven(ITypeConverter<T> converter) {
      ITypeConverter<Optional<T>> present = word -> Optional.of(converter.convert(word));
      return new OptionValue<>(added(builder.converters(present)), Optional.empty());
    }

    /** The option must be given. */
    <T> Supplier<T> readRequired(ITypeConverter<T> converter) {
      OptionSpec option = added(builder.required(true).converters(converter));
      return option::getValue;
    }

    /** The option can be given several times. */
    <T> OptionValue<List<T>> readEach(ITypeConverter<T> converter) {
      builder.type(List.class).auxiliaryTypes(Object.class);
      return new OptionValue<>(added(builder.converters(converter)), List.of());
    }

    private static <T> T converted(ITypeConverter<T> converter, String word) {
      try {
        return converter.convert(word);
      } catch (Exception e) {
        throw new IllegalArgumentException("the default " + word + " cannot be read", e);
      }
    }
  }
}
