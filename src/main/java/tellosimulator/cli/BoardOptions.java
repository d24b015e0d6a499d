package tellosimulator.cli;

import java.net.URI;
import java.util.Optional;
import tellosimulator.web.BoardReporter;
import tellosimulator.web.ScenarioHost;

/** The options for the teacher's board. Not thread-safe. */
public final class BoardOptions {

  private static final String BOARD = "--board";

  private final OptionValue<Optional<URI>> board;
  private final OptionValue<Optional<String>> name;
  private final OptionValue<Optional<String>> team;

  BoardOptions(OptionList optionList) {
    board =
        optionList
            .option(
                BOARD,
                "URL",
                "Report to the teacher's board, which tello-simulator board starts: the address"
                    + " that it prints for simulators. The teacher sees the room, and can start,"
                    + " stop and reset.")
            .readIfGiven(OptionTypes::boardAddress);
    name =
        optionList
            .option("--name", "NAME", "Your name on the board. Default: that of your account.")
            .readIfGiven(word -> word);
    team = optionList.option("--team", "NAME", "Your team on the board.").readIfGiven(word -> word);
  }

  /**
   * Checks that a name has a board, and that a run that ends by itself has none.
   *
   * @param end the option because of which the run ends by itself
   * @throws IllegalArgumentException if the options are inconsistent; the message is one sentence
   */
  void check(Optional<String> end) {
    if (board.value().isPresent() && end.isPresent()) { // a new course would end it
      throw new IllegalArgumentException(BOARD + " does not go with " + end.get());
    }
    if (board.value().isEmpty() && (name.value().isPresent() || team.value().isPresent())) {
      throw new IllegalArgumentException("--name and --team need " + BOARD);
    }
  }

  /** Begins to report a simulator if the options say so. */
  public Optional<BoardReporter> report(ScenarioHost host) {
    return board
        .value()
        .map(
            to ->
                BoardReporter.start(
                    host,
                    to,
                    name.value().orElseGet(() -> System.getProperty("user.name", "")),
                    team.value().orElse("")));
  }
}
