package tellosimulator.proxy;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.CommandSyntax;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.network.LocalNetworks;
import tellosimulator.network.PortTakenException;
import tellosimulator.network.Reach;
import tellosimulator.network.UdpPort;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.protocol.app.NamedPacket;
import tellosimulator.protocol.app.VideoPort;
import tellosimulator.recording.DroneRecorder;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.WallTime;

/**
 * Forwards datagrams between operators and a drone. Each datagram is forwarded immediately and
 * unchanged, and then passed to the recorder; only the port for the video in {@code conn_req} is
 * replaced by the relay's own, so that the video passes through the relay. Neither an unexpected
 * datagram nor a lack of datagrams can stop the relay. Not thread-safe, except for {@link
 * #addresses}, {@link #streamPorts} and {@link #end}.
 */
final class Relay implements Agent {

  private static final Logger LOG = LoggerFactory.getLogger(Relay.class);

  /** Size of the receive buffer, enough for any UDP datagram [bytes]. Documented: RFC 768. */
  private static final int BUFFER = 65_535;

  /** Maximum number of datagrams read from one socket before the next socket is read. Decided. */
  private static final int MOST_OF_PORT = 64;

  private final ErrorPolicy failed = ErrorPolicy.goOn("A datagram could not be passed on");
  private final ProxyPlan plan;
  private final DroneRecorder recorder;
  private final Selector selector;
  private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER);
  private final OperatorPorts operators;
  private final DronePorts towardsDrone;
  private final DroneWatch watch;
  private final List<UdpPort> listening = new ArrayList<>();
  private final Polling polling;
  private LocalNetworks networks;
  private long looked = WallTime.nanoTime();

  /**
   * The peer that sent {@code command} or {@code conn_req} last. State and video are forwarded to
   * this peer.
   */
  private Optional<Peer> operator = Optional.empty();

  /** The port for which the operator's {@code conn_req} wants the video; empty after a command. */
  private OptionalInt videoPort = OptionalInt.empty();

  private Optional<IOException> failure = Optional.empty();
  private boolean foreignTold;

  /** Messages about the sockets that could not be opened during the last check. */
  private List<String> obstacles = List.of();

  private volatile boolean closed;
  private volatile List<InetSocketAddress> addresses = List.of();

  /**
   * How the relay detects that this machine has joined another network.
   *
   * @param networks looks up this machine's addresses
   * @param periodMs interval between lookups [ms]
   */
  record Polling(Supplier<LocalNetworks> networks, long periodMs) {

    /** Polls once a second. Decided. */
    static final Polling DEFAULT = new Polling(LocalNetworks::look, 1000);

    private long periodNanos() {
      return TimeUnit.MILLISECONDS.toNanos(periodMs);
    }
  }

  /** A socket and the handler for its datagrams. */
  private record Source(UdpPort port, Taker taker) {}

  /** Handles a received datagram. */
  @FunctionalInterface
  private interface Taker {
    void take(InetSocketAddress sender, byte[] bytes, long nanos);
  }

  private Relay(ProxyPlan plan, DroneRecorder recorder, Polling polling, Selector selector) {
    this.plan = plan;
    this.recorder = recorder;
    this.polling = polling;
    this.selector = selector;
    networks = polling.networks().get();
    operators = new OperatorPorts();
    towardsDrone = new DronePorts(plan.drone(), plan.towardsDrone());
    watch = new DroneWatch(plan.drone());
  }

  /**
   * Opens the sockets.
   *
   * @throws PortTakenException if a socket cannot be opened; no socket is open afterwards
   */
  static Relay open(ProxyPlan plan, DroneRecorder recorder, Polling polling)
      throws PortTakenException {
    Relay relay;
    try {
      relay = new Relay(plan, recorder, polling, Selector.open());
    } catch (IOException e) {
      throw new IllegalStateException(
          "the system cannot provide a selector for receiving datagrams", e);
    }
    try {
      for (InetSocketAddress wanted : relay.missing()) {
        relay.listen(wanted);
      }
      relay.follow();
      return relay;
    } catch (PortTakenException | RuntimeException e) {
      relay.onClose();
      throw e;
    }
  }

  /** The addresses where the relay accepts commands. Thread-safe. */
  List<InetSocketAddress> addresses() {
    return addresses;
  }

  /** The ports to which the drone sends; 0 while there is no route to it. Thread-safe. */
  StreamPorts streamPorts() {
    return towardsDrone.streamPorts();
  }

  /** Stops the relay after the work in progress. Thread-safe. */
  void end() {
    closed = true;
    synchronized (this) { // not on the selector, which is locked while it waits
      if (selector.isOpen()) { // a closed selector must not be woken
        selector.wakeup();
      }
    }
  }

  @Override
  public Outcome doWork() throws IOException {
    selector.select(this::read, polling.periodMs());
    long now = WallTime.nanoTime();
    if (now - looked >= polling.periodNanos()) {
      looked = now;
      recorder.tick(now);
      watch.tick(now);
      look();
    }
    if (failure.isPresent()) {
      IOException first = failure.get();
      failure = Optional.empty();
      throw first;
    }
    return closed ? Outcome.FINISHED : Outcome.WORKED;
  }

  /** Reads a socket; a failure does not affect the other sockets. */
  private void read(SelectionKey key) {
    Source source = (Source) key.attachment();
    try {
      boolean more = true;
      for (int i = 0; more && i < MOST_OF_PORT; i++) {
        more = readNext(source);
      }
    } catch (ClosedChannelException e) {
      key.cancel();
    } catch (IOException e) {
      failure = Optional.of(e);
    }
  }

  private boolean readNext(Source source) throws IOException {
    InetSocketAddress sender = source.port().receive(buffer.clear());
    if (sender == null) {
      return false;
    }
    long nanos = WallTime.nanoTime();
    byte[] bytes = new byte[buffer.flip().remaining()];
    buffer.get(bytes);
    source.taker().take(sender, bytes, nanos);
    return true;
  }

  // --- from operators to the drone ---

  private void command(UdpPort port, InetSocketAddress sender, byte[] bytes, long nanos) {
    if (!networks.neighbors(port.address().getAddress(), sender.getAddress())) {
      tellForeign(sender);
      return;
    }
    Peer peer = new Peer(sender, port.address());
    Optional<UdpPort> open = operators.of(sender, () -> replyPort(port, sender));
    if (open.isEmpty()) {
      return;
    }
    OptionalInt asked = VideoPort.of(bytes);
    int own = streamPorts().videoPort();
    boolean redirects = asked.isPresent() && own != 0;
    open.get().send(redirects ? VideoPort.replaced(bytes, own) : bytes, plan.drone());
    if (asked.isPresent() || isCommand(bytes)) {
      operator = Optional.of(peer);
      videoPort = asked;
    }
    watch.commanded(nanos);
    recorder.command(nanos, sender, plan.drone(), bytes);
  }

  /** Returns whether a datagram consists of {@code command}, possibly with a line end. */
  private static boolean isCommand(byte[] bytes) {
    return WireText.decode(bytes)
        .replaceFirst("[\\x00- ]+$", "")
        .equals(CommandSyntax.COMMAND.verb());
  }

  private UdpPort replyPort(UdpPort port, InetSocketAddress asked) throws IOException {
    UdpPort opened = UdpPort.open(new InetSocketAddress(0));
    receive(opened, (sender, bytes, nanos) -> reply(port, asked, sender, bytes, nanos));
    return opened;
  }

  private void tellForeign(InetSocketAddress sender) {
    if (!foreignTold) {
      LOG.warn(
          "{} is no private address of this machine's networks, so its commands are not passed on",
          sender.getAddress().getHostAddress());
    }
    foreignTold = true;
  }

  // --- from the drone to operators ---

  private void reply(
      UdpPort port, InetSocketAddress asked, InetSocketAddress sender, byte[] bytes, long nanos) {
    if (isDrone(sender)) {
      boolean acknowledges = VideoPort.of(bytes).isPresent() && videoPort.isPresent();
      byte[] passed = acknowledges ? VideoPort.replaced(bytes, videoPort.getAsInt()) : bytes;
      port.send(passed, asked);
      boolean unasked =
          NamedPacket.of(bytes).filter(packet -> packet.reply().isEmpty()).isPresent();
      recorder.sent(nanos, unasked ? Kind.STATE : Kind.REPLY, sender, asked, passed);
    }
  }

  private void push(Kind kind, InetSocketAddress sender, byte[] bytes, long nanos) {
    if (!isDrone(sender) || addresses.contains(sender) || operator.isEmpty()) {
      return;
    }
    Peer to = operator.get();
    int number =
        kind == Kind.STATE
            ? plan.towardsOperator().statePort()
            : videoPort.orElse(plan.towardsOperator().videoPort());
    InetSocketAddress place = new InetSocketAddress(to.address().getAddress(), number);
    listening.stream()
        .filter(port -> port.address().equals(to.via()))
        .forEach(port -> port.send(bytes, place));
    recorder.sent(nanos, kind, sender, place, bytes);
  }

  /** Returns whether a datagram comes from the drone, from any of its ports. */
  private boolean isDrone(InetSocketAddress sender) {
    boolean drone = sender.getAddress().equals(plan.drone().getAddress());
    if (drone) {
      watch.heard();
    }
    return drone;
  }

  // --- sockets ---

  private void receive(UdpPort port, Taker taker) {
    port.register(selector, new Source(port, taker));
  }

  /**
   * Checks whether this machine has joined another network, such as the drone's. At each check,
   * sockets that could not be opened before are tried again. A socket that fails is reported once.
   * It is reported again only if it fails after having been opened successfully.
   */
  void look() {
    List<String> found = new ArrayList<>();
    boolean moved = false;
    try {
      moved = follow();
    } catch (PortTakenException e) {
      found.add(e.getMessage());
    }
    if (moved || plan.here().reach() == Reach.NETWORK) { // the lookup is slow on some systems
      networks = polling.networks().get();
    }
    for (InetSocketAddress wanted : missing()) {
      try {
        listen(wanted);
      } catch (PortTakenException e) {
        found.add(e.getMessage());
      }
    }
    found.stream()
        .filter(sentence -> !obstacles.contains(sentence))
        .forEach(sentence -> LOG.warn("{}", sentence));
    obstacles = found;
  }

  /** Opens new sockets if the route to the drone has changed; returns whether it has. */
  private boolean follow() throws PortTakenException {
    boolean moved = towardsDrone.follow();
    if (moved) {
      towardsDrone
          .ports()
          .forEach(
              (kind, port) ->
                  receive(port, (from, bytes, nanos) -> push(kind, from, bytes, nanos)));
    }
    return moved;
  }

  /** Returns the addresses where commands are to be accepted but no socket is open yet. */
  private List<InetSocketAddress> missing() {
    return plan.addresses(networks).stream()
        .filter(
            wanted ->
                listening.stream()
                    .noneMatch(port -> port.address().getAddress().equals(wanted.getAddress())))
        .toList();
  }

  /**
   * Accepts commands at an address. If the system chose the port of the first address, the other
   * addresses use the same port.
   */
  private void listen(InetSocketAddress wanted) throws PortTakenException {
    boolean chosen = wanted.getPort() == 0 && !listening.isEmpty();
    int number = chosen ? listening.get(0).address().getPort() : wanted.getPort();
    UdpPort port = UdpPort.bind(new InetSocketAddress(wanted.getAddress(), number));
    listening.add(port);
    receive(port, (sender, bytes, nanos) -> command(port, sender, bytes, nanos));
    addresses = listening.stream().map(UdpPort::address).toList();
  }

  @Override
  public ErrorPolicy onError(Throwable thrown) {
    return failed;
  }

  @Override
  public void onClose() {
    listening.forEach(UdpPort::close);
    operators.close();
    towardsDrone.close();
    try {
      synchronized (this) {
        selector.close();
      }
    } catch (IOException e) {
      LOG.debug("Closing the selector failed: {}", e.toString());
    }
  }
}
