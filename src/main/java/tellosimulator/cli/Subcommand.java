package tellosimulator.cli;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** What the program does instead of simulating, if its name is the first word. */
public enum Subcommand {
  /** Makes an HTML file of a recording. */
  REPORT,
  /** Compares two recordings. */
  DIFF,
  /** Writes a recording in the format of another tool. */
  EXPORT;

  /** The word that chooses it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The one that a command line begins with. */
  public static Optional<Subcommand> of(String... args) {
    return Stream.of(values())
        .filter(each -> args.length > 0 && each.word().equals(args[0]))
        .findFirst();
  }
}
