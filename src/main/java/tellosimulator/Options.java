package tellosimulator;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import tellosimulator.math.Pose;
import tellosimulator.network.AddressPlan;
import tellosimulator.profile.Behaviour;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Outlets;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.Swarm;
import tellosimulator.time.TimeFactor;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.OpenedScenario;
import tellosimulator.world.Decor;
import tellosimulator.world.Poster;

/** What can be chosen on the command line, and what follows from it. */
@Command(
    name = "tello-simulator",
    addMethodSubcommands = false, // looking for them takes a twelfth of the time to read options
    sortOptions = false,
    usageHelpAutoWidth = true,
    header = "Simulates Tello drones: programs fly them over UDP as they fly real ones.",
    footer = {
      "",
      "Two changes make an existing program fly the simulator on the same machine:",
      "the drone's address becomes 127.0.0.1, and the command port becomes 8879.",
      "",
      "While it runs, type: help, reset [N], power on|off [N], battery PERCENT [N],",
      "pause, resume, state or quit. N is a drone's number; without it, all drones."
    })
final class Options {

  /** Also looked for before the options are read. */
  static final String HEADLESS = "--headless";

  @Spec private CommandSpec spec;

  @Option(names = HEADLESS, description = "Run without a window.")
  private boolean headless;

  @Option(
      names = "--on",
      description = "Switch all drones on at once. Without a window they always are.")
  private boolean on;

  @Mixin private ScenarioOptions scenarioOptions;

  @Option(
      names = "--command-port",
      paramLabel = "PORT",
      defaultValue = "8879",
      converter = OptionTypes.PortOrFree.class,
      description = "Where drones take commands; 0 chooses a free port. Default: 8879.")
  private int commandPort;

  @Option(
      names = "--state-port",
      paramLabel = "PORT",
      defaultValue = "8890",
      converter = OptionTypes.Port.class,
      description = "Where your program takes the drone's state. Default: 8890.")
  private int statePort;

  @Option(
      names = "--video-port",
      paramLabel = "PORT,...",
      defaultValue = "11111",
      converter = OptionTypes.PortsOfDrones.class,
      description =
          "Where your program takes the drone's video: one port for all drones, or one for each."
              + " Default: 11111.")
  private OptionTypes.PortList videoPorts;

  @Option(
      names = "--camera-fov",
      paramLabel = "DEG|manual",
      defaultValue = "55",
      converter = OptionTypes.FieldOfView.class,
      description =
          "What the camera sees from left to right, in degrees: 55 as measured, or manual for the"
              + " 82.6 degrees from corner to corner of the manual. Default: 55.")
  private double fieldOfViewDeg;

  @Option(
      names = "--camera-tilt",
      paramLabel = "DEG",
      defaultValue = "15",
      converter = OptionTypes.Tilt.class,
      description = "How far the camera looks down, in degrees. Default: 15.")
  private double tiltDeg;

  @Option(
      names = "--reply-port",
      paramLabel = "sender|PORT",
      defaultValue = "sender",
      converter = OptionTypes.ReplyPort.class,
      description =
          "Where replies go on your program's host: to the port that the command came from, or"
              + " always to the same one. Default: sender.")
  private OptionalInt replyPort;

  @Option(
      names = "--drones",
      paramLabel = "N",
      converter = OptionTypes.DroneCount.class,
      description = "How many drones to simulate. Default: 1, or as many as --bind has addresses.")
  private Integer drones;

  @Option(
      names = "--bind",
      paramLabel = "A,B,...",
      converter = OptionTypes.Addresses.class,
      description =
          "One address of this machine for each drone. Default: all addresses for drone 1,"
              + " 127.0.0.2 for drone 2, 127.0.0.3 for drone 3, and so on.")
  private OptionTypes.AddressList bind;

  @Option(
      names = "--port-per-drone",
      description =
          "Give all drones the same addresses and count the port up: 8879, 8880 and so on, leaving out"
              + " 8889, 8890 and 11111.")
  private boolean portPerDrone;

  @Option(
      names = "--profile",
      paramLabel = "edu|tello|tt",
      defaultValue = "edu",
      converter = OptionTypes.ProfileName.class,
      description = "Which drone: Tello EDU, white Tello or RoboMaster TT. Default: edu.")
  private Profile profile;

  @Option(
      names = "--behaviour",
      paramLabel = "report|measured",
      defaultValue = "report",
      converter = OptionTypes.BehaviourName.class,
      description =
          "report: exact, and strict about commands that come too early. measured: with the"
              + " noise, delays and errors of real drones. Default: report.")
  private Behaviour behaviour;

  @Mixin private RoomOptions roomOptions;

  @Option(
      names = "--time-factor",
      paramLabel = "F|max",
      defaultValue = "1",
      converter = OptionTypes.Factor.class,
      description =
          "How fast time passes: 5 is five times as fast. max runs as fast as the machine can"
              + " while a drone moves, and waits for your program otherwise. Default: 1.")
  private TimeFactor timeFactor;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      converter = OptionTypes.Seed.class,
      description = "The same seed and the same commands give the same flight. Default: 1.")
  private long seed;

  @Option(
      names = "--log-level",
      paramLabel = "LEVEL",
      defaultValue = "info",
      converter = OptionTypes.LogLevel.class,
      description =
          "error, warn (refused commands), info (all commands and replies), debug (also reads and"
              + " rc), or off. Default: info.")
  private String logLevel;

  boolean headless() {
    return headless;
  }

  boolean on() {
    return on;
  }

  String logLevel() {
    return logLevel;
  }

  /** The drones' cameras. */
  DroneOptics optics() {
    return new DroneOptics(Math.toRadians(fieldOfViewDeg), Math.toRadians(tiltDeg));
  }

  OptionalInt replyPort() {
    return replyPort;
  }

  boolean listScenarios() {
    return scenarioOptions.list();
  }

  boolean exitWhenDone() {
    return scenarioOptions.exitWhenDone();
  }

  /**
   * Looks whether the options fit together, before anything is started.
   *
   * @throws IllegalArgumentException with a sentence, if they do not
   */
  void check() {
    Scenario scenario = scenario();
    Objects.requireNonNull(addressPlan());
    if (exitWhenDone() && (!headless || scenario.challenge().goals().isEmpty())) {
      throw new IllegalArgumentException(
          ScenarioOptions.EXIT_WHEN_DONE + " needs --headless and a --scenario with goals");
    }
    ScenarioOptions.checkPictures(scenario.config().arena());
  }

  /** What to simulate; see {@link #scenario}. */
  SimConfig simConfig() {
    return scenario().config();
  }

  /**
   * The scenario of the file, or an empty room, with all that the options say about it.
   *
   * @throws IllegalArgumentException with a sentence, if options do not fit together
   */
  Scenario scenario() {
    return changed(scenarioOptions.scenario().map(this::alone).orElseGet(this::emptyRoom));
  }

  /** The same, and from where it came. */
  OpenedScenario openedScenario() {
    return scenarioOptions
        .opened()
        .map(opened -> opened.with(scenario()))
        .orElseGet(() -> OpenedScenario.once(scenario()));
  }

  /**
   * A scenario with what the options say about every scenario.
   *
   * @throws IllegalArgumentException with a sentence, if they do not fit together, or if a picture
   *     cannot be read
   */
  Scenario applied(Scenario base) {
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
            .withDecor(
                decor
                    .withWalls(unlessGiven("--walls", decor.walls(), roomOptions.walls()))
                    .withPosters(all))
            .withTimeFactor(unlessGiven("--time-factor", base.config().timeFactor(), timeFactor))
            .withSeed(unlessGiven("--seed", base.config().seed(), seed));
    return base.withConfig(config.withDrones(changed(config.drones())));
  }

  private Scenario alone(Scenario scenario) {
    for (String option : List.of("--drones", "--room", "--start")) {
      if (given(option)) {
        throw new IllegalArgumentException(option + " does not go with --scenario, which says it");
      }
    }
    return scenario;
  }

  private Scenario emptyRoom() {
    List<Pose> starts = Swarm.row(droneCount(), roomOptions.start(), roomOptions.room());
    return Scenario.of(SimConfig.DEFAULT.withRoom(roomOptions.room(), starts));
  }

  private List<DroneSetup> changed(List<DroneSetup> setups) {
    List<Integer> ports = videoPorts.ports();
    if (ports.size() != 1 && ports.size() != setups.size()) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "--video-port has %d ports for %d drones, but must have one for each, or one for all",
              ports.size(),
              setups.size()));
    }
    List<DroneSetup> changed = new ArrayList<>();
    for (DroneSetup setup : setups) {
      Product product = setup.product();
      Outlets outlets = setup.outlets();
      int port = ports.get(changed.size() % ports.size());
      changed.add(
          setup
              .withProduct(
                  new Product(
                      unlessGiven("--profile", product.profile(), profile),
                      unlessGiven("--behaviour", product.behaviour(), behaviour)))
              .withOutlets(
                  new Outlets(
                      unlessGiven("--state-port", outlets.statePort(), statePort),
                      unlessGiven("--video-port", outlets.videoPort(), port))));
    }
    return changed;
  }

  private <T> T unlessGiven(String option, T said, T chosen) {
    return given(option) ? chosen : said;
  }

  private boolean given(String option) {
    return spec.commandLine().getParseResult().hasMatchedOption(option);
  }

  /**
   * Which drone listens where.
   *
   * @throws IllegalArgumentException with a sentence, if options do not fit together
   */
  AddressPlan addressPlan() {
    droneCount(); // which may fail
    return addressPlan(scenario());
  }

  /** The same for any scenario, also one with other drones than there are addresses to bind. */
  AddressPlan addressPlan(Scenario scenario) {
    int count = scenario.config().drones().size();
    if (bind != null && !portPerDrone && count == bind.addresses().size()) {
      return AddressPlan.of(bind.addresses(), commandPort);
    }
    if (bind != null || portPerDrone) {
      List<InetAddress> addresses =
          bind == null ? AddressPlan.machineAddresses() : bind.addresses();
      return AddressPlan.portPerDrone(count, addresses, commandPort);
    }
    return given("--command-port")
        ? scenario.withCommandPort(commandPort).addressPlan(commandPort)
        : scenario.addressPlan(commandPort);
  }

  private int droneCount() {
    int wanted =
        scenarioOptions
            .scenario()
            .map(scenario -> scenario.config().drones().size())
            .or(() -> Optional.ofNullable(drones))
            .orElse(0);
    if (bind == null || portPerDrone) {
      return Math.max(1, wanted);
    }
    int addresses = bind.addresses().size();
    if (wanted != 0 && wanted != addresses) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "--bind has %d addresses for %d drones, but each drone needs one",
              addresses,
              wanted));
    }
    return addresses;
  }
}
