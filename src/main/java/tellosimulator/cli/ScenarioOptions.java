package tellosimulator.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.TypeConversionException;
import tellosimulator.scenario.Description;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenery.texture.ImageFile;
import tellosimulator.world.Arena;
import tellosimulator.world.Poster;

/** The options that say which scenario is flown. */
public final class ScenarioOptions {

  static final String EXIT_WHEN_DONE = "--exit-when-done";
  static final String TIMEOUT = "--timeout";

  /** Given by {@code run}, whose program may go on for a while after the verdict. */
  static final String AWAIT_PROGRAM = "--await-program";

  private static final String SCENARIO = "--scenario";

  private final OptionValue<Optional<OpenedScenario>> scenario;
  private final OptionValue<Boolean> list;
  private final OptionValue<Boolean> exitWhenDone;
  private final OptionValue<Optional<Double>> timeout;
  private final OptionValue<Boolean> awaitProgram;

  ScenarioOptions(OptionList optionList) {
    scenario =
        optionList
            .option(
                SCENARIO,
                "FILE|NAME",
                "Room, drones and goals from a file, or from one of the scenarios that come with the"
                    + " program. Options that are given beside it count more than what it says, but"
                    + " --drones, --room and --start do not go with it.")
            .readIfGiven(ScenarioOptions::named);
    list =
        optionList.flag("--scenarios", "List the scenarios that come with the program, and end.");
    exitWhenDone =
        optionList.flag(
            EXIT_WHEN_DONE,
            "End when the goals of the scenario are reached or missed, after a line that says so:"
                + " exit code 0 if all were reached, 3 if not. They are missed, too, when all drones"
                + " have landed and no command came for 15 s, or none took off and no command came"
                + " for 60 s. Only with --headless.");
    timeout =
        optionList
            .option(
                TIMEOUT,
                "SECONDS",
                "As --exit-when-done, and the goals are missed after so many simulated seconds, for"
                    + " programs that never take off. With --time-factor max these pass at once when"
                    + " a program that has sent a command sends no other for 3 s of real time"
                    + " before it takes off, or none at all for 30 s.")
            .readIfGiven(OptionTypes::seconds);
    awaitProgram = optionList.hiddenFlag(AWAIT_PROGRAM);
  }

  /** Words of a command line; one that is a scenario file alone, as of a double click, opens it. */
  public static String[] withFileNamed(String... words) {
    return words.length == 1 && isFile(words[0]) ? new String[] {SCENARIO, words[0]} : words;
  }

  /** Whether a word looks like the name of a scenario file. */
  static boolean isFile(String word) {
    return word.matches("[^-].*\\.ya?ml");
  }

  Optional<Scenario> scenario() {
    return opened().map(OpenedScenario::scenario);
  }

  Optional<OpenedScenario> opened() {
    return scenario.value();
  }

  boolean list() {
    return list.value();
  }

  /** The option that lets a run end by itself, as it was given; empty if none was. */
  Optional<String> endsByItself() {
    return exitWhenDone.value() ? Optional.of(EXIT_WHEN_DONE) : timeout().map(seconds -> TIMEOUT);
  }

  boolean awaitsProgram() {
    return awaitProgram.value();
  }

  /** After how much simulated time the goals are missed [s]. */
  Optional<Double> timeout() {
    return timeout.value();
  }

  /** Says in a language which scenarios there are. */
  public static void list(PrintStream out, Locale language) {
    int longest = Gallery.NAMES.stream().mapToInt(String::length).max().orElse(0);
    for (String name : Gallery.NAMES) {
      String gap = " ".repeat(longest - name.length() + 2);
      Description description = Gallery.find(name).orElseThrow().description();
      out.println(name + gap + description.teaches().in(language));
    }
  }

  /**
   * Looks whether all pictures of a room can be read.
   *
   * @throws IllegalArgumentException with a sentence, if one cannot
   */
  static void checkPictures(Arena arena) {
    pictures(arena).forEach(ScenarioOptions::checkPicture);
  }

  /** The image files of a room. */
  static Stream<String> pictures(Arena arena) {
    Stream<String> onWalls = arena.decor().posters().stream().map(Poster::picture);
    Stream<String> onObstacles =
        arena.obstacles().stream().flatMap(each -> each.appearance().pictures().values().stream());
    return Stream.concat(onWalls, onObstacles).distinct();
  }

  private static void checkPicture(String file) {
    try {
      ImageFile.check(file);
    } catch (IOException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  private static OpenedScenario named(String word) throws ScenarioException {
    try {
      return OpenedScenario.named(word);
    } catch (IllegalArgumentException e) {
      throw new TypeConversionException(e.getMessage());
    }
  }
}
