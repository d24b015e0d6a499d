package tellosimulator.cli;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * The names of the subcommands. A name selects its {@link Subcommand} if it is the first word of
 * the command line.
 */
public enum SubcommandName {
  REPORT("makes an HTML file of a recording", ReportSubcommand::new),
  DIFF("compares two recordings, command by command", DiffSubcommand::new),
  EXPORT("writes a recording for Wireshark, Foxglove or PlotJuggler", ExportSubcommand::new),
  PROXY("stands between programs and a real drone, and records", ProxySubcommand::new),
  REPLAY("flies a recording again, and compares", ReplaySubcommand::new),
  CHECK("says what is wrong with scenario files", CheckSubcommand::new),
  GENERATE("writes a scenario that is drawn from a seed", GenerateSubcommand::new),
  RUN("flies an unchanged program where the drone is 192.168.10.1", RunSubcommand::new),
  GRADE("flies and grades the programs of a class", GradeSubcommand::new),
  BOARD("shows the simulators of a class on one page", BoardSubcommand::new);

  private final String does;
  private final Supplier<Subcommand> subcommand;

  SubcommandName(String does, Supplier<Subcommand> subcommand) {
    this.does = does;
    this.subcommand = subcommand;
  }

  /** The word as it is typed. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** A few words that describe the subcommand's function, phrased to follow its name. */
  String does() {
    return does;
  }

  /** Creates the subcommand; its options are not parsed yet. */
  public Subcommand subcommand() {
    return subcommand.get();
  }

  /** The words of all subcommands. */
  public static List<String> words() {
    return Stream.of(values()).map(SubcommandName::word).toList();
  }

  /** Returns the subcommand that the first word of a command line names; empty if it names none. */
  public static Optional<SubcommandName> of(String... args) {
    return Stream.of(values())
        .filter(each -> args.length > 0 && each.word().equals(args[0]))
        .findFirst();
  }
}
