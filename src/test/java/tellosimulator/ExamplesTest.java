package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.testing.HeadlessSimulators;
import tellosimulator.testing.Jvm;
import tellosimulator.testing.NeedsTool;
import tellosimulator.testing.Tool;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Decor;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

/** Runs the programs in {@code examples/} as documented: {@code java examples/X.java}. */
@Tag("process")
class ExamplesTest {

  /**
   * Time factor for manual control, which holds sticks by the wall clock. Twice real time, so that
   * a drone lands by itself only after a silence of 7.5 s, however busy the machine is.
   */
  private static final TimeFactor FAST = new TimeFactor(2);

  /** A room so large that no drone reaches a wall. */
  private static final Room HALL = new Room(100, 100, 10);

  private static final Pattern ADDRESS = Pattern.compile("127\\.0\\.0\\.1:[0-9]+");
  private static final int PATIENCE_SECONDS = 300;

  @TempDir private Path scratch;

  @Test
  void firstFlightEndsAMeterAheadTurnedToTheRight() throws Exception {
    try (Flight flight = new Flight(1, TimeFactor.MAX)) {
      Ended ended = java("FirstFlight", "", flight.host(), flight.port());

      assertThat(ended.output())
          .containsExactly(
              "command -> ok",
              "Battery: 100 %",
              "takeoff -> ok",
              "forward 100 -> ok",
              "cw 90 -> ok",
              "land -> ok",
              "Landed.");
      assertThat(ended.exitCode()).isZero();
      Place place = flight.places().get(0);
      assertThat(place.phase()).isEqualTo("standing");
      // forward 100: 100 cm along x, the heading at takeoff; a move ends within 1 cm.
      assertThat(place.x()).isCloseTo(100, within(2.0));
      assertThat(place.y()).isCloseTo(0, within(2.0));
      // cw 90: on the wire, clockwise is positive; a turn ends within half a degree.
      assertThat(place.yaw()).isCloseTo(90, within(1.0));
    }
  }

  @Test
  void firstFlightSaysSoIfNothingListens() throws Exception {
    String port = Integer.toString(freePort());

    Ended ended = java("FirstFlight", "", "127.0.0.1", port);

    assertThat(ended.output())
        .containsExactly(
            "Nothing listens at 127.0.0.1:"
                + port
                + ". Does the simulator run, and is the drone on?");
    assertThat(ended.exitCode()).isEqualTo(1);
  }

  @Test
  void readStateShowsTheStateOnceASecond() throws Exception {
    try (Flight flight = new Flight(SimConfig.DEFAULT)) {
      Ended ended = java("ReadState", "", flight.host(), flight.port(), flight.statePort(), "21");

      // Lines 1, 11 and 21, at ten lines per second.
      String line = "height 0 cm, battery 100 %, pitch 0, roll 0, yaw 0 degrees";
      assertThat(ended.output()).containsExactly(line, line, line);
      assertThat(ended.exitCode()).isZero();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"ww\n?\nq\n", "ww"})
  void keyboardSteersUntilQuitOrTheEndOfInputAndLands(String typed) throws Exception {
    try (Flight flight = new Flight(1, FAST)) {
      Ended ended = java("SteerWithKeyboard", typed, flight.host(), flight.port());

      assertThat(ended.output())
          .startsWith("command -> ok", "takeoff -> ok")
          .endsWith("Type letters, then Enter; q lands and ends.", "land -> ok");
      assertThat(ended.exitCode()).isZero();
      Place place = flight.places().get(0);
      assertThat(place.phase()).isEqualTo("standing");
      // Two letters take a second or more, at factor 2 two of the drone's seconds, at up to 40
      // cm/s.
      assertThat(place.x()).isGreaterThan(30);
      assertThat(place.y()).isCloseTo(0, within(2.0));
    }
  }

  @Test
  void threeDronesFlyTogether() throws Exception {
    try (Flight flight = new Flight(3, TimeFactor.MAX)) {
      Ended ended = java("SwarmOfThree", "", flight.addresses().toArray(String[]::new));

      assertThat(ended.output()).hasSize(19).endsWith("All have landed.");
      assertThat(ended.output().subList(0, 18)).allMatch(line -> line.endsWith(" -> ok"));
      assertThat(ended.exitCode()).isZero();
      List<Place> places = flight.places();
      assertThat(places).extracting(Place::phase).containsOnly("standing");
      // They start at y 60, 0 and -60; y is to the left, so 90 degrees clockwise is along -y.
      assertThat(places.get(0).y()).isCloseTo(60 - 50, within(2.0));
      assertThat(places.get(1).x()).isCloseTo(-50, within(2.0));
      assertThat(places.get(2).y()).isCloseTo(-60 - 50, within(2.0));
    }
  }

  @Test
  void watchVideoSavesWhatTheCameraSees() throws Exception {
    // 5 m wide and high, so that it covers the whole front wall of the default room.
    Poster red = new Poster(Surface.FRONT_WALL, 0, 1.5, 5, redPicture().toString());
    SimConfig config = SimConfig.DEFAULT.withDecor(Decor.DEFAULT.withPosters(List.of(red)));
    Path folder = scratch.resolve("pictures");
    try (Flight flight = new Flight(config)) {
      Ended ended =
          java(
              "WatchVideo",
              "",
              flight.host(),
              flight.port(),
              flight.videoPort(),
              folder.toString(),
              "2");

      assertThat(ended.output())
          .startsWith("command -> ok", "streamon -> ok")
          .contains("Saved " + folder.resolve("picture-0.png") + ", 960 by 720 pixels")
          .contains("Saved " + folder.resolve("picture-1.png") + ", 960 by 720 pixels")
          .endsWith("streamoff -> ok");
      assertThat(ended.exitCode()).isZero();
    }
    BufferedImage picture = ImageIO.read(folder.resolve("picture-1.png").toFile());
    // Row 20 looks up by atan((360 - 20) / 922) - 15 = 5 degrees: at the wall, not at the floor.
    Color color = new Color(picture.getRGB(480, 20));
    assertThat(color.getRed()).isGreaterThan(150);
    assertThat(List.of(color.getGreen(), color.getBlue())).allMatch(part -> part < 80);
  }

  @Test
  void watchVideoWaitsForItsTurnAndNeverLeavesTheStreamOn() throws Exception {
    try (Flight flight = new Flight(SimConfig.DEFAULT);
        BusyDrone drone = new BusyDrone(Integer.parseInt(flight.port()))) {
      Ended ended =
          java(
              "WatchVideo",
              "",
              flight.host(),
              drone.port(),
              flight.videoPort(),
              scratch.resolve("pictures").toString(),
              "1");

      assertThat(ended.output())
          .startsWith(
              "command -> error Not joystick",
              "command -> ok",
              "streamon -> error Not joystick",
              "streamon -> ok")
          .endsWith("streamoff -> error Not joystick", "streamoff -> ok");
      assertThat(ended.exitCode()).isZero();
    }
  }

  @Test
  void watchVideoSaysSoIfNothingListens() throws Exception {
    String port = Integer.toString(freePort());

    Ended ended = java("WatchVideo", "", "127.0.0.1", port, "0", scratch.toString());

    assertThat(ended.output())
        .containsExactly(
            "Nothing listens at 127.0.0.1:" + port + ". Does the simulator run, is the drone on?");
    assertThat(ended.exitCode()).isEqualTo(1);
  }

  /** A drone operated by another program: it refuses the first attempt of each command. */
  private static final class BusyDrone implements AutoCloseable {
    private final DatagramSocket program = socket();
    private final DatagramSocket drone = socket();
    private final Thread thread = new Thread(this::serve, "busy drone");

    BusyDrone(int simulator) throws IOException {
      drone.connect(InetAddress.getLoopbackAddress(), simulator);
      thread.start();
    }

    private static DatagramSocket socket() throws IOException {
      return new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    }

    String port() {
      return Integer.toString(program.getLocalPort());
    }

    private void serve() {
      Set<String> refused = new HashSet<>();
      DatagramPacket packet = new DatagramPacket(new byte[1500], 1500);
      try {
        while (!program.isClosed()) {
          packet.setLength(1500);
          program.receive(packet);
          SocketAddress client = packet.getSocketAddress();
          byte[] text = Arrays.copyOf(packet.getData(), packet.getLength());
          byte[] reply = "error Not joystick".getBytes(StandardCharsets.US_ASCII);
          if (!refused.add(new String(text, StandardCharsets.US_ASCII))) {
            drone.send(new DatagramPacket(text, text.length));
            packet.setLength(1500);
            drone.receive(packet);
            reply = Arrays.copyOf(packet.getData(), packet.getLength());
          }
          program.send(new DatagramPacket(reply, reply.length, client));
        }
      } catch (IOException e) {
        assertThat(program.isClosed()).isTrue();
      }
    }

    @Override
    public void close() {
      program.close();
      drone.close();
      try {
        thread.join();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  @Test
  @NeedsTool(Tool.PYTHON)
  void findMarkerLooksAgainWhereOnePictureMissesTheMarker() throws Exception {
    // Replaces OpenCV and djitellopy, and determines what is found in each picture.
    Files.writeString(
        scratch.resolve("cv2.py"),
        """
        COLOR_RGB2GRAY = 0
        FOUND = [None, 335.6, None, None, None, None, 0]

        def cvtColor(picture, _):
            return picture

        class Numbers:
            def ravel(self):
                return [17]

        class Square:
            def __init__(self, across):
                self.across = across
            def mean(self, axis):
                return [480 + self.across, 300]

        class aruco:
            DICT_4X4_50 = 0
            def getPredefinedDictionary(_):
                return 0
            class ArucoDetector:
                def __init__(self, _):
                    pass
                def detectMarkers(self, _):
                    across = FOUND.pop(0)
                    if across is None:
                        return [], None, []
                    return [[Square(across)]], Numbers(), []
        """);
    Files.writeString(
        scratch.resolve("djitellopy.py"),
        """
        class Picture:
            shape = (720, 960, 3)

        class Video:
            @property
            def frame(self):
                return Picture()

        class Tello:
            def __init__(self, host):
                pass
            def get_frame_read(self):
                return Video()
            def __getattr__(self, name):
                return lambda *values: print(name, *values)
        """);
    ProcessBuilder python = Tool.PYTHON.command("examples/find_marker.py");
    python.environment().put("PYTHONPATH", scratch.toString());
    python.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    Process process = python.redirectErrorStream(true).start();

    // 335.6 pixels at a focal length of 922 are 20 degrees; four frames then miss the marker.
    assertThat(process.inputReader().lines())
        .containsExactly(
            "connect",
            "streamon",
            "takeoff",
            "move_up 70",
            "The marker is 20 degrees to the right.",
            "rotate_clockwise 20",
            "The drone looks at the marker.",
            "land",
            "streamoff",
            "Landed.");
    assertThat(process.waitFor()).isZero();
  }

  private Path redPicture() throws IOException {
    BufferedImage red = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = red.createGraphics();
    graphics.setColor(new Color(220, 20, 20));
    graphics.fillRect(0, 0, 64, 64);
    graphics.dispose();
    Path file = scratch.resolve("red.png");
    ImageIO.write(red, "png", file.toFile());
    return file;
  }

  @Test
  void examplesCompileWithoutWarnings() throws IOException {
    List<String> arguments =
        new ArrayList<>(List.of("--release", "17", "-Xlint:all", "-Werror", "-d"));
    arguments.add(scratch.toString());
    try (Stream<Path> examples = Files.list(Path.of("examples"))) {
      examples
          .map(Path::toString)
          .filter(name -> name.endsWith(".java"))
          .sorted()
          .forEach(arguments::add);
    }
    ByteArrayOutputStream warnings = new ByteArrayOutputStream();

    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(null, warnings, warnings, arguments.toArray(String[]::new));

    assertThat(warnings.toString(StandardCharsets.UTF_8)).isEmpty();
    assertThat(status).isZero();
  }

  private Ended java(String example, String typed, String... arguments)
      throws IOException, InterruptedException {
    Path input = Files.writeString(scratch.resolve("input"), typed);
    Path output = scratch.resolve("output");
    List<String> command = new ArrayList<>();
    command.add(Jvm.java());
    if (example.equals("WatchVideo")) {
      command.addAll(List.of("-cp", System.getProperty("java.class.path"))); // for JCodec
    }
    command.add(Path.of("examples", example + ".java").toString());
    command.addAll(List.of(arguments));
    Process process =
        Jvm.process(command)
            .redirectErrorStream(true)
            .redirectInput(input.toFile())
            .redirectOutput(output.toFile())
            .start();
    try {
      assertThat(process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS))
          .as("%s ends in time", example)
          .isTrue();
    } finally {
      process.destroyForcibly();
    }
    return new Ended(process.exitValue(), Files.readAllLines(output));
  }

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      return socket.getLocalPort();
    }
  }

  /** The result of an example. */
  private record Ended(int exitCode, List<String> output) {}

  /** The position of a drone, in cm and degrees, from the console's {@code state}. */
  private record Place(String phase, double x, double y, double yaw) {
    private static final Pattern FORM =
        Pattern.compile("drone \\d+: ([a-z ]+), x (\\S+) y (\\S+) z \\S+ cm, yaw (\\S+) degrees.*");

    static Place of(MatchResult line) {
      return new Place(
          line.group(1),
          Double.parseDouble(line.group(2)),
          Double.parseDouble(line.group(3)),
          Double.parseDouble(line.group(4)));
    }
  }

  /** A simulator on free ports of 127.0.0.1. */
  private static final class Flight implements AutoCloseable {
    private final HeadlessSimulator simulator;
    private final List<String> addresses;
    private final int statePort = freePort();
    private final int videoPort = freePort();

    Flight(int drones, TimeFactor timeFactor) throws IOException, InterruptedException {
      this(
          SimConfig.DEFAULT
              .withRoom(HALL, Formation.row(drones, Vec3.ZERO, HALL))
              .withTimeFactor(timeFactor));
    }

    Flight(SimConfig config) throws IOException, InterruptedException {
      List<InetAddress> loopback = List.of(InetAddress.getLoopbackAddress());
      simulator =
          HeadlessSimulators.of(
              Scenario.of(config.withStreamPorts(new StreamPorts(statePort, videoPort))),
              AddressPlan.portPerDrone(config.starts().size(), loopback, 0));
      simulator.switchOn();
      addresses =
          ADDRESS.matcher(printed(simulator::sayReady)).results().map(MatchResult::group).toList();
    }

    List<String> addresses() {
      return addresses;
    }

    String host() {
      return addresses.get(0).split(":", -1)[0];
    }

    String port() {
      return addresses.get(0).split(":", -1)[1];
    }

    /** A port other than 8890, which may receive another simulator's state. */
    String statePort() {
      return Integer.toString(statePort);
    }

    /** A port other than 11111, which may receive another simulator's video. */
    String videoPort() {
      return Integer.toString(videoPort);
    }

    /** Returns the positions of the drones; ends the console, so it can be called only once. */
    List<Place> places() throws InterruptedException {
      BufferedReader typed = new BufferedReader(new StringReader("state\nquit\n"));
      ByteArrayOutputStream printed = new ByteArrayOutputStream();
      simulator.run(typed, new PrintStream(printed, true, StandardCharsets.UTF_8));
      return Place.FORM
          .matcher(printed.toString(StandardCharsets.UTF_8))
          .results()
          .map(Place::of)
          .toList();
    }

    private static String printed(Consumer<PrintStream> printer) {
      ByteArrayOutputStream printed = new ByteArrayOutputStream();
      printer.accept(new PrintStream(printed, true, StandardCharsets.UTF_8));
      return printed.toString(StandardCharsets.UTF_8);
    }

    @Override
    public void close() {
      simulator.close();
    }
  }
}
