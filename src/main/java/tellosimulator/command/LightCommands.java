package tellosimulator.command;

import java.util.Optional;
import tellosimulator.board.LightOrder;
import tellosimulator.command.CommandParser.Parsed;
import tellosimulator.profile.Profile;

/** Tells what commands tell the lights of an extension board. For any thread. */
public final class LightCommands {

  private static final CommandParser PARSER = new CommandParser(Profile.TT);

  private LightCommands() {}

  /**
   * The order to the lights that a command gives; empty if it is another one, or would be refused.
   *
   * @param text as it is sent, one character a byte
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
