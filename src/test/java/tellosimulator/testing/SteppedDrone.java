package tellosimulator.testing;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.BooleanSupplier;
import tellosimulator.command.DronePort;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.command.Peer;
import tellosimulator.command.PhotoCamera;
import tellosimulator.command.WireText;
import tellosimulator.fault.LinkDirection;
import tellosimulator.fault.LinkPreset;
import tellosimulator.model.DroneState;
import tellosimulator.network.DatagramSender;
import tellosimulator.network.Ports;
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
 * One simulated drone, switched on, for a test that sends commands and steps simulated time: no
 * sockets, no threads, no waiting. The drone's datagrams are collected as they would leave on the
 * wire.
 */
public final class SteppedDrone {

  /** The drone's address for commands. */
  public static final InetSocketAddress DRONE = address("192.168.10.1", 8889);

  /** The default client. */
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
    DronePort replySender = new DatagramSender(new Ports(List.of(replyPort)), fixedReplyPort);
    DronePort stateSender = new DatagramSender(new Ports(List.of(statePort)), fixedReplyPort);
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
            number ->
                datagram ->
                    (datagram.direction() == LinkDirection.STATE ? stateSender : replySender)
                        .send(datagram),
            List.of(listener));
    control(new Control.Power(1, true));
  }

  /** Creates a drone in the middle of the default room, on an ideal link. */
  public static SteppedDrone of(Profile profile, Behavior behavior) {
    return of(SimConfig.DEFAULT.withProduct(profile, behavior).withLink(LinkPreset.IDEAL));
  }

  /** Creates the first drone of a configuration. */
  public static SteppedDrone of(SimConfig config) {
    return new SteppedDrone(config, OptionalInt.empty());
  }

  /**
   * Creates the first drone of a configuration, with all replies to one port of the client's host.
   */
  public static SteppedDrone withReplyPort(SimConfig config, int port) {
    return new SteppedDrone(config, OptionalInt.of(port));
  }

  /** Returns an address without a DNS lookup. */
  public static InetSocketAddress address(String ip, int port) {
    try {
      return new InetSocketAddress(InetAddress.getByName(ip), port);
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException("ip is " + ip + ", but must be an IP address", e);
    }
  }

  // --- client ---

  /** Delivers a datagram from {@link #CLIENT}; immediate replies are available on return. */
  public void send(String text) {
    send(CLIENT, text);
  }

  /** Delivers a datagram. */
  public void send(InetSocketAddress client, String text) {
    simulation.submit(1, new Peer(client, DRONE), WireText.encode(text));
    simulation.drain();
    collect();
  }

  /**
   * Sends a command and advances time until a reply arrives.
   *
   * @throws AssertionError if there is none within 30 s
   */
  public String ask(String text) {
    int before = replies.size();
    send(text);
    if (!advanceUntil(() -> replies.size() > before, PATIENCE)) {
      throw new AssertionError("no reply to `" + text + "` within " + PATIENCE + " s");
    }
    return replies.get(before).text();
  }

  // --- controls ---

  public void control(Control control) {
    simulation.control(control);
    simulation.drain();
    collect();
  }

  /** Sets the camera with which the drone takes photos. */
  public void setCamera(PhotoCamera camera) {
    simulation.setCamera(camera);
  }

  // --- time ---

  /** Returns the simulated time since the start [s]. */
  public double seconds() {
    return simulation.snapshot().time().seconds();
  }

  /** Advances simulated time. */
  public void advance(double seconds) {
    long steps = Math.round(seconds / SimTime.STEP);
    for (long i = 0; i < steps; i++) {
      step();
    }
  }

  /**
   * Advances simulated time until a condition holds.
   *
   * @param mostSeconds time limit
   * @return whether the condition holds
   */
  public boolean advanceUntil(BooleanSupplier reached, double mostSeconds) {
    double end = seconds() + mostSeconds;
    while (!reached.getAsBoolean() && seconds() < end) {
      step();
    }
    return reached.getAsBoolean();
  }

  // --- observations ---

  /** Returns the drone at the end of the last step. */
  public DroneState state() {
    return snapshot().state();
  }

  /** Returns the destination of state and video. */
  public OperatorEndpoint link() {
    return snapshot().link();
  }

  /** Returns all replies so far, in order. */
  public List<Sent> replies() {
    return List.copyOf(replies);
  }

  /** Returns all state lines so far, in order. */
  public List<Sent> stateLines() {
    return List.copyOf(stateLines);
  }

  /** Returns all events so far, in order. */
  public List<SimEvent> events() {
    return List.copyOf(events);
  }

  /** Returns the drone's part of the snapshot at the end of the last step. */
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
