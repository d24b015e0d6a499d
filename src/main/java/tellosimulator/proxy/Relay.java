package tellosimulator.proxy;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.Peer;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.network.LocalNetworks;
import tellosimulator.network.PortTakenException;
import tellosimulator.network.Reach;
import tellosimulator.network.UdpPort;
import tellosimulator.network.WireTap.Kind;
import tellosimulator.recording.DroneRecorder;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.WallTime;

/**
 * Passes datagrams between operators and a drone. Each goes on at once, as it came; the recorder is
 * told afterwards. Nothing that arrives, or does not arrive, ends it. For one thread, but for
 * {@link #addresses}, {@link #streamPorts} and {@link #end}.
 */
final class Relay implements Agent {

  private static final Logger LOG = LoggerFactory.getLogger(Relay.class);

  /** The largest datagram of UDP [bytes]. Documented: RFC 768. */
  private static final int BUFFER = 65_535;

  /** Datagrams that are read from a socket before the next one has its turn. Decided. */
  private static final int MOST_OF_PORT = 64;

  private static final byte[] COMMAND = "command".getBytes(StandardCharsets.US_ASCII);

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

  /** Who sent {@code command} last: state and video go there. */
  private Optional<Peer> operator = Optional.empty();

  private Optional<IOException> failure = Optional.empty();
  private boolean foreignTold;

  /** What could not be had at the last look, in sentences. */
  private List<String> obstacles = List.of();

  private volatile boolean closed;
  private volatile List<InetSocketAddress> addresses = List.of();

  /**
   * How it notices that this machine has joined another network.
   *
   * @param networks finds this machine's addresses
   * @param periodMs between two looks [ms]
   */
  record Polling(Supplier<LocalNetworks> networks, long periodMs) {

    /** Once a second. Decided. */
    static final Polling DEFAULT = new Polling(LocalNetworks::look, 1000);

    private long periodNanos() {
      return TimeUnit.MILLISECONDS.toNanos(periodMs);
    }
  }

  /** A socket, and what becomes of the datagrams that come to it. */
  private record Source(UdpPort port, Taker taker) {}

  /** Takes a datagram that came. */
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
   * @throws PortTakenException if one cannot be had; then none is open
   */
  static Relay open(ProxyPlan plan, DroneRecorder recorder, Polling polling)
      throws PortTakenException {
    Relay relay;
    try {
      relay = new Relay(plan, recorder, polling, Selector.open());
    } catch (IOException e) {
      throw new IllegalStateException("the system lets nobody wait for datagrams", e);
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

  /** Where it takes commands. For any thread. */
  List<InetSocketAddress> addresses() {
    return addresses;
  }

  /** The ports to which the drone sends; 0 while there is no way to it. For any thread. */
  StreamPorts streamPorts() {
    return towardsDrone.streamPorts();
  }

  /** Ends it after what it does now. For any thread. */
  void end() {
    closed = true;
    synchronized (this) { // not on the selector, which locks itself while it waits
      if (selector.isOpen()) { // one that is closed must not be woken
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

  /** A socket that fails holds up no other. */
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
    open.get().send(bytes, plan.drone());
    if (isCommand(bytes)) {
      operator = Optional.of(peer);
    }
    watch.commanded(nanos);
    recorder.command(nanos, sender, plan.drone(), bytes);
  }

  /** Whether it is {@code command}, perhaps with the end of a line. */
  private static boolean isCommand(byte[] bytes) {
    int end = bytes.length;
    while (end > 0 && bytes[end - 1] <= ' ') {
      end--;
    }
    return Arrays.equals(bytes, 0, end, COMMAND, 0, COMMAND.length);
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
      port.send(bytes, asked);
      recorder.sent(nanos, Kind.REPLY, sender, asked, bytes);
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
            : plan.towardsOperator().videoPort();
    InetSocketAddress place = new InetSocketAddress(to.address().getAddress(), number);
    listening.stream()
        .filter(port -> port.address().equals(to.via()))
        .forEach(port -> port.send(bytes, place));
    recorder.sent(nanos, kind, sender, place, bytes);
  }

  /** Whatever port it sends from. */
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

  private void receiveFromDrone() {
    towardsDrone
        .state()
        .ifPresent(
            port ->
                receive(port, (sender, bytes, nanos) -> push(Kind.STATE, sender, bytes, nanos)));
    towardsDrone
        .video()
        .ifPresent(
            port ->
                receive(port, (sender, bytes, nanos) -> push(Kind.VIDEO, sender, bytes, nanos)));
  }

  /**
   * This machine may have joined another network, such as the drone's. What cannot be had is tried
   * again at each look, and told once until it is had.
   */
  void look() {
    List<String> found = new ArrayList<>();
    boolean moved = false;
    try {
      moved = follow();
    } catch (PortTakenException e) {
      found.add(e.getMessage());
    }
    if (moved || plan.here().reach() == Reach.NETWORK) { // some systems take long to say
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

  /** Whether the way to the drone is another one now. */
  private boolean follow() throws PortTakenException {
    boolean moved = towardsDrone.follow();
    if (moved) {
      receiveFromDrone();
    }
    return moved;
  }

  /** Where commands are wanted and not taken yet. */
  private List<InetSocketAddress> missing() {
    return plan.addresses(networks).stream()
        .filter(
            wanted ->
                listening.stream()
                    .noneMatch(port -> port.address().getAddress().equals(wanted.getAddress())))
        .toList();
  }

  /** Takes commands there; where the system chose a port for the first address, at the same one. */
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
