package tellosimulator.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.TypeConversionException;
import tellosimulator.scenario.Description;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenery.texture.ImageFile;
import tellosimulator.world.Arena;

/** The command-line options for the scenario. */
public final class ScenarioOptions {

  static final String EXIT_WHEN_DONE = "--exit-when-done";
  static final String TIMEOUT = "--timeout";

  /**
   * The option that {@code run} passes to the simulator, so that the operator program may continue
   * for a while after the verdict.
   */
  static final String AWAIT_PROGRAM = "--await-program";

  /** The option that {@code grade} passes to the simulator. */
  private static final String AWAIT_REPLIES = "--await-replies";

  private static final String SCENARIO = "--scenario";

  private final OptionValue<Optional<OpenedScenario>> scenario;
  final OptionValue<Boolean> list;
  private final OptionValue<Boolean> exitWhenDone;

  /** Simulated time after which the goals count as missed [s]. */
  final OptionValue<Optional<Double>> timeout;

  final OptionValue<Boolean> awaitProgram;

  /** Whether the run ends once the program turns out not to wait for replies. */
  final OptionValue<Boolean> awaitReplies;

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
                    + " (with run, 30 s) before it takes off, or none at all for 30 s.")
            .readIfGiven(OptionTypes::seconds);
    awaitProgram = optionList.hiddenFlag(AWAIT_PROGRAM);
    awaitReplies = optionList.hiddenFlag(AWAIT_REPLIES);
  }

  /**
   * Returns the arguments. A single argument that names a scenario file, as after a double click on
   * the file, is turned into an option, and so is the first word {@code web}.
   */
  public static String[] spelledOut(String... words) {
    if (words.length == 1 && isFile(words[0])) {
      return new String[] {SCENARIO, words[0]};
    }
    return words.length > 0 && words[0].equals("web")
        ? Stream.concat(Stream.of("--headless", "--web"), Arrays.stream(words).skip(1))
            .toArray(String[]::new)
        : words;
  }

  /** Returns whether a word looks like the name of a scenario file. */
  static boolean isFile(String word) {
    return word.matches("[^-].*\\.ya?ml");
  }

  /**
   * Returns the chosen scenario.
   *
   * @param seed the option that overrides the seed from which a course is drawn
   * @throws IllegalArgumentException if no course of the seed fits
   */
  Optional<OpenedScenario> opened(OptionValue<Long> seed) {
    try {
      return scenario.value().isPresent() && seed.given()
          ? Optional.of(scenario.value().get().drawnFrom(seed.value()))
          : scenario.value();
    } catch (ScenarioException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /**
   * Returns the name of an option that is given and makes a run end by itself; empty if there is
   * none.
   */
  Optional<String> endsByItself() {
    return exitWhenDone.value()
        ? Optional.of(EXIT_WHEN_DONE)
        : timeout.value().map(seconds -> TIMEOUT);
  }

  /**
   * Prints the available scenarios.
   *
   * @param language the language of their descriptions
   */
  public static void list(PrintStream out, Locale language) {
    int longest = Gallery.NAMES.stream().mapToInt(String::length).max().orElse(0);
    for (String name : Gallery.NAMES) {
      String gap = " ".repeat(longest - name.length() + 2);
      Description description = Gallery.find(name).orElseThrow().description();
      out.println(name + gap + description.teaches().in(language));
    }
  }

  /**
   * Checks that all pictures of a room can be read.
   *
   * @throws IllegalArgumentException if a picture cannot be read; the message is one sentence
   */
  static void checkPictures(Arena arena) {
    arena.pictures().forEach(ScenarioOptions::checkPicture);
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
