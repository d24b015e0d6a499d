package tellosimulator.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.ParameterException;
import tellosimulator.command.OperatorRule;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.DroneNetwork;
import tellosimulator.network.Reach;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

class OptionsTest {

  @Test
  void withoutOptionsOneEduStandsInTheMiddleOfTheDefaultRoom() {
    Options options = options("");

    assertThat(options.scenario().config()).isEqualTo(SimConfig.DEFAULT);
    assertThat(plan(options)).isEqualTo(AddressPlan.ofMachine(1, 8879));
    assertThat(options.replyPort()).isEmpty();
    assertThat(options.logLevel()).isEqualTo("info");
    assertThat(options.headless()).isFalse();
  }

  @Test
  void everyOptionReachesTheSimulation() {
    Options options =
        options(
            "--headless --state-port 9001 --video-port 9002 --reply-port 8889 --profile tt"
                + " --behaviour measured --room 600x700.5x250 --start 100,-50 --time-factor 2.5"
                + " --seed -7 --log-level debug");

    SimConfig config = options.scenario().config();
    assertThat(config.drones().get(0).product())
        .isEqualTo(new Product(Profile.TT, Behavior.MEASURED));
    assertThat(config.arena().room()).isEqualTo(new Room(6, 7.005, 2.5));
    assertThat(config.starts()).hasSize(1);
    assertThat(config.starts().get(0).position()).isEqualTo(new Vec3(1, -0.5, 0));
    assertThat(config.timeFactor()).isEqualTo(new TimeFactor(2.5));
    assertThat(config.seed()).isEqualTo(-7);
    assertThat(config.drones().get(0).streamPorts()).isEqualTo(new StreamPorts(9001, 9002));
    assertThat(options.replyPort()).isEqualTo(OptionalInt.of(8889));
    assertThat(options.logLevel()).isEqualTo("debug");
    assertThat(options.headless()).isTrue();
  }

  @Test
  void eachDroneMaySendItsVideoToAPortOfItsOwn() {
    SimConfig config = options("--drones 2 --video-port 11111,11112").scenario().config();

    assertThat(config.drones().get(0).streamPorts()).isEqualTo(new StreamPorts(8890, 11111));
    assertThat(config.drones().get(1).streamPorts()).isEqualTo(new StreamPorts(8890, 11112));
  }

  @Test
  void videoPortsMustFitTheDrones() {
    Options options = options("--drones 3 --video-port 11111,11112");

    assertThatThrownBy(options::launch)
        .hasMessage(
            "--video-port has 2 ports for 3 drones, but must have one for each, or one for all");
  }

  @ParameterizedTest
  @CsvSource({"edu, EDU", "tello, TELLO", "tt, TT"})
  void profilesAreChosenByName(String word, Profile profile) {
    assertThat(options("--profile " + word).scenario().config().drones().get(0).product().profile())
        .isEqualTo(profile);
  }

  @ParameterizedTest
  @CsvSource({"report, REPORT", "measured, MEASURED"})
  void behaviorsAreChosenByName(String word, Behavior behavior) {
    assertThat(
            options("--behaviour " + word).scenario().config().drones().get(0).product().behavior())
        .isEqualTo(behavior);
  }

  @ParameterizedTest
  @CsvSource({"0.01, 0.01", "1, 1", "20, 20", "5000, 5000", "max, Infinity"})
  void timeFactorsAreNumbersOrMax(String word, double factor) {
    assertThat(options("--time-factor " + word).scenario().config().timeFactor().value())
        .isEqualTo(factor);
  }

  @ParameterizedTest
  @ValueSource(strings = {"error", "warn", "info", "debug", "off"})
  void logLevelsAreChosenByName(String level) {
    assertThat(options("--log-level " + level).logLevel()).isEqualTo(level);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 8889, 65535})
  void everyPortCanBeTheCommandPort(int port) {
    assertThat(plan(options("--command-port " + port))).isEqualTo(AddressPlan.ofMachine(1, port));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3, 250})
  void asManyDronesStandInTheRoomAsAreAskedFor(int drones) {
    Options options = options("--room 2000x2000x300 --drones " + drones);

    assertThat(options.scenario().config().starts()).hasSize(drones);
    assertThat(plan(options).drones()).hasSize(drones);
  }

  @Test
  void wallsAreTexturedOrPlainOrSuitWhoLooks() {
    assertThat(options("").scenario().config().arena().decor().walls()).isEqualTo(Walls.AUTO);
    assertThat(options("--walls textured").scenario().config().arena().decor().walls())
        .isEqualTo(Walls.TEXTURED);
    assertThat(options("--walls plain").scenario().config().arena().decor().walls())
        .isEqualTo(Walls.PLAIN);
  }

  @ParameterizedTest
  @CsvSource({
    "front, FRONT_WALL",
    "back, BACK_WALL",
    "left, LEFT_WALL",
    "right, RIGHT_WALL",
    "floor, FLOOR",
    "ceiling, CEILING"
  })
  void postersHangOnAnySideOfTheRoom(String word, Surface surface) {
    List<Poster> posters =
        options("--poster " + word + ",-50,120,29.7,a,b.png")
            .scenario()
            .config()
            .arena()
            .decor()
            .posters();

    assertThat(posters).containsExactly(new Poster(surface, -0.5, 1.2, 0.297, "a,b.png"));
  }

  @Test
  void severalPostersHangInTheirOrder() {
    List<Poster> posters =
        options("--poster front,0,120,30,a.png --poster front,10,120,30,b.png")
            .scenario()
            .config()
            .arena()
            .decor()
            .posters();

    assertThat(posters).extracting(Poster::picture).containsExactly("a.png", "b.png");
  }

  @Test
  void eachFurtherDroneTakesTheNextLoopbackAddress() {
    assertThat(addresses(options("--drones 3")))
        .containsExactly(
            List.of(at("127.0.0.1", 8879)),
            List.of(at("127.0.0.2", 8879)),
            List.of(at("127.0.0.3", 8879)));
  }

  @Test
  void onlyWithLanTheNetworkReachesTheFirstDrone() {
    assertThat(plan(options("")).reach()).isEqualTo(Reach.THIS_MACHINE);
    assertThat(plan(options("--lan")).reach()).isEqualTo(Reach.NETWORK);
    assertThat(addresses(options("--lan")).get(0)).contains(at("127.0.0.1", 8879));
    assertThat(addresses(options("--port-per-drone --drones 2")))
        .containsExactly(List.of(at("127.0.0.1", 8879)), List.of(at("127.0.0.1", 8880)));
  }

  @Test
  void whoOperatesCanBeChosen() throws Exception {
    assertThat(options("").scenario().config().rules().operators()).isEqualTo(OperatorRule.FIRST);
    assertThat(options("--operator first").scenario().config().rules().operators())
        .isEqualTo(OperatorRule.FIRST);
    assertThat(options("--operator anyone").scenario().config().rules().operators())
        .isEqualTo(OperatorRule.ANYONE);
    assertThat(
            options("--operator 192.168.1.7 --scenario slalom")
                .scenario()
                .config()
                .rules()
                .operators())
        .isEqualTo(OperatorRule.only(InetAddress.getByName("192.168.1.7")));
  }

  private static List<List<InetSocketAddress>> addresses(Options options) {
    return DroneNetwork.of(plan(options)).addresses();
  }

  @Test
  void eachBoundAddressIsADrone() {
    Options options = options("--bind 127.0.0.5,127.0.0.6 --command-port 8889");

    assertThat(options.scenario().config().starts()).hasSize(2);
    assertThat(addresses(options))
        .containsExactly(List.of(at("127.0.0.5", 8889)), List.of(at("127.0.0.6", 8889)));
  }

  @Test
  void aScenarioSaysWhatIsSimulated() {
    Options options = options("--scenario swarm-stage");

    assertThat(options.scenario()).isEqualTo(Gallery.find("swarm-stage").orElseThrow());
    assertThat(plan(options).drones()).hasSize(3);
  }

  @Test
  void whatIsGivenBesideAScenarioCountsMore() {
    Options options =
        options(
            "--scenario swarm-stage --profile tt --behaviour measured --state-port 9001"
                + " --video-port 1,2,3 --walls plain --poster front,0,120,30,a.png"
                + " --time-factor 3 --seed 8 --command-port 8889");

    SimConfig scenario = Gallery.find("swarm-stage").orElseThrow().config();
    SimConfig config = options.scenario().config();
    assertThat(config.starts()).isEqualTo(scenario.starts());
    assertThat(config.drones())
        .extracting(DroneSetup::product)
        .containsOnly(new Product(Profile.TT, Behavior.MEASURED));
    assertThat(config.drones())
        .extracting(DroneSetup::streamPorts)
        .containsExactly(
            new StreamPorts(9001, 1), new StreamPorts(9001, 2), new StreamPorts(9001, 3));
    assertThat(config.drones())
        .extracting(DroneSetup::rgb)
        .isEqualTo(scenario.drones().stream().map(DroneSetup::rgb).toList());
    assertThat(config.arena().decor().walls()).isEqualTo(Walls.PLAIN);
    assertThat(config.arena().decor().posters()).hasSize(1);
    assertThat(config.timeFactor()).isEqualTo(new TimeFactor(3));
    assertThat(config.seed()).isEqualTo(8);
    assertThat(DroneNetwork.of(options.addressPlan(options.scenario())).addresses().get(2))
        .containsExactly(at("127.0.0.3", 8889));
  }

  private static AddressPlan plan(Options options) {
    return options.addressPlan(options.launch().scenario());
  }

  @Test
  void whatIsLaunchedIsTheScenarioOfTheOptionsWithAnAddressForEachDrone() {
    Options options =
        options("--scenario swarm-stage --seed 8 --bind 127.0.0.4,127.0.0.5,127.0.0.6");
    OpenedScenario launch = options.launch();

    assertThat(launch.known()).contains("swarm-stage");
    assertThat(launch.scenario().config().seed()).isEqualTo(8);
    assertThat(DroneNetwork.of(plan(options)).addresses().get(2))
        .containsExactly(at("127.0.0.6", 8879));
  }

  @Test
  void aCourseIsDrawnFromTheSeedOfTheOptions(@TempDir Path folder) throws Exception {
    Path file =
        Files.writeString(
            folder.resolve("wind.yaml"), "wind: {speed: 0..2000}\nseed: 3\nname: Windy\n");
    double drawn = speed(options("--scenario " + file + " --seed 8"));

    assertThat(options("--scenario " + file + " --seed 8").launch().varies()).isTrue();
    assertThat(speed(options("--seed 8 --scenario " + file))).isEqualTo(drawn);
    assertThat(speed(options("--scenario " + file)))
        .isNotEqualTo(drawn)
        .isEqualTo(speed(options("--scenario " + file + " --seed 3")));
  }

  private static double speed(Options options) {
    return options.launch().scenario().config().arena().wind().mean().norm();
  }

  @Test
  void portsCountUpAndLeaveOutThoseOfOperators() {
    Options options = options("--port-per-drone --bind 127.0.0.1 --drones 3 --command-port 8888");

    assertThat(addresses(options))
        .containsExactly(
            List.of(at("127.0.0.1", 8888)),
            List.of(at("127.0.0.1", 8891)),
            List.of(at("127.0.0.1", 8892)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --command-port | abc       | expected a port from 1 to 65535, or 0 for a free one, found abc
          --command-port | -1        | expected a port from 1 to 65535, or 0 for a free one, found -1
          --command-port | 65536     | expected a port from 1 to 65535, or 0 for a free one, found 65536
          --state-port   | 0         | expected a port from 1 to 65535, found 0
          --state-port   | 99999999999 | expected a port from 1 to 65535, found 99999999999
          --video-port   | 1.5       | expected a port from 1 to 65535, found 1.5
          --reply-port   | receiver  | expected sender or a port from 1 to 65535, found receiver
          --reply-port   | 0         | expected sender or a port from 1 to 65535, found 0
          --drones       | 0         | expected a number from 1 to 250, found 0
          --drones       | 251       | expected a number from 1 to 250, found 251
          --drones       | three     | expected a number from 1 to 250, found three
          --bind         | 127.0.0   | expected an address of this machine such as 127.0.0.2, found 127.0.0
          --bind         | 1.2.3.256 | expected an address of this machine such as 127.0.0.2, found 1.2.3.256
          --bind         | localhost | expected an address of this machine such as 127.0.0.2, found localhost
          --bind         | 224.0.0.1 | expected an address of this machine such as 127.0.0.2, found 224.0.0.1
          --bind         | 255.255.255.255 | expected an address of this machine such as 127.0.0.2, found 255.255.255.255
          --bind         | 1.2.3.4,  | expected an address of this machine such as 127.0.0.2, found nothing
          --bind         | 1.2.3.4,1.2.3.4 | 1.2.3.4 is there twice, but each drone needs an address of its own
          --profile      | EDU       | expected one of edu, tello, tt, found EDU
          --behaviour    | real      | expected one of report, measured, found real
          --room         | 500x500   | expected width, depth and height in cm such as 500x500x300, found 500x500
          --room         | 5x5x3     | expected width, depth and height from 100 to 20000 cm, found 5x5x3
          --walls        | brick     | expected one of auto, plain, textured, found brick
          --start        | 100       | expected X,Y in cm such as 100,-50, found 100
          --start        | NaN,0     | expected X,Y in cm such as 100,-50, found NaN,0
          --time-factor  | fast      | expected a number from 0.01 to 5000, or max, found fast
          --time-factor  | 0         | expected a number from 0.01 to 5000, or max, found 0
          --time-factor  | 5001      | expected a number from 0.01 to 5000, or max, found 5001
          --time-factor  | Infinity  | expected a number from 0.01 to 5000, or max, found Infinity
          --seed         | 1.5       | expected a whole number of at most 18 digits, found 1.5
          --seed         | 1234567890123456789 | expected a whole number of at most 18 digits, found 1234567890123456789
          --log-level    | loud      | expected one of error, warn, info, debug, off, found loud
          """)
  void aWrongValueIsNamedWithWhatWasExpected(String option, String value, String sentence) {
    assertThatThrownBy(() -> options(option + " " + value))
        .isInstanceOf(ParameterException.class)
        .hasMessage("Invalid value for option '" + option + "': " + sentence);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          front,0,120,a.png     | expected WALL,ALONG,HEIGHT,WIDTH,FILE such as front,0,120,30,face.png, found front,0,120,a.png
          door,0,120,30,a.png   | expected front, back, left, right, floor or ceiling, found door
          front,0,120,0.3,a.png | expected a width from 1 to 20000 cm, found 0.3
          """)
  void aWrongPosterIsNamedWithWhatWasExpected(String value, String sentence) {
    assertThatThrownBy(() -> options("--poster " + value))
        .isInstanceOf(ParameterException.class)
        .hasMessageEndingWith(": " + sentence);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --bind 127.0.0.1,127.0.0.2 --drones 3 | --bind has 2 addresses for 3 drones, but each drone needs one
          --start 250,0                         | drone 1 does not fit into the room: its start would be at x 250, y 0 cm
          --room 100x100x100 --drones 9         | drone 3 does not fit into the room: its start would be at x -60, y 30 cm
          --port-per-drone --bind 127.0.0.1 --drones 2 --command-port 65535 | there are no ports for 2 drones from port 65535 on
          """)
  void optionsThatDoNotFitTogetherAreNamed(String line, String sentence) {
    Options options = options(line);

    assertThatThrownBy(
            () -> {
              options.launch();
            })
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(sentence);
  }

  private static Options options(String line) {
    Options options = new Options();
    String[] words = line.isEmpty() ? new String[0] : line.split(" ", -1);
    options.commandLine(() -> new String[0]).parseArgs(words);
    return options;
  }

  private static InetSocketAddress at(String address, int port) {
    return new InetSocketAddress(address, port);
  }
}
