package tellosimulator.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectMethod;
import static tellosimulator.junit.TelloAssertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.junit.platform.engine.DiscoverySelector;
import org.junit.platform.engine.reporting.OutputDirectoryProvider;
import org.junit.platform.testkit.engine.EngineExecutionResults;
import org.junit.platform.testkit.engine.EngineTestKit;
import org.junit.platform.testkit.engine.Event;
import tellosimulator.recording.RecordingFiles;

/**
 * The results that JUnit reports for tests with simulated drones, and the parameters of the tests.
 */
class TelloSimulatorExtensionTest {

  /** Records written by the samples below. */
  private static final List<String> SEEN = new CopyOnWriteArrayList<>();

  @TempDir private Path published;

  @BeforeEach
  void forget() {
    SEEN.clear();
  }

  // --- one simulator per class, reset before each test ---

  @TelloTest(drones = 2)
  static final class OneClass {

    private static int port;

    @BeforeAll
    static void isThereBeforeAllTests(SimulatedDrone drone) {
      port = drone.commandPort();
    }

    @BeforeEach
    void isNewBeforeEach(SimulatedDrone drone) {
      SEEN.add("takeoffs " + drone.truth().takeoffs());
    }

    @Test
    void first(SimulatedDrone drone, TelloSimulation simulation) throws IOException {
      fly(drone, "command", "takeoff", "forward 50");
      assertThat(drone).isFlying().isWithin(55).ofStart();
      SEEN.add(simulation.drone(2) + " of " + (drone.commandPort() == port));
    }

    @Test
    void second(@Drone(2) SimulatedDrone other, TelloSimulator simulator) throws IOException {
      assertThat(simulator.drone(1).journal().entries()).isEmpty();
      fly(other, "command", "takeoff", "land");
      assertThat(other).hasLanded();
      SEEN.add(other + " of " + (simulator.drone().commandPort() == port));
    }

    @Nested
    final class Inner {
      @Test
      void third(SimulatedDrone drone) {
        SEEN.add("nested of " + (drone.commandPort() == port));
      }
    }
  }

  @Test
  void aClassHasOneSimulatorThatBeginsAnewBeforeEachTest() {
    assertThat(failures(selectClass(OneClass.class))).isEmpty();

    assertThat(SEEN)
        .containsOnly("takeoffs 0", "drone 2 of true", "nested of true")
        .filteredOn(line -> line.startsWith("takeoffs"))
        .hasSize(3);
  }

  @TelloTest(scenario = "gate-race")
  static final class Outer {
    @Nested
    @TelloTest(drones = 2)
    final class WithItsOwn {
      @Test
      void sees(TelloSimulator simulator) {
        SEEN.add(simulator.drones().size() + " drones, " + simulator.simulation().goals());
      }
    }
  }

  @Test
  void aNestedClassMayHaveASimulatorOfItsOwn() {
    assertThat(failures(selectClass(Outer.class))).isEmpty();
    assertThat(failures(selectClass(Outer.WithItsOwn.class))).isEmpty();
    assertThat(SEEN).containsOnly("2 drones, the scenario has no goals");
  }

  @TelloTest
  static final class Closing {
    @Test
    void closes(TelloSimulator simulator) {
      simulator.close();
    }

    @Test
    void closesToo(TelloSimulator simulator) {
      simulator.close();
    }
  }

  @Test
  void whoeverClosesASharedSimulatorIsNamed() {
    assertThat(failures(selectClass(Closing.class)).values())
        .singleElement()
        .satisfies(
            failure ->
                assertThat(failure)
                    .hasMessageMatching(
                        "a test before closes.* closed the simulator that all tests of the class"
                            + " share; a parameter must not be closed"));
  }

  static final class OneMethod {
    @TelloTest(scenario = "slalom", profile = "tt")
    void slalom(SimulatedDrone drone) throws IOException {
      SEEN.add(fly(drone, "command", "hardware?").toString());
    }

    @Test
    void without() {
      SEEN.add("without");
    }
  }

  @Test
  void aMethodHasASimulatorOfItsOwn() {
    assertThat(failures(selectClass(OneMethod.class))).isEmpty();
    assertThat(SEEN).containsExactlyInAnyOrder("[ok, RMTT]", "without");
  }

  static final class Registered {
    @RegisterExtension
    static final TelloSimulatorExtension OF_CLASS =
        TelloSimulatorExtension.builder().scenario("gate-race").onCrash(OnCrash.ALLOW).build();

    @Test
    void sees(TelloSimulation simulation) {
      SEEN.add(simulation.goals().open().size() + " goals");
    }
  }

  static final class RegisteredForEach {
    @RegisterExtension
    final TelloSimulatorExtension ofTest = TelloSimulatorExtension.builder().drones(3).build();

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void sees(int number, TelloSimulation simulation) {
      SEEN.add(simulation.drone(number).toString());
    }
  }

  @Test
  void anExtensionIsToldByItsBuilder() {
    assertThat(failures(selectClass(Registered.class))).isEmpty();
    assertThat(failures(selectClass(RegisteredForEach.class))).isEmpty();
    assertThat(SEEN).containsExactly("4 goals", "drone 1", "drone 3");
  }

  @TelloTest
  static final class Beside {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
    void others(int number, SimulatedDrone drone) throws IOException {
      fly(drone, "command", "takeoff", "land");
      assertThat(drone.journal().commands()).hasSize(3);
      SEEN.add("test " + number);
    }
  }

  @Test
  void testsOfAClassTakeTurnsThoughJUnitRunsThemBesideEachOther() {
    assertThat(failures(true, selectClass(Beside.class))).isEmpty();
    assertThat(SEEN).hasSize(8);
  }

  // --- failures ---

  @TelloTest(scenario = "gate-race")
  static final class Failing {

    @Test
    void stopsBeforeTheGate(SimulatedDrone drone) throws IOException {
      fly(drone, "command", "takeoff", "foward 50");
      assertThat(drone).hasLanded();
    }

    @Test
    void expectsAnotherValue(SimulatedDrone drone) throws IOException {
      Assertions.assertEquals("50", fly(drone, "command", "battery?").get(1));
    }

    @Test
    void throwsSomethingElse(SimulatedDrone drone) throws IOException {
      fly(drone, "command");
      throw new IOException("the program ended");
    }

    @Test
    void crashes(SimulatedDrone drone) throws IOException {
      fly(drone, "command", "takeoff", "up 170");
      ScriptedOperator.send(drone, "emergency");
    }

    @Test
    void missesTheGates(SimulatedDrone drone) throws IOException {
      fly(drone, "command", "takeoff", "land");
    }

    @Test
    void doesNothing() {}
  }

  @Test
  void aFailureExplainsItself() {
    Throwable failure =
        failures(method(Failing.class, "stopsBeforeTheGate")).get("stopsBeforeTheGate");

    assertThat(failure).isInstanceOf(AssertionError.class);
    assertThat(failure.getMessage().lines().map(TelloSimulatorExtensionTest::blurred))
        .containsExactly(
            "drone 1 has not landed: it flies at x -200, y -100, z 30 cm",
            "last command to drone 1: # s  `foward 50` → `unknown command: foward 50` after # s:"
                + " there is no such command, did you mean `forward 50`?",
            "drone 1: flies at x -200, y -100, z 30 cm, heading 0 degrees, battery 100 %; took off"
                + " once, was up to 30 cm high and 0 cm from its start",
            "goals: 0 of 4 goals reached; open: 1. fly through gate A; 2. fly through"
                + " gate B; 3. fly through gate C; 4. land at x 150, y 150 cm",
            "",
            "what came to drone 1:",
            "# s  `command` → `ok` after # s",
            "# s  `takeoff` → `ok` after # s",
            "# s  `foward 50` → `unknown command: foward 50` after # s: there is no such command,"
                + " did you mean `forward 50`?");
  }

  @Test
  void whatWasExpectedStaysKnownToTools() {
    Throwable failure =
        failures(method(Failing.class, "expectsAnotherValue")).get("expectsAnotherValue");

    assertThat(failure).isInstanceOf(org.opentest4j.AssertionFailedError.class);
    org.opentest4j.AssertionFailedError error = (org.opentest4j.AssertionFailedError) failure;
    assertThat(error.getExpected().getStringRepresentation()).isEqualTo("50");
    assertThat(error.getActual().getStringRepresentation()).isEqualTo("100");
    assertThat(error).hasMessageContaining("`battery?` → `100`");
    assertThat(error.getStackTrace()).isEqualTo(error.getCause().getStackTrace());
  }

  @Test
  void otherFailuresStayWhatTheyAreAndAreExplainedBeside() {
    Throwable failure =
        failures(method(Failing.class, "throwsSomethingElse")).get("throwsSomethingElse");

    assertThat(failure).isInstanceOf(IOException.class).hasMessage("the program ended");
    assertThat(failure.getSuppressed()).hasSize(1);
    assertThat(failure.getSuppressed()[0]).hasMessageContaining("`command` → `ok`");
  }

  @Test
  void crashesAndMissedGoalsFailTestsThatAssertNothing() {
    Map<String, Throwable> failures = failures(selectClass(Failing.class));

    assertThat(blurred(failures.get("crashes").getMessage().lines().findFirst().orElseThrow()))
        .isEqualTo(
            "drone 1 crashed into the floor at # s with # cm/s; onCrash = ALLOW would let that"
                + " pass");
    assertThat(failures.get("missesTheGates").getMessage())
        .startsWith("the goals were missed; onCrash = ALLOW would let that pass");
    assertThat(failures).doesNotContainKey("doesNothing").hasSize(5);
  }

  @Tag("process")
  @TelloTest(onCrash = OnCrash.ALLOW)
  static final class Forgetting {
    @Test
    void namesAProgram(SimulatedDrone drone) {
      assertThat(drone.program("python3", "fly.py").output()).isEmpty();
    }
  }

  @Test
  void aProgramThatIsNamedAndNeverRunFailsItsTest() {
    assertThat(failures(selectClass(Forgetting.class)).get("namesAProgram"))
        .hasMessage("the program python3 fly.py was never run: call run() or exitCode() of it");
  }

  @TelloTest(scenario = "gate-race", onCrash = OnCrash.ALLOW)
  static final class Allowing {
    @Test
    void crashes(SimulatedDrone drone) throws IOException {
      new Failing().crashes(drone);
      assertThat(drone).hasCrashed();
    }
  }

  @Test
  void crashesCanBeAllowed() {
    assertThat(failures(selectClass(Allowing.class))).isEmpty();
  }

  @Test
  void theFlightOfAFailedTestIsPublishedAsAFile() throws IOException {
    failures(method(Failing.class, "missesTheGates"));

    Path found = published("tello-flight.txt").get(0);
    assertThat(Files.readString(found))
        .startsWith("missesTheGates(SimulatedDrone)")
        .contains("`land` → `ok`");
  }

  private List<Path> published(String name) throws IOException {
    try (Stream<Path> files = Files.walk(published)) {
      return files.filter(file -> file.endsWith(name)).toList();
    }
  }

  @TelloTest
  @TestMethodOrder(MethodOrderer.MethodName.class)
  static final class FlyingTwice {

    @Test
    void first(SimulatedDrone drone) throws IOException {
      fly(drone, "command", "takeoff", "up 50", "land");
    }

    @Test
    void second(SimulatedDrone drone) throws IOException {
      fly(drone, "command", "takeoff", "up 30", "land", "takeoff");
      assertThat(drone).hasCrashed();
    }

    @Test
    void third(SimulatedDrone drone) throws IOException {
      fly(drone, "command");
      assertThat(drone).isFlying();
    }
  }

  @Test
  void aFailedTestHasTheRecordingsOfItsFlightsAndAnotherTestHasNone() throws IOException {
    assertThat(failures(selectClass(FlyingTwice.class))).containsOnlyKeys("second", "third");

    RecordingFiles files = RecordingFiles.only(published("tello-recordings").get(0));
    assertThat(published("tello-recordings")).as("the third did not fly").hasSize(1);
    assertThat(files.wire("command"))
        .extracting(datagram -> datagram.get("text"))
        .containsExactly("command", "takeoff", "up 30", "land", "takeoff");
    assertThat(files.run()).containsKeys("started", "ended");
    assertThat(files.rows()).hasSizeGreaterThan(100);
    assertThat(files.has("scenario.yaml")).isTrue();
    assertThat(published("tello-flight.html"))
        .singleElement()
        .satisfies(page -> assertThat(page).content().contains("<title>", "\"up 30\""));
  }

  @TelloTest
  static final class Refused {
    @Test
    void fails(SimulatedDrone drone) throws IOException {
      fly(drone, "command", "takeoff", "takeoff");
      assertThat(drone).hasCrashed();
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          de-AT | de | Flugbericht   | fliegt schon
          en-GB | en | flight report | flies already
          fr-FR | en | flight report | flies already
          """)
  void thePageSpeaksTheLanguageOfTheSystem(
      String system, String language, String title, String reason) throws IOException {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.forLanguageTag(system));
    try {
      assertThat(failures(selectClass(Refused.class))).containsOnlyKeys("fails");
    } finally {
      Locale.setDefault(before);
    }

    assertThat(published("tello-flight.html"))
        .singleElement()
        .satisfies(
            page ->
                assertThat(page)
                    .content()
                    .contains("<html lang=\"" + language + "\">", title, reason));
  }

  // --- mistakes ---

  @TelloTest(scenario = "slalon")
  static final class Misspelt {
    @Test
    void never() {}
  }

  static final class MisspeltMethod {
    @TelloTest(behavior = "mesured")
    void never() {}
  }

  @TelloTest
  static final class WrongDrone {
    @Test
    void never(@Drone(2) SimulatedDrone drone) {
      SEEN.add(drone.toString());
    }
  }

  @Test
  void mistakesAreNamedWhereTheyAre() {
    assertThat(failures(selectClass(Misspelt.class)).values())
        .singleElement()
        .satisfies(
            failure ->
                assertThat(failure)
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage(
                        "@TelloTest of class "
                            + Misspelt.class.getName()
                            + ": there is neither a file"
                            + " nor a scenario slalon, did you mean slalom?"));
    assertThat(failures(selectClass(MisspeltMethod.class)).get("never"))
        .hasMessageEndingWith(
            ".never(): behavior is mesured, but must be one of report, measured, did you mean"
                + " measured?");
    assertThat(failures(selectClass(WrongDrone.class)).get("never"))
        .hasMessageContaining("@Drone(2) in never: there is no drone 2, only drone 1");
    assertThat(SEEN).isEmpty();
  }

  // --- running samples ---

  private static List<String> fly(SimulatedDrone drone, String... commands) throws IOException {
    return ScriptedOperator.fly(drone, commands);
  }

  private static DiscoverySelector method(Class<?> sample, String name) {
    return selectMethod(sample, name, SimulatedDrone.class.getName());
  }

  private Map<String, Throwable> failures(DiscoverySelector selector) {
    return failures(false, selector);
  }

  /** Returns the failures of samples by their names. */
  private Map<String, Throwable> failures(boolean parallel, DiscoverySelector selector) {
    OutputDirectoryProvider output =
        new OutputDirectoryProvider() {
          @Override
          public Path getRootDirectory() {
            return published;
          }

          @Override
          public Path createOutputDirectory(org.junit.platform.engine.TestDescriptor test)
              throws IOException {
            return Files.createDirectories(
                published.resolve(test.getDisplayName().replaceAll("\\W", "")));
          }
        };
    EngineExecutionResults results =
        EngineTestKit.engine("junit-jupiter")
            .selectors(selector)
            .outputDirectoryProvider(output)
            .configurationParameter("junit.jupiter.execution.parallel.enabled", "" + parallel)
            .configurationParameter("junit.jupiter.execution.parallel.mode.default", "concurrent")
            .execute();
    assertThat(results.allEvents().started().count()).isGreaterThan(1);
    return results.allEvents().failed().stream()
        .collect(
            Collectors.toMap(
                event -> event.getTestDescriptor().getDisplayName().replaceAll("\\(.*", ""),
                TelloSimulatorExtensionTest::failure));
  }

  private static Throwable failure(Event event) {
    return event
        .getPayload(org.junit.platform.engine.TestExecutionResult.class)
        .orElseThrow()
        .getThrowable()
        .orElseThrow();
  }

  /** Removes times and durations. */
  private static String blurred(String line) {
    return line.strip().replaceAll("[0-9]+(\\.[0-9]+)? (s|cm/s)\\b", "# $2");
  }
}
