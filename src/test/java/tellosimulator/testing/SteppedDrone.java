package tellosimulator.testing;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.BooleanSupplier;
import tellosimulator.command.Link;
import tellosimulator.command.Peer;
import tellosimulator.fault.LinkPreset;
import tellosimulator.model.DroneState;
import tellosimulator.network.CommandResponseSender;
import tellosimulator.network.Ports;
import tellosimulator.network.StateConnection;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.time.SimTime;

/**
 * One simulated drone, switched on, that a test talks to and whose time it steps: no sockets, no
 * threads, no waiting. What the drone sends is collected as it would leave on the wire.
 */
public final class SteppedDrone {

  /** Where the drone is commanded. */
  public static final InetSocketAddress DRONE = address("192.168.10.1", 8889);

  /** Who commands unless a test says otherwise. */
  public static final InetSocketAddress CLIENT = address("192.168.10.2", 9000);

  /** Longest simulated time that {@link #ask} waits [s]. */
  private static final double PATIENCE = 30;

  /**
   * A datagram that left the drone.
   *
   * @param seconds simulated time since the start
   * @param to its destination
   * @param text its bytes as ISO-8859-1
   */
  public record Sent(double seconds, InetSocketAddress to, String text) {}

  private final Simulation simulation;
  private final InMemoryPort replyPort = new InMemoryPort(DRONE);
  private final InMemoryPort statePort = new InMemoryPort(DRONE);
  private final List<Sent> replies = new ArrayList<>();
  private final List<Sent> stateLines = new ArrayList<>();
  private final List<SimEvent> events = new ArrayList<>();

  private SteppedDrone(SimConfig config, OptionalInt fixedReplyPort) {
    CommandResponseSender sender =
        new CommandResponseSender(new Ports(List.of(replyPort)), fixedReplyPort);
    SimListener listener =
        new SimListener() {
          @Override
          public void event(SimEvent event) {
            events.add(event);
          }
        };
    simulation =
        new Simulation(
            config,
            number -> sender,
            new StateConnection(new Ports(List.of(statePort))),
            List.of(listener));
    control(new Control.Power(1, true));
  }

  /** In the middle of the default room, on an ideal link. */
  public static SteppedDrone of(Profile profile, Behavior behavior) {
    return of(SimConfig.DEFAULT.withProduct(profile, behavior).withLink(LinkPreset.IDEAL));
  }

  /** The first drone of a configuration. */
  public static SteppedDrone of(SimConfig config) {
    return new SteppedDrone(config, OptionalInt.empty());
  }

  /** The first drone of a configuration, with all replies to one port of the client's host. */
  public static SteppedDrone withReplyPort(SimConfig config, int port) {
    return new SteppedDrone(config, OptionalInt.of(port));
  }

  /** An address without any look-up. */
  public static InetSocketAddress address(String ip, int port) {
    try {
      return new InetSocketAddress(InetAddress.getByName(ip), port);
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException("ip is " + ip + ", but must be an IP address", e);
    }
  }

  // --- what a client does ---

  /** A datagram arrives from {@link #CLIENT}; replies that need no time are there at once. */
  public void send(String text) {
    send(CLIENT, text);
  }

  /** A datagram arrives. */
  public void send(InetSocketAddress client, String text) {
    simulation.submit(1, new Peer(client, DRONE), text);
    simulation.drain();
    collect();
  }

  /**
   * Sends a command and lets time pass until a reply comes.
   *
   * @throws AssertionError if none comes within 30 s
   */
  public String ask(String text) {
    int before = replies.size();
    send(text);
    if (!advanceUntil(() -> replies.size() > before, PATIENCE)) {
      throw new AssertionError("no reply to `" + text + "` within " + PATIENCE + " s");
    }
    return replies.get(before).text();
  }

  // --- what a person does ---

  public void control(Control control) {
    simulation.control(control);
    simulation.drain();
    collect();
  }

  // --- time ---

  /** Simulated time since the start [s]. */
  public double seconds() {
    return simulation.snapshot().time().seconds();
  }

  /** Lets simulated time pass. */
  public void advance(double seconds) {
    long steps = Math.round(seconds / SimTime.STEP);
    for (long i = 0; i < steps; i++) {
      step();
    }
  }

  /**
   * Lets simulated time pass until something is so.
   *
   * @param mostSeconds how long at the most
   * @return whether it is so
   */
  public boolean advanceUntil(BooleanSupplier reached, double mostSeconds) {
    double end = seconds() + mostSeconds;
    while (!reached.getAsBoolean() && seconds() < end) {
      step();
    }
    return reached.getAsBoolean();
  }

  // --- what can be seen ---

  /** The drone at the end of the last step. */
  public DroneState state() {
    return snapshot().state();
  }

  /** Where state and video go. */
  public Link link() {
    return snapshot().link();
  }

  /** All replies so far, in order. */
  public List<Sent> replies() {
    return List.copyOf(replies);
  }

  /** All state lines so far, in order. */
  public List<Sent> stateLines() {
    return List.copyOf(stateLines);
  }

  /** What happened so far, in order. */
  public List<SimEvent> events() {
    return List.copyOf(events);
  }

  /** All that a snapshot has of the drone, at the end of the last step. */
  public DroneSnapshot snapshot() {
    return simulation.snapshot().drones().get(0);
  }

  private void step() {
    simulation.step();
    collect();
  }

  private void collect() {
    replyPort.takeSent().forEach(sent -> replies.add(at(sent)));
    statePort.takeSent().forEach(sent -> stateLines.add(at(sent)));
  }

  private Sent at(InMemoryPort.Sent sent) {
    return new Sent(seconds(), sent.to(), sent.text());
  }
}
