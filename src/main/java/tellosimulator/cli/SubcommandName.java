package tellosimulator.cli;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** The words that choose a {@link Subcommand}, if they come first on the command line. */
public enum SubcommandName {
  REPORT("makes an HTML file of a recording", ReportSubcommand::new),
  DIFF("compares two recordings, command by command", DiffSubcommand::new),
  EXPORT("writes a recording for Wireshark, Foxglove or PlotJuggler", ExportSubcommand::new),
  PROXY("stands between programs and a real drone, and records", ProxySubcommand::new),
  REPLAY("flies a recording again, and compares", ReplaySubcommand::new),
  CHECK("says what is wrong with scenario files", CheckSubcommand::new),
  RUN("flies an unchanged program where the drone is 192.168.10.1", RunSubcommand::new);

  private final String does;
  private final Supplier<Subcommand> subcommand;

  SubcommandName(String does, Supplier<Subcommand> subcommand) {
    this.does = does;
    this.subcommand = subcommand;
  }

  /** As it is typed. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What it does, in a few words that go on from its name. */
  String does() {
    return does;
  }

  /** A new one, whose options are still to be read. */
  public Subcommand subcommand() {
    return subcommand.get();
  }

  /** As all of them are typed. */
  public static List<String> words() {
    return Stream.of(values()).map(SubcommandName::word).toList();
  }

  /** The one that a command line begins with. */
  public static Optional<SubcommandName> of(String... args) {
    return Stream.of(values())
        .filter(each -> args.length > 0 && each.word().equals(args[0]))
        .findFirst();
  }
}
