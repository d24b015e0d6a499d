package tellosimulator.cli;

import java.util.List;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * The options of the command line, in the order of the help. Made by calls, because finding them as
 * annotations would take a fifth of the time until the program is ready.
 */
final class Choices {

  private static final String[] FOOTER = {
    "",
    "Two changes make an existing program fly the simulator on the same machine:",
    "the drone's address becomes 127.0.0.1, and the command port becomes 8879.",
    "",
    "While it runs, type: help, reset [N], power on|off [N], battery PERCENT [N],",
    "fault TEXT, pause, resume, state or quit. N is a drone's number; without it, all drones.",
    "",
    "report FOLDER, instead of options, makes an HTML file of a recording: report --help."
  };

  private final CommandSpec spec = CommandSpec.create().name("tello-simulator");

  Choices() {
    spec.usageMessage()
        .sortOptions(false)
        .autoWidth(true)
        .header("Simulates Tello drones: programs fly them over UDP as they fly real ones.")
        .footer(FOOTER);
  }

  /** Reads the command line into the choices, and explains them. */
  CommandLine commandLine(IVersionProvider version) {
    spec.mixinStandardHelpOptions(true).versionProvider(version);
    return new CommandLine(spec).setExpandAtFiles(false); // @ may begin the name of a file
  }

  /** An option without a value. */
  Choice<Boolean> flag(String name, String description) {
    return new Choice<>(
        added(OptionSpec.builder(name).description(description).type(boolean.class).arity("0")),
        false);
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
    return new Valued(
        OptionSpec.builder(name)
            .paramLabel(label)
            .description(description)
            .type(Object.class)
            .arity("1"));
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
    <T> Choice<T> read(ITypeConverter<T> converter, String byDefault) {
      return new Choice<>(added(builder.converters(converter)), converted(converter, byDefault));
    }

    /** The value is there if the option is given. */
    <T> Choice<Optional<T>> readIfGiven(ITypeConverter<T> converter) {
      ITypeConverter<Optional<T>> present = word -> Optional.of(converter.convert(word));
      return new Choice<>(added(builder.converters(present)), Optional.empty());
    }

    /** The option can be given several times. */
    <T> Choice<List<T>> readEach(ITypeConverter<T> converter) {
      builder.type(List.class).auxiliaryTypes(Object.class);
      return new Choice<>(added(builder.converters(converter)), List.of());
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
