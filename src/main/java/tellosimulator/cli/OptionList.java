package tellosimulator.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/**
 * The options of a command line, in the order of the help. The options are declared by method calls
 * rather than annotations, because searching for annotations takes 80 ms at startup. Measured: a
 * program with this many options starts in 288 ms instead of 368 ms (medians of 21 alternating
 * runs).
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

  /** Creates the list for the simulator. */
  static OptionList ofSimulator() {
    return new OptionList(
        PROGRAM,
        "Simulates Tello drones: programs fly them over UDP as they fly real ones.",
        Stream.concat(Stream.of(FOOTER), Stream.of(SubcommandName.values()).map(OptionList::row))
            .toArray(String[]::new));
  }

  private static String row(SubcommandName subcommand) {
    return String.format(Locale.ROOT, "  %-8s %s", subcommand.word(), subcommand.does());
  }

  /**
   * Creates the list for a subcommand.
   *
   * @param does a sentence about the purpose of the subcommand
   * @param exitCodes a sentence about the meaning of its exit codes
   */
  static OptionList of(SubcommandName subcommand, String does, String exitCodes) {
    return new OptionList(PROGRAM + " " + subcommand.word(), does, "", exitCodes);
  }

  /** Returns a parser for these options. The parser also prints their help. */
  CommandLine commandLine(IVersionProvider version) {
    spec.mixinStandardHelpOptions(true).versionProvider(version);
    return new CommandLine(spec).setExpandAtFiles(false); // file names may begin with @
  }

  /** Returns the names of the options in the most recently parsed command line. */
  List<String> given() {
    return spec.commandLine().getParseResult().matchedOptions().stream()
        .map(OptionSpec::longestName)
        .toList();
  }

  /**
   * Returns the subcommand and the arguments of the most recently parsed command line, as they were
   * typed.
   */
  List<String> words() {
    return Stream.concat(
            Stream.of(spec.name().replaceFirst(".* ", "")),
            spec.commandLine().getParseResult().originalArgs().stream())
        .toList();
  }

  /**
   * Adds a positional parameter for the folder of a recording, after any positional parameters that
   * were added earlier.
   *
   * @param label the placeholder in the help
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
   * Adds a positional parameter for one or more files.
   *
   * @param label the placeholder for each file in the help
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

  /** Adds a required positional parameter that is one of several words. */
  <T> Supplier<T> word(String label, String description, T[] values, Function<T, String> name) {
    ITypeConverter<Object> converter = word -> OptionTypes.byName(word, values, name);
    PositionalParamSpec word =
        PositionalParamSpec.builder()
            .paramLabel(label)
            .description(description)
            .type(Object.class)
            .converters(converter)
            .index("0")
            .arity("1")
            .required(true)
            .build();
    spec.addPositional(word);
    return word::getValue;
  }

  /**
   * Accepts any remaining words, even those that look like options; {@link #words} also returns
   * these words.
   *
   * @param label the placeholder in the help
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

  /** Adds the option for the output file of a subcommand. */
  OptionValue<Optional<Path>> output(String description) {
    return new Valued(valued(description, "FILE", "-o", "--output"))
        .readIfGiven(OptionTypes::outputFile);
  }

  /** Adds the option for the output folder of a subcommand. */
  OptionValue<Optional<Path>> outputFolder(String description) {
    return new Valued(valued(description, "DIR", "-o", "--output"))
        .readIfGiven(OptionTypes::fileOrFolder);
  }

  /** Adds an option without a value. */
  OptionValue<Boolean> flag(String name, String description) {
    return new OptionValue<>(
        added(OptionSpec.builder(name).description(description).type(boolean.class).arity("0")),
        false);
  }

  /**
   * Adds an option without a value for internal use. Only the program itself passes the option, to
   * processes that it starts; the help omits the option.
   */
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
   * Starts the declaration of an option with a value.
   *
   * @param label the placeholder for the value in the help
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

  /** An option with a value; its converter must be set next. */
  final class Valued {

    private final OptionSpec.Builder builder;

    private Valued(OptionSpec.Builder builder) {
      this.builder = builder;
    }

    /**
     * Adds the option with a default value. The help states the default.
     *
     * @param byDefault the default value as a word, which the converter must accept
     */
    <T> OptionValue<T> read(ITypeConverter<T> converter, String byDefault) {
      builder.description(builder.description()[0] + " Default: " + byDefault + ".");
      return new OptionValue<>(
          added(builder.converters(converter)), converted(converter, byDefault));
    }

    /** Adds the option with a default value. Its value must be one of several words. */
    <T> OptionValue<T> readOneOf(T[] values, Function<T, String> name, T byDefault) {
      return read(word -> OptionTypes.byName(word, values, name), name.apply(byDefault));
    }

    /**
     * Lets the option be given without a value.
     *
     * @param value the value that it then has, as a word
     */
    Valued orAlone(String value) {
      builder.arity("0..1").fallbackValue(value);
      return this;
    }

    /** Adds the option without a default value. */
    <T> OptionValue<Optional<T>> readIfGiven(ITypeConverter<T> converter) {
      ITypeConverter<Optional<T>> present = word -> Optional.of(converter.convert(word));
      return new OptionValue<>(added(builder.converters(present)), Optional.empty());
    }

    /** Adds the option as required. */
    <T> Supplier<T> readRequired(ITypeConverter<T> converter) {
      OptionSpec option = added(builder.required(true).converters(converter));
      return option::getValue;
    }

    /** Adds the option as repeatable. */
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
