package tellosimulator.cli;

import tellosimulator.network.PortTakenException;
import tellosimulator.web.WebServer;

/** Serves the teacher's board, to which the simulators of a class report. Not thread-safe. */
final class BoardSubcommand extends Subcommand {

  private final OptionValue<Integer> port =
      optionList
          .option("--port", "PORT", "The port of the page; 0 chooses a free one.")
          .read(OptionTypes::portOrFree, "8090");

  private final OptionValue<Boolean> lan =
      optionList.flag("--lan", "Let simulators of other machines of the local network report.");

  BoardSubcommand() {
    super(
        SubcommandName.BOARD,
        "Shows the simulators of a class on one page, and starts, stops and resets them."
            + " The line that begins with web is the link to the page; the one that begins with"
            + " board is what the class gives to its simulators with --board.",
        "Exit code 0: ended by quit; 1: the port is not available; 2: wrong options.");
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    return () -> run(to);
  }

  private int run(ProgramOutput to) throws PortTakenException, InterruptedException {
    try (WebServer server = WebServer.board(NetworkOptions.webAddress(port.value(), lan.value()))) {
      server.lines().forEach(to.out()::println);
      to.out().flush();
      to.input().awaitQuit();
    }
    return ExitCode.DONE;
  }
}
