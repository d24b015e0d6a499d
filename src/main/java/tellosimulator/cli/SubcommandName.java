package tellosimulator.cli;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** The words that choose a {@link Subcommand}, if they come first on the command line. */
public enum SubcommandName {
  REPORT(ReportSubcommand::new),
  DIFF(DiffSubcommand::new),
  EXPORT(ExportSubcommand::new),
  PROXY(ProxySubcommand::new),
  REPLAY(ReplaySubcommand::new);

  private final Supplier<Subcommand> subcommand;

  SubcommandName(Supplier<Subcommand> subcommand) {
    this.subcommand = subcommand;
  }

  /** As it is typed. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** A new one, whose options are still to be read. */
  public Subcommand subcommand() {
    return subcommand.get();
  }

  /** The one that a command line begins with. */
  public static Optional<SubcommandName> of(String... args) {
    return Stream.of(values())
        .filter(each -> args.length > 0 && each.word().equals(args[0]))
        .findFirst();
  }
}
