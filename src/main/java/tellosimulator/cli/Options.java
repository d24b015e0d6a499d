package tellosimulator.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import tellosimulator.math.Pose;
import tellosimulator.network.AddressPlan;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.time.TimeFactor;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.world.Decor;
import tellosimulator.world.Poster;

/** What can be chosen on the command line, and what follows from it. */
public final class Options {

  static final String CAMERA_FOV = "--camera-fov";
  static final String CAMERA_TILT = "--camera-tilt";
  static final String HEADLESS = "--headless";
  static final String LOG_LEVEL = "--log-level";

  private static final String CONTROL = "--control";

  private final OptionList optionList = OptionList.ofSimulator();

  private final OptionValue<Boolean> headless = optionList.flag(HEADLESS, "Run without a window.");

  private final OptionValue<Boolean> on =
      optionList.flag("--on", "Switch all drones on at once. Without a window they always are.");

  private final ScenarioOptions scenarioOptions = new ScenarioOptions(optionList);

  private final NetworkOptions network = new NetworkOptions(optionList);

  private final OptionValue<Double> fieldOfViewDeg =
      optionList
          .option(
              CAMERA_FOV,
              "DEG|manual",
              "What the camera sees from left to right, in degrees: 55 as measured, or manual for"
                  + " the 82.6 degrees from corner to corner of the manual. Default: 55.")
          .read(OptionTypes::fieldOfView, "55");

  private final OptionValue<Double> tiltDeg =
      optionList
          .option(CAMERA_TILT, "DEG", "How far the camera looks down, in degrees. Default: 15.")
          .read(OptionTypes::tilt, "15");

  private final OptionValue<Optional<Integer>> drones =
      optionList
          .option(
              "--drones",
              "N",
              "How many drones to simulate. Default: 1, or as many as --bind has addresses.")
          .readIfGiven(OptionTypes::droneCount);

  private final OptionValue<Profile> profile =
      optionList
          .option(
              "--profile",
              "edu|tello|tt",
              "Which drone: Tello EDU, white Tello or RoboMaster TT. Default: edu.")
          .read(OptionTypes::profileName, "edu");

  private final OptionValue<Behavior> behavior =
      optionList
          .option(
              "--behaviour",
              "report|measured",
              "report: exact, and strict about commands that come too early. measured: with the"
                  + " noise, delays and errors of real drones. Default: report.")
          .read(OptionTypes::behaviorName, "report");

  private final FaultOptions faultOptions = new FaultOptions(optionList);

  private final RoomOptions roomOptions = new RoomOptions(optionList);

  private final OptionValue<TimeFactor> timeFactor =
      optionList
          .option(
              "--time-factor",
              "F|max",
              "How fast time passes: 5 is five times as fast. max runs as fast as the machine can"
                  + " while a drone moves, and waits for your program otherwise. Default: 1.")
          .read(OptionTypes::factor, "1");

  private final OptionValue<Boolean> noSafetyLanding =
      optionList.flag(
          "--no-safety-landing",
          "Let drones stay in the air when no command comes for 15 s, for several drones with"
              + " --time-factor max.");

  private final OptionValue<Optional<Integer>> control =
      optionList
          .option(
              CONTROL,
              "PORT",
              "With --headless: let tests in other languages see what drones really do, reset,"
                  + " advance and break things, with JSON lines over TCP on this machine; 0 chooses"
                  + " a free port. A line that begins with control says where, and the token.")
          .readIfGiven(OptionTypes::portOrFree);

  private final OptionValue<Long> seed =
      optionList
          .option(
              "--seed",
              "N",
              "The same seed and the same commands give the same flight; with --time-factor max"
                  + " also to the byte, for a program that waits for each reply. Default: 1.")
          .read(OptionTypes::seed, "1");

  private final RecordingOptions recordingOptions = new RecordingOptions(optionList);

  private final ReplayOptions replayOptions = new ReplayOptions(optionList);

  private final OptionValue<String> logLevel =
      optionList
          .option(
              LOG_LEVEL,
              "LEVEL",
              "error, warn (refused commands), info (all commands and replies), debug (also reads"
                  + " and rc), or off. Default: info.")
          .read(OptionTypes::logLevel, "info");

  /** Reads the command line into these options, and explains them. */
  public CommandLine commandLine(IVersionProvider version) {
    return optionList.commandLine(version);
  }

  public boolean headless() {
    return headless.value();
  }

  public boolean on() {
    return on.value();
  }

  public String logLevel() {
    return logLevel.value();
  }

  /** Whether it is said in which room is flown, or with how many drones. */
  public boolean choosesRoom() {
    return scenarioOptions.opened().isPresent() || drones.given() || roomOptions.given();
  }

  /** The drones' cameras. */
  public DroneOptics optics() {
    return new DroneOptics(Math.toRadians(fieldOfViewDeg.value()), Math.toRadians(tiltDeg.value()));
  }

  public OptionalInt replyPort() {
    return network.replyPort();
  }

  /** The folder in which flights are recorded, as far as it is said. */
  public Optional<Path> record() {
    return recordingOptions.folder();
  }

  /** The file of the report that is made at the end, as far as it is said. */
  public Optional<Path> report() {
    return recordingOptions.report();
  }

  /** The recording that the window is to show instead of a simulation, as far as it is said. */
  public Optional<Path> replay() {
    return replayOptions.folder();
  }

  /** The recording that is shown with it, as far as it is said. */
  public Optional<Path> ghost() {
    return replayOptions.ghost();
  }

  /**
   * Looks whether what is said about replays fits together.
   *
   * @throws IllegalArgumentException with a sentence, if it does not
   */
  public void checkReplay() {
    replayOptions.check();
  }

  /** The port of the control channel, 0 for a free one; empty for no such channel. */
  public Optional<Integer> control() {
    return control.value();
  }

  public boolean listScenarios() {
    return scenarioOptions.list();
  }

  public boolean exitWhenDone() {
    return scenarioOptions.endsByItself().isPresent();
  }

  /** Whether the program may go on for a while after the verdict. */
  public boolean awaitsProgram() {
    return scenarioOptions.awaitsProgram();
  }

  /** After how much simulated time the goals are missed [s]. */
  public Optional<Double> timeout() {
    return scenarioOptions.timeout();
  }

  /**
   * What is to be run.
   *
   * @throws IllegalArgumentException with a sentence, if the options do not fit together
   */
  public Launch launch() {
    Scenario scenario = scenario();
    AddressPlan addresses = addressPlan(scenario);
    Optional<String> end = scenarioOptions.endsByItself();
    if (end.isPresent() && (!headless() || scenario.challenge().goals().isEmpty())) {
      throw new IllegalArgumentException(
          end.get() + " needs --headless and a --scenario with goals");
    }
    if (control().isPresent() && (!headless() || end.isPresent())) {
      throw new IllegalArgumentException(
          headless() ? CONTROL + " does not go with " + end.get() : CONTROL + " needs --headless");
    }
    ScenarioOptions.checkPictures(scenario.config().arena());
    recordingOptions.check(headless(), inputs(scenario));
    OpenedScenario opened =
        scenarioOptions
            .opened()
            .map(read -> read.with(scenario))
            .orElseGet(() -> OpenedScenario.once(scenario));
    return new Launch(opened, addresses);
  }

  /** The files that are read. */
  private List<Path> inputs(Scenario scenario) {
    List<Path> inputs = new ArrayList<>();
    scenarioOptions.opened().flatMap(OpenedScenario::file).ifPresent(inputs::add);
    ScenarioOptions.pictures(scenario.config().arena()).map(Path::of).forEach(inputs::add);
    return inputs;
  }

  /**
   * The scenario of the file, or an empty room, with all that the options say about it.
   *
   * @throws IllegalArgumentException with a sentence, if options do not fit together
   */
  Scenario scenario() {
    Scenario base = scenarioOptions.scenario().map(this::alone).orElseGet(this::emptyRoom);
    network.checkAddresses(base.config().drones().size());
    return changed(base);
  }

  /**
   * A scenario with what the options say about every scenario.
   *
   * @throws IllegalArgumentException with a sentence, if they do not fit together, or if a picture
   *     cannot be read
   */
  public Scenario applied(Scenario base) {
    Scenario scenario = changed(base);
    ScenarioOptions.checkPictures(scenario.config().arena());
    return scenario;
  }

  private Scenario changed(Scenario base) {
    Decor decor = base.config().arena().decor();
    List<Poster> all = new ArrayList<>(decor.posters());
    all.addAll(roomOptions.posters());
    SimConfig config =
        base.config()
            .withDecor(decor.withWalls(roomOptions.walls().or(decor.walls())).withPosters(all))
            .withTimeFactor(timeFactor.or(base.config().timeFactor()))
            .withSeed(seed.or(base.config().seed()))
            .withOperators(network.operators())
            .withFaults(faultOptions.applied(base.config().rules().faults(), base.config()));
    return base.withConfig(config.withDrones(changed(config.drones())));
  }

  private Scenario alone(Scenario scenario) {
    for (OptionValue<?> option : List.of(drones, roomOptions.size(), roomOptions.startPoint())) {
      if (option.given()) {
        throw new IllegalArgumentException(
            option.name() + " does not go with --scenario, which says it");
      }
    }
    return scenario;
  }

  private Scenario emptyRoom() {
    int count = drones.value().orElse(network.addresses().orElse(1));
    List<Pose> starts = Formation.row(count, roomOptions.start(), roomOptions.room());
    return Scenario.of(SimConfig.DEFAULT.withRoom(roomOptions.room(), starts));
  }

  private List<DroneSetup> changed(List<DroneSetup> setups) {
    network.checkVideoPorts(setups.size());
    List<DroneSetup> changed = new ArrayList<>();
    for (DroneSetup setup : setups) {
      Product product = setup.product();
      DroneSetup patient = noSafetyLanding.value() ? setup.withoutSafetyLanding() : setup;
      changed.add(
          patient
              .withProduct(
                  new Product(profile.or(product.profile()), behavior.or(product.behavior())))
              .withStreamPorts(network.streamPorts(changed.size() + 1, setup.streamPorts())));
    }
    return changed;
  }

  /** Which drone listens where; also where there are more drones than addresses to bind. */
  public AddressPlan addressPlan(Scenario scenario) {
    return network.addressPlan(scenario);
  }
}
