package tellosimulator.cli;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
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
import tellosimulator.world.Room;

/** The command-line options of the simulator, and the scenario that they describe. */
public final class Options {

  static final String CAMERA_FOV = "--camera-fov";
  static final String CAMERA_TILT = "--camera-tilt";
  static final String HEADLESS = "--headless";
  static final String LOG_LEVEL = "--log-level";

  private static final String[] LOG_LEVELS = {"error", "warn", "info", "debug", "off"};

  private static final String CONTROL = "--control";

  private static final String WEB = "--web";

  /** The port of the page for browsers, unless one is given. Decided: usual for web servers. */
  private static final String WEB_PORT = "8080";

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
                  + " the 82.6 degrees from corner to corner of the manual.")
          .read(OptionTypes::fieldOfView, "55");

  private final OptionValue<Double> tiltDeg =
      optionList
          .option(CAMERA_TILT, "DEG", "How far the camera looks down, in degrees.")
          .read(OptionTypes::tilt, "15");

  private final OptionValue<Integer> photoWidth =
      optionList
          .option(
              "--photo-width",
              "PIXELS",
              "Width of the photos that programs take with the app's protocol, in pixels; height in"
                  + " proportion.")
          .read(OptionTypes::photoWidth, Integer.toString(DroneOptics.PHOTO_WIDTH));

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
              "--profile", "edu|tello|tt", "Which drone: Tello EDU, white Tello or RoboMaster TT.")
          .readOneOf(Profile.values(), Profile::option, Product.DEFAULT.profile());

  private final OptionValue<Behavior> behavior =
      optionList
          .option(
              "--behaviour",
              "report|measured",
              "report: exact, and strict about commands that come too early. measured: with the"
                  + " noise, delays and errors of real drones.")
          .readOneOf(Behavior.values(), Behavior::option, Product.DEFAULT.behavior());

  private final FaultOptions faultOptions = new FaultOptions(optionList);

  private final RoomOptions roomOptions = new RoomOptions(optionList);

  private final OptionValue<TimeFactor> timeFactor =
      optionList
          .option(
              "--time-factor",
              "F|max",
              "How fast time passes: 5 is five times as fast. max runs as fast as the machine can"
                  + " while a drone moves, and waits for your program otherwise.")
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

  private final OptionValue<Optional<Integer>> web =
      optionList
          .option(
              WEB,
              "[PORT]",
              "With --headless: show and fly the drones in a browser; 0 chooses a free port. A line"
                  + " that begins with web contains the link. With --lan, other machines of the local"
                  + " network can open it, too.")
          .orAlone(WEB_PORT)
          .readIfGiven(OptionTypes::portOrFree);

  private final BoardOptions board = new BoardOptions(optionList);

  private final OptionValue<Long> seed =
      optionList
          .option(
              "--seed",
              "N",
              "The same seed and the same commands give the same flight; with --time-factor max"
                  + " also to the byte, for a program that waits for each reply. Ranges in a"
                  + " scenario are drawn from it.")
          .read(OptionTypes::seed, Long.toString(SimConfig.DEFAULT.seed()));

  private final RecordingOptions recordingOptions = new RecordingOptions(optionList);

  private final ReplayOptions replayOptions = new ReplayOptions(optionList);

  private final OptionValue<String> logLevel =
      optionList
          .option(
              LOG_LEVEL,
              "LEVEL",
              "error, warn (refused commands), info (all commands and replies), debug (also reads"
                  + " and rc), or off.")
          .readOneOf(LOG_LEVELS, Function.identity(), "info");

  /** Returns a parser for these options. The parser also prints their help. */
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

  /** Whether the options choose a room or a number of drones. */
  public boolean choosesRoom() {
    return opened().isPresent() || drones.given() || roomOptions.given();
  }

  /** The optics of the drones' cameras. */
  public DroneOptics optics() {
    return new DroneOptics(
        Math.toRadians(fieldOfViewDeg.value()),
        Math.toRadians(tiltDeg.value()),
        photoWidth.value());
  }

  public OptionalInt replyPort() {
    return network.replyPort.value();
  }

  /** The folder in which flights are recorded, if given. */
  public Optional<Path> record() {
    return recordingOptions.folder.value();
  }

  /** The file of the report that is written at the end, if given. */
  public Optional<Path> report() {
    return recordingOptions.report.value();
  }

  /** The file of the result that is written at the end, if given. */
  public Optional<Path> result() {
    return recordingOptions.result.value();
  }

  /** The recording to show in the window instead of a simulation, if given. */
  public Optional<Path> replay() {
    return replayOptions.folder.value();
  }

  /** The second recording that is shown together with the replay, if given. */
  public Optional<Path> ghost() {
    return replayOptions.ghost.value();
  }

  /**
   * Checks that the options for replays are consistent.
   *
   * @throws IllegalArgumentException if they are inconsistent; the message is one sentence
   */
  public void checkReplay() {
    replayOptions.check();
  }

  /**
   * The port of the control channel; 0 lets the system choose. Empty if there is no control
   * channel.
   */
  public Optional<Integer> control() {
    return control.value();
  }

  public boolean listScenarios() {
    return scenarioOptions.list.value();
  }

  /**
   * The address of the page for browsers; port 0 lets the system choose. Empty if there is no page.
   */
  public Optional<InetSocketAddress> web() {
    return web.value().map(network::webAddress);
  }

  /** Returns the options for the teacher's board. */
  public BoardOptions board() {
    return board;
  }

  public boolean exitWhenDone() {
    return scenarioOptions.endsByItself().isPresent();
  }

  /** Whether the operator program may continue for a while after the verdict. */
  public boolean awaitsProgram() {
    return scenarioOptions.awaitProgram.value();
  }

  /** Whether the run ends once the program turns out not to wait for replies. */
  public boolean awaitsReplies() {
    return scenarioOptions.awaitReplies.value();
  }

  /** Simulated time after which the goals count as missed [s]. */
  public Optional<Double> timeout() {
    return scenarioOptions.timeout.value();
  }

  /**
   * Returns the scenario to fly, with all options applied.
   *
   * @throws IllegalArgumentException if the options are inconsistent; the message is one sentence
   */
  public OpenedScenario launch() {
    Scenario scenario = scenario();
    addressPlan(scenario); // there must be enough ports
    Optional<String> end = scenarioOptions.endsByItself();
    if (end.isPresent() && (!headless() || scenario.challenge().goals().isEmpty())) {
      throw new IllegalArgumentException(
          end.get() + " needs --headless and a --scenario with goals");
    }
    checkServer(CONTROL, control().isPresent(), end);
    checkServer(WEB, web().isPresent(), end);
    board.check(end);
    ScenarioOptions.checkPictures(scenario.config().arena());
    recordingOptions.check(headless(), inputs(scenario));
    return opened().map(read -> read.with(scenario)).orElseGet(() -> OpenedScenario.once(scenario));
  }

  private void checkServer(String option, boolean given, Optional<String> end) {
    if (given && (!headless() || end.isPresent())) {
      throw new IllegalArgumentException(
          headless() ? option + " does not go with " + end.get() : option + " needs --headless");
    }
  }

  private Optional<OpenedScenario> opened() {
    return scenarioOptions.opened(seed);
  }

  /** Returns the files that the simulation reads. */
  private List<Path> inputs(Scenario scenario) {
    List<Path> inputs = new ArrayList<>();
    opened().flatMap(OpenedScenario::file).ifPresent(inputs::add);
    scenario.config().arena().pictures().map(Path::of).forEach(inputs::add);
    return inputs;
  }

  /**
   * Returns the scenario that the options select, or an empty room, with all options applied.
   *
   * @throws IllegalArgumentException if the options are inconsistent; the message is one sentence
   */
  Scenario scenario() {
    Scenario base =
        opened().map(OpenedScenario::scenario).map(this::alone).orElseGet(this::emptyRoom);
    network.checkAddresses(base.config().drones().size());
    return changed(base);
  }

  /**
   * Returns a copy of a scenario with those options applied that every scenario permits.
   *
   * @throws IllegalArgumentException if the options are inconsistent or a picture cannot be read;
   *     the message is one sentence
   */
  public Scenario applied(Scenario base) {
    Scenario scenario = changed(base);
    ScenarioOptions.checkPictures(scenario.config().arena());
    return scenario;
  }

  private Scenario changed(Scenario base) {
    Decor decor = base.config().arena().decor();
    List<Poster> all = new ArrayList<>(decor.posters());
    all.addAll(roomOptions.posters.value());
    SimConfig config =
        base.config()
            .withDecor(decor.withWalls(roomOptions.walls.or(decor.walls())).withPosters(all))
            .withTimeFactor(timeFactor.or(base.config().timeFactor()))
            .withSeed(seed.or(base.config().seed()))
            .withOperators(network.operators.value())
            .withFaults(faultOptions.applied(base.config().rules().faults(), base.config()));
    return base.withConfig(config.withDrones(changed(config.drones())));
  }

  private Scenario alone(Scenario scenario) {
    for (OptionValue<?> option : List.of(drones, roomOptions.room, roomOptions.start)) {
      if (option.given()) {
        throw new IllegalArgumentException(
            option.name() + " does not go with --scenario, which says it");
      }
    }
    return scenario;
  }

  private Scenario emptyRoom() {
    int count = drones.value().orElse(network.addresses().orElse(1));
    Room room = roomOptions.room.value();
    List<Pose> starts = Formation.row(count, roomOptions.start.value(), room);
    return Scenario.of(SimConfig.DEFAULT.withRoom(room, starts));
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

  /**
   * Returns the listen addresses of all drones. If the number of addresses to bind differs from the
   * number of drones, each drone listens on its own port at all of these addresses.
   */
  public AddressPlan addressPlan(Scenario scenario) {
    return network.addressPlan(scenario);
  }
}
