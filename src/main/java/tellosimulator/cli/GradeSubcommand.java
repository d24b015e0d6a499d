package tellosimulator.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.TypeConversionException;
import tellosimulator.concurrent.TerminationSignals;
import tellosimulator.files.IoReason;
import tellosimulator.files.TemporaryFolder;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.grade.Grades;
import tellosimulator.grade.Grading;
import tellosimulator.grade.Grading.Request;
import tellosimulator.grade.Grading.Shard;
import tellosimulator.grade.HandIn;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.FlightResult.ScoreEntry;
import tellosimulator.report.ClassReport;
import tellosimulator.report.GradeFormat;
import tellosimulator.report.ReportTexts;
import tellosimulator.words.Phrase;
import tellosimulator.words.Printable;

/** Grades the programs of a class. Not thread-safe. */
final class GradeSubcommand extends Subcommand {

  private final Supplier<List<Path>> files =
      optionList.files(
          "FILE",
          "The assignment, and the hand-ins: a folder of folders or files, a zip, or one file. With"
              + " --merge and --regrade: folders of results.");

  private final OptionValue<Optional<Path>> output =
      optionList.outputFolder("The folder of the results. Default: grades.");

  private final OptionValue<Boolean> check =
      optionList.flag(
          "--check",
          "Say what is wrong with the assignment, the courses and the"
              + " hand-ins, and fly nothing.");

  private final OptionValue<Optional<Path>> roster =
      optionList
          .option("--roster", "FILE", "The class: a CSV file with name, id and group.")
          .readIfGiven(OptionTypes::fileOrFolder);

  private final OptionValue<Optional<String>> only =
      optionList
          .option("--only", "NAME", "Grade one hand-in, and keep the results of the others.")
          .readIfGiven(word -> word);

  private final OptionValue<Optional<Integer>> jobs =
      optionList
          .option("--jobs", "N", "How many flights at a time. Default: the number of processors.")
          .readIfGiven(OptionTypes::jobs);

  private final OptionValue<Shard> shard =
      optionList
          .option("--shard", "I/N", "Grade every Nth hand-in, beginning with the Ith.")
          .read(GradeSubcommand::shard, "1/1");

  private final OptionValue<Boolean> merge =
      optionList.flag("--merge", "Merge results of shards, whose folders are given, into one.");

  private final OptionValue<Boolean> regrade =
      optionList.flag(
          "--regrade", "Compute the points again from the recordings in a folder of results.");

  private final OptionValue<Optional<List<GradeFormat>>> formats =
      optionList
          .option(
              "--format",
              "FORMAT[,FORMAT]",
              "Also write the grades for other systems: "
                  + Stream.of(GradeFormat.values())
                      .map(GradeFormat::option)
                      .collect(Collectors.joining(", "))
                  + "; several are separated by commas.")
          .readIfGiven(GradeSubcommand::formats);

  private final OptionValue<Boolean> leaderboard =
      optionList.flag(
          "--leaderboard", "Also write leaderboard.html: ranks and points, without names.");

  private final OptionValue<Boolean> self =
      optionList.flag("--self", "Fly one program as it will be graded, and print its points.");

  GradeSubcommand() {
    super(
        SubcommandName.GRADE,
        "Flies the programs that a class has handed in on the courses of an assignment, each"
            + " confined to itself, and writes points and grades. What is there already is not"
            + " flown again.",
        "Exit code 0: graded; 1: cannot be read, flown or written; 2: the assignment, a course or"
            + " an option is wrong; 130: Ctrl-C, after which the same command goes on.");
  }

  private static List<GradeFormat> formats(String words) {
    return Stream.of(words.split(",", -1))
        .map(word -> OptionTypes.byName(word, GradeFormat.values(), GradeFormat::option))
        .distinct()
        .toList();
  }

  private static Shard shard(String word) {
    if (!word.matches("[0-9]{1,6}/[0-9]{1,6}")) {
      throw new TypeConversionException("expected a shard such as 1/4, found " + word);
    }
    String[] parts = word.split("/", -1);
    try {
      return new Shard(Integer.parseInt(parts[0]), Integer.parseInt(parts[1]));
    } catch (IllegalArgumentException e) {
      throw new TypeConversionException(e.getMessage());
    }
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    List<Path> given = files.get();
    if (merge.value()) {
      Path into =
          output.value().orElseThrow(() -> new IllegalArgumentException("--merge needs -o DIR"));
      refuseOthers(merge, output, formats, leaderboard);
      return () -> written(() -> Grading.merge(given, into), into, to);
    }
    if (regrade.value()) {
      if (given.size() != 1) {
        throw new IllegalArgumentException("--regrade needs one folder of results");
      }
      refuseOthers(regrade, formats, leaderboard);
      List<String> unread = new ArrayList<>();
      return () -> {
        int code = written(() -> Grading.regrade(given.get(0), unread::add), given.get(0), to);
        unread.forEach(to.err()::println);
        return unread.isEmpty() ? code : ExitCode.FAILED;
      };
    }
    if (given.size() > 2 || (given.size() < 2 && !check.value())) {
      throw new IllegalArgumentException(
          "grade needs an assignment and hand-ins, such as: grade assignment.yaml hand-ins");
    }
    Path handIns = given.size() == 2 ? given.get(1) : Path.of("");
    return () -> self.value() ? gradeSelf(handIns, to) : grade(handIns, into(), to);
  }

  /** Refuses options that would be ignored together with another one. */
  private void refuseOthers(OptionValue<?> with, OptionValue<?>... fitting) {
    List<String> others = new ArrayList<>(optionList.given());
    others.remove(with.name());
    Stream.of(fitting).map(OptionValue::name).forEach(others::remove);
    if (!others.isEmpty()) {
      throw new IllegalArgumentException(others.get(0) + " does not go with " + with.name());
    }
  }

  private int jobsAtATime() {
    return jobs.value().orElse(Runtime.getRuntime().availableProcessors());
  }

  private Path into() {
    return output.value().orElse(Path.of("grades"));
  }

  /** Produces grades. */
  @FunctionalInterface
  private interface Source {
    Grades get() throws IOException, InterruptedException;
  }

  private int written(Source source, Path into, ProgramOutput to) throws InterruptedException {
    try {
      Grades grades = source.get();
      print(grades, to);
      boolean pages = writePages(grades, into, to);
      boolean whole = whole(grades, to);
      boolean missing = merge.value() && !grades.complete();
      if (missing) {
        to.err()
            .println(
                "These are the grades of "
                    + grades.handIns().size()
                    + " of "
                    + grades.all()
                    + " hand-ins: grade or merge the others, too.");
      }
      return whole && pages && !missing ? ExitCode.DONE : ExitCode.FAILED;
    } catch (IOException e) {
      to.err().println("The grades were not written: " + IoReason.of(e, into) + ".");
      return ExitCode.FAILED;
    }
  }

  /** Returns whether all flights could be graded; otherwise prints whose could not. */
  private static boolean whole(Grades grades, ProgramOutput to) {
    List<String> names =
        grades.handIns().stream()
            .filter(each -> each.flights().stream().anyMatch(GradedFlight::failed))
            .map(each -> Printable.of(each.name()))
            .toList();
    if (!names.isEmpty()) {
      to.err()
          .println(
              "The simulator failed in flights of these hand-ins; grade again to fly them again: "
                  + String.join(", ", names)
                  + ".");
    }
    return names.isEmpty();
  }

  private Optional<Grading> open(Path handIns, Path into, ProgramOutput to) {
    List<String> errors = new ArrayList<>();
    Request request =
        new Request(files.get().get(0), handIns, into, roster.value(), only.value(), shard.value());
    Optional<Grading> grading = Grading.open(request, errors);
    errors.forEach(to.err()::println);
    return grading;
  }

  private int gradeSelf(Path program, ProgramOutput to) throws InterruptedException {
    try (TemporaryFolder into = TemporaryFolder.create("tello-self")) {
      to.input().atEnd().accept(into::close);
      return grade(program, output.value().orElse(into.path()), to);
    } catch (IOException e) {
      to.err().println("There is no place for the flights: " + IoReason.of(e) + ".");
      return ExitCode.FAILED;
    }
  }

  @SuppressWarnings("try") // the signal handler only needs to be kept open
  private int grade(Path handIns, Path into, ProgramOutput to) throws InterruptedException {
    Optional<Grading> opened = open(handIns, into, to);
    if (opened.isEmpty()) {
      return ExitCode.WRONG_OPTIONS;
    }
    AtomicInteger signal = new AtomicInteger();
    try (Grading grading = opened.get();
        TerminationSignals signals =
            TerminationSignals.take(
                number -> {
                  signal.compareAndSet(0, number);
                  grading.close();
                })) {
      if (check.value()) {
        return checked(grading, to);
      }
      Grades grades =
          grading.grade(
              RunSubcommand.ownCommand(), jobsAtATime(), to.out()::println, new GradingBar(to));
      print(grades, to);
      boolean pages = !self.value() || output.value().isPresent();
      boolean written = !pages || writePages(grades, into, to);
      boolean whole = whole(grades, to);
      if (signal.get() == 0) {
        return written && whole ? ExitCode.DONE : ExitCode.FAILED;
      }
      to.out().println("Grading was interrupted; the same command goes on with what is missing.");
      return 128 + signal.get();
    } catch (IOException e) {
      to.err().println("The hand-ins were not graded: " + IoReason.of(e, into) + ".");
      return ExitCode.FAILED;
    }
  }

  /** Returns whether everything was written. */
  private boolean writePages(Grades grades, Path into, ProgramOutput to) throws IOException {
    to.out().println("grades: " + into.resolve(Grades.JSON));
    ClassReport report = new ClassReport(grades, into, new ReportTexts(to.translation().get()));
    boolean ranked =
        leaderboard.value()
            || (regrade.value() && Files.exists(into.resolve(ClassReport.LEADERBOARD)));
    to.out().println("class page: " + report.write(ranked));
    boolean all = true;
    for (GradeFormat format : formats.value().orElse(List.of())) {
      try {
        print(format, report.write(format), to);
      } catch (IOException e) {
        String reason = IoReason.of(e, into);
        to.err().println("There is no file for " + format.option() + ": " + reason + ".");
        all = false;
      }
    }
    return all;
  }

  /** Prints the files of a format; those of several hand-ins as a pattern. */
  private static void print(GradeFormat format, List<Path> files, ProgramOutput to) {
    if (files.size() > 2) {
      Path first = files.get(0);
      Path pattern = first.getParent().resolveSibling("*").resolve(first.getFileName());
      to.out().println(format.option() + ": " + pattern + ", files: " + files.size());
    } else {
      files.forEach(file -> to.out().println(format.option() + ": " + file));
    }
  }

  private int checked(Grading grading, ProgramOutput to) throws IOException {
    int wrong = 0;
    if (files.get().size() == 2) {
      for (HandIn found : grading.found()) {
        String file = found.file().isEmpty() ? found.obstacle() : found.file();
        to.out()
            .println(
                Printable.of(
                    found.name() + ": " + found.problem().map(Phrase::english).orElse(file)));
        wrong += found.file().isEmpty() ? 1 : 0;
      }
    }
    to.out()
        .println(
            files.get().get(0)
                + ": no mistakes"
                + (wrong == 0 ? "" : "; hand-ins that cannot be flown: " + wrong));
    return ExitCode.DONE;
  }

  private void print(Grades grades, ProgramOutput to) {
    for (GradedHandIn handIn : grades.handIns()) {
      to.out()
          .println(
              String.format(
                  Locale.ROOT,
                  "%s: %s of %s points, grade %s%s",
                  Printable.of(handIn.name()),
                  plain(handIn.points()),
                  plain(handIn.of()),
                  plain(handIn.grade()),
                  handIn.passed() ? "" : ", not passed"));
      for (GradedFlight flight : handIn.flights()) {
        FlightResult result = flight.result();
        to.out()
            .println(
                String.format(
                    Locale.ROOT,
                    "  %s, seed %d: %s; program: %s; goals: %d of %d; %s of %s points",
                    flight.course(),
                    flight.seed(),
                    result.verdict(),
                    flight.program(),
                    result.reached(),
                    result.goals().size(),
                    plain(result.points()),
                    plain(result.of())));
        if (self.value()) {
          result.score().ifPresent(score -> score.entries().forEach(each -> print(each, to)));
        }
      }
    }
  }

  private static void print(ScoreEntry entry, ProgramOutput to) {
    String points = (entry.points() > 0 ? "+" : "") + plain(entry.points());
    to.out()
        .println(
            String.format(
                Locale.ROOT, "    at %.1f s: %s points, %s", entry.second(), points, entry.why()));
  }

  private static String plain(double number) {
    return number == Math.rint(number)
        ? Long.toString(Math.round(number))
        : String.format(Locale.ROOT, "%.2f", number);
  }
}
