package tellosimulator.command;

import java.util.Optional;
import tellosimulator.command.CommandParser.Parsed;
import tellosimulator.extension.LightOrder;
import tellosimulator.profile.Profile;

/** Parses {@code EXT} light commands of an extension board. Thread-safe. */
public final class LightCommands {

  private static final CommandParser PARSER = new CommandParser(Profile.TT);

  private LightCommands() {}

  /**
   * Returns the light order in a command; empty if the text is not a light command, or would be
   * refused.
   *
   * @param text the text as sent, one character per byte
   */
  public static Optional<LightOrder> order(String text) {
    return PARSER
        .parse(text)
        .filter(parsed -> parsed.complaint().isEmpty())
        .map(Parsed::command)
        .filter(Command.Light.class::isInstance)
        .map(command -> ((Command.Light) command).order());
  }
}
