package tellosimulator.web;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import tellosimulator.goal.Challenge;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.pilot.DemoTour;
import tellosimulator.pilot.GoalRoute;
import tellosimulator.pilot.OperatorSocket;
import tellosimulator.pilot.ScriptedFlight;
import tellosimulator.sim.SimSnapshot;

/**
 * Sends commands of pages to the drones' command ports, as any operator program does. Thread-safe.
 */
final class WebPilot implements AutoCloseable {

  /** The commands with which people fly by hand. */
  private static final Pattern COMMAND =
      Pattern.compile("takeoff|land|stop|emergency|flip [lrfb]|rc( -?[0-9]{1,3}){4}");

  private final Map<InetSocketAddress, OperatorSocket> sockets = new HashMap<>();
  private Optional<Demo> demo = Optional.empty();

  /**
   * A demo.
   *
   * @param scenario the number of the scenario
   */
  private record Demo(int scenario, int drone, ScriptedFlight flight) {}

  /**
   * Sends a command, and does not wait for the reply, which is part of the state. Ends a demo of
   * the drone.
   *
   * @throws IllegalArgumentException if it is not a command for flying by hand
   * @throws IllegalStateException if the drone cannot be reached; the message is one sentence
   */
  synchronized void send(WebSubject subject, int drone, String command) {
    if (!COMMAND.matcher(command).matches()) {
      throw new IllegalArgumentException(
          "the page flies only with takeoff, land, stop, emergency, flip and rc");
    }
    if (demo.filter(each -> each.drone == drone).isPresent()) {
      endDemo();
    }
    OnlineSimulation simulation = subject.simulation();
    InetSocketAddress address = simulation.addresses(drone).get(0);
    try {
      OperatorSocket socket = socket(address);
      if (simulation.snapshot().drones().get(drone - 1).link().operator().isEmpty()) {
        socket.send("command");
      }
      socket.send(command);
    } catch (IOException e) {
      Optional.ofNullable(sockets.remove(address)).ifPresent(OperatorSocket::close);
      throw unreachable(drone, e);
    }
  }

  private static IllegalStateException unreachable(int drone, IOException e) {
    return new IllegalStateException("drone " + drone + " cannot be reached: switch it on", e);
  }

  private OperatorSocket socket(InetSocketAddress address) throws IOException {
    OperatorSocket known = sockets.get(address);
    if (known == null) {
      known = OperatorSocket.open(address);
      sockets.put(address, known);
    }
    while (known.receive().isPresent()) {
      // the state has the reply; it must not fill the buffer
    }
    return known;
  }

  /**
   * Flies the goals of a challenge, or a tour if that is impossible. If a demo is running, ends it.
   *
   * @throws IllegalStateException if the drone is not standing, or cannot be reached; the message
   *     is one sentence
   */
  synchronized void demo(WebSubject subject, int drone) {
    if (fliesDemo(subject)) {
      endDemo();
      return;
    }
    OnlineSimulation simulation = subject.simulation();
    Challenge challenge = subject.goals().progress().challenge();
    SimSnapshot snapshot = simulation.snapshot();
    if (snapshot.drones().get(drone - 1).state().phase().flying()) {
      throw new IllegalStateException("the drone is in the air: land it first");
    }
    List<String> commands =
        GoalRoute.commands(challenge, snapshot, drone)
            .orElseGet(() -> new DemoTour(snapshot, drone).commands());
    try {
      InetSocketAddress address = simulation.addresses(drone).get(0);
      ScriptedFlight flight =
          new ScriptedFlight(address, commands, () -> simulation.time().nanos());
      demo = Optional.of(new Demo(subject.number(), drone, flight));
    } catch (IOException e) {
      throw unreachable(drone, e);
    }
  }

  /** Whether a demo of the scenario is running. */
  synchronized boolean fliesDemo(WebSubject subject) {
    if (demo.filter(each -> each.scenario != subject.number()).isPresent()) {
      endDemo(); // its drone is gone
    }
    return demo.filter(each -> !each.flight.ended()).isPresent();
  }

  private void endDemo() {
    demo.ifPresent(each -> each.flight.close());
    demo = Optional.empty();
  }

  @Override
  public synchronized void close() {
    endDemo();
    sockets.values().forEach(OperatorSocket::close);
    sockets.clear();
  }
}
