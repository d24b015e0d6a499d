package tellosimulator.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.files.AtomicFile;
import tellosimulator.files.IoReason;
import tellosimulator.scenario.CourseGenerator;
import tellosimulator.scenario.Difficulty;

/** Writes a generated scenario to a file or to the standard output. Not thread-safe. */
final class GenerateSubcommand extends Subcommand {

  private static final String KINDS =
      Stream.of(CourseGenerator.Kind.values())
          .map(CourseGenerator.Kind::word)
          .collect(Collectors.joining(", "));

  private final Supplier<CourseGenerator.Kind> kind =
      optionList.word(
          "KIND",
          "The kind of course: " + KINDS + ".",
          CourseGenerator.Kind.values(),
          CourseGenerator.Kind::word);

  private final OptionValue<Long> seed =
      optionList
          .option("--seed", "N", "Another seed gives another course.")
          .read(OptionTypes::seed, "1");

  private final OptionValue<Difficulty> difficulty =
      optionList
          .option("--difficulty", "easy|medium|hard", "How long and how narrow the course is.")
          .readOneOf(
              Difficulty.values(),
              level -> level.name().toLowerCase(Locale.ROOT),
              Difficulty.MEDIUM);

  private final OptionValue<Optional<Path>> output =
      optionList.output("The new file to write. Default: the standard output.");

  GenerateSubcommand() {
    super(
        SubcommandName.GENERATE,
        "Writes a scenario that is drawn from a seed, the same on every machine. KIND is "
            + KINDS
            + ".",
        "Exit code 0: written; 1: the file exists or cannot be written; 2: wrong options.");
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    return () -> {
      String text = CourseGenerator.generate(kind.get(), difficulty.value(), seed.value());
      if (output.value().isEmpty()) {
        to.out().writeBytes(text.getBytes(StandardCharsets.UTF_8));
        return ExitCode.DONE;
      }
      return write(text, output.value().get(), to);
    };
  }

  private static int write(String text, Path file, ProgramOutput to) {
    if (Files.exists(file)) {
      to.err().println(file + " exists already and was left as it is; name a new file.");
      return ExitCode.FAILED;
    }
    try {
      AtomicFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    } catch (IOException e) {
      to.err().println("No scenario was written to " + file + ": " + IoReason.of(e, file) + ".");
      return ExitCode.FAILED;
    }
    to.out().println("scenario: " + file);
    return ExitCode.DONE;
  }
}
