package tellosimulator.replay;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import tellosimulator.fault.Fault;
import tellosimulator.goal.GoalWatch;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.world.Wind;

/**
 * An operator program that communicates with a simulation over real sockets while its flights are
 * recorded. Each of its lines is a word and its arguments: the number of a drone and a command,
 * whose reply is awaited unless it is preceded by {@code !}, or one of {@code states}, {@code
 * reset}, {@code power}, {@code battery}, {@code wind}, {@code fault}, {@code start}, {@code pass},
 * {@code restart} and {@code flood}.
 */
final class RecordedProgram implements AutoCloseable {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final int PATIENCE_MS = 60_000;

  private final DatagramSocket commands = socket();
  private final DatagramSocket states = socket();
  private final SimConfig config;
  private final RecordingFolder folder;
  private final OnlineSimulation simulation;
  private final GoalWatch goals;
  private final FlightRecorder recorder;

  private RecordedProgram(Scenario scenario, Path parent) throws IOException {
    config = scenario.config().withStreamPorts(new StreamPorts(states.getLocalPort(), 9));
    folder = RecordingFolder.at(parent);
    FlightRecorder[] later = new FlightRecorder[1];
    goals = new GoalWatch(scenario.challenge(), news -> later[0].event(news));
    later[0] =
        FlightRecorder.start(
            folder,
            new FlightRecorder.Subject(
                "A program", scenario.withConfig(config), List.of("--seed", "3"), goals),
            reason -> {
              throw new AssertionError(reason.english());
            });
    recorder = later[0];
    int drones = config.drones().size();
    simulation =
        new OnlineSimulation(
            config,
            AddressPlan.portPerDrone(drones, List.of(LOOPBACK), 0),
            OptionalInt.empty(),
            List.of(goals));
    recorder.attach(simulation);
    simulation.switchAllOn();
  }

  /**
   * Runs a program until it ends.
   *
   * @return the folders of the flights, in order
   */
  static List<Path> run(Scenario scenario, String program, Path parent) throws IOException {
    RecordedProgram running = new RecordedProgram(scenario, parent);
    try (running) {
      for (String line : program.lines().toList()) {
        running.line(line.split(" ", 2)[0], line.substring(line.indexOf(' ') + 1));
      }
    }
    return running.folder.made();
  }

  private static DatagramSocket socket() throws IOException {
    DatagramSocket socket = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0));
    socket.setSoTimeout(PATIENCE_MS);
    return socket;
  }

  private void line(String word, String rest) throws IOException {
    String[] words = rest.split(" ", -1);
    switch (word) {
      case "states" -> {
        for (int i = 0; i < Integer.parseInt(rest); i++) {
          receive(states);
        }
      }
      case "reset" -> simulation.carryOut(new Control.Reset(Integer.parseInt(rest)));
      case "power" ->
          simulation.carryOut(new Control.Power(Integer.parseInt(words[0]), words[1].equals("on")));
      case "battery" ->
          simulation.carryOut(
              new Control.SetBattery(Integer.parseInt(words[0]), Double.parseDouble(words[1])));
      case "start" ->
          simulation.carryOut(
              new Control.SetStart(
                  Integer.parseInt(words[0]),
                  new Vec3(Double.parseDouble(words[1]), Double.parseDouble(words[2]), 0),
                  Double.parseDouble(words[3])));
      case "wind" ->
          simulation.carryOut(
              new Control.SetWind(
                  new Wind(
                      new Vec3(Double.parseDouble(words[0]), Double.parseDouble(words[1]), 0),
                      Double.parseDouble(words[2]))));
      case "fault" -> simulation.carryOut(new Control.InjectFault(Fault.of(rest)));
      case "pass" -> simulation.letPass(Double.parseDouble(rest));
      case "restart" -> simulation.restart(config.withSeed(Long.parseLong(rest)));
      case "flood" -> {
        for (int i = 0; i < Integer.parseInt(rest); i++) {
          send(1, i % 3 == 0 ? "rc 0 " + i % 40 + " 0 0" : "battery?");
          if (i % 40 == 20) {
            simulation.carryOut(new Control.SetBattery(1, 50 + i % 50));
          }
        }
        simulation.settle();
      }
      default -> command(word, rest);
    }
  }

  private void command(String word, String text) throws IOException {
    boolean unanswered = word.startsWith("!");
    send(Integer.parseInt(word.substring(unanswered ? 1 : 0)), text);
    if (!unanswered) {
      receive(commands);
    }
  }

  private void send(int drone, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    commands.send(new DatagramPacket(bytes, bytes.length, simulation.addresses(drone).get(0)));
  }

  private static void receive(DatagramSocket socket) throws IOException {
    socket.receive(new DatagramPacket(new byte[1500], 1500));
  }

  @Override
  public void close() {
    simulation.close();
    goals.close();
    recorder.close();
    commands.close();
    states.close();
  }
}
