package tellosimulator.network;

import java.net.InetAddress;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import tellosimulator.command.OperatorRule;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.protocol.app.AppProtocol;
import tellosimulator.sim.Simulation;
import tellosimulator.time.TokenBucket;
import tellosimulator.words.Phrase;

/**
 * Decides in the receiver whether a datagram is passed on to the simulation. Commands and packets
 * from the operator's host are always passed on. Token buckets limit all other traffic: one for
 * each host, and a common one for all hosts that do not operate the drone. Traffic from outside the
 * machine's own networks is rejected, unless the {@link OperatorRule} names its host. Rejected
 * datagrams are counted, and only their totals are reported. Thread-safe.
 *
 * <p>This class only protects against floods. The simulation decides the effect of a command.
 */
final class AdmissionControl {

  /**
   * Rate at which datagrams other than the operator's commands are accepted from a host [1/s].
   * Decided: enough for a program that only reads, and for one that sends commands to a drone that
   * has no operator yet after a power cycle. Misspelt commands are less frequent.
   */
  private static final double RATE = 200;

  private static final double BURST = 1000;

  /**
   * Combined limit for all hosts that do not operate the drone [1/s]. Decided: enough for two
   * school classes.
   */
  private static final double STRANGERS_RATE = 500;

  private static final double STRANGERS_BURST = 2000;

  /** Maximum number of hosts that are tracked. Assumed: more hosts than any school class has. */
  private static final int MOST_HOSTS = 256;

  private static final Phrase TOO_MANY = Phrase.of("too many at once");
  private static final Phrase FOREIGN =
      Phrase.of(
          "only private addresses on this machine's own networks are accepted;"
              + " use --operator to allow another one");

  private final int drone;
  private final Simulation simulation;
  private final Map<InetAddress, Source> sources =
      new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<InetAddress, Source> eldest) {
          return size() > MOST_HOSTS;
        }
      };

  private final LongSupplier nanos;
  private final TokenBucket strangers;
  private long foreign;
  private InetAddress lastForeign = AddressPlan.loopback(1);

  /** The traffic of one host. */
  private static final class Source {
    private final TokenBucket bucket;
    private long dropped;

    Source(LongSupplier nanos) {
      bucket = new TokenBucket(RATE, BURST, nanos);
    }
  }

  /**
   * Creates an admission control that uses the wall clock.
   *
   * @param drone the drone's number, from 1
   */
  AdmissionControl(int drone, Simulation simulation) {
    this(drone, simulation, TokenBucket.WALL_CLOCK);
  }

  /**
   * Creates an admission control with a given clock.
   *
   * @param drone the drone's number, from 1
   * @param nanos a monotonic clock [ns]
   */
  AdmissionControl(int drone, Simulation simulation, LongSupplier nanos) {
    this.drone = drone;
    this.simulation = simulation;
    this.nanos = nanos;
    this.strangers = new TokenBucket(STRANGERS_RATE, STRANGERS_BURST, nanos);
  }

  /**
   * Returns whether a datagram is accepted.
   *
   * @param via the address of this machine at which the datagram arrived
   * @param bytes a buffer that starts with the datagram
   * @param length the datagram's length [bytes]
   * @param networks this machine's networks
   */
  synchronized boolean admits(
      InetAddress sender, InetAddress via, byte[] bytes, int length, LocalNetworks networks) {
    OperatorRule rule = simulation.operators();
    if (!rule.names(sender) && !networks.neighbors(via, sender)) {
      foreign++;
      lastForeign = sender;
      return false;
    }
    boolean operates = !rule.exclusive() || operates(sender);
    if (operates
        && (WireText.beginsLikeCommand(bytes, length) || AppProtocol.isPacket(bytes, length))) {
      return true;
    }
    Source source = source(sender);
    boolean room = source.bucket.tryTake() && (operates || strangers.tryTake());
    if (!room) {
      source.dropped++;
    }
    return room;
  }

  /** Reports to the simulation how many datagrams have been rejected since the last call. */
  synchronized void report() {
    sources.forEach(
        (host, source) -> {
          if (source.dropped > 0) {
            simulation.dropped(drone, host, source.dropped, TOO_MANY);
            source.dropped = 0;
          }
        });
    if (foreign > 0) {
      simulation.dropped(drone, lastForeign, foreign, FOREIGN);
      foreign = 0;
    }
  }

  private Source source(InetAddress host) {
    Source known = sources.get(host); // computeIfAbsent would allocate for each datagram
    if (known == null) {
      known = new Source(nanos);
      sources.put(host, known);
    }
    return known;
  }

  /**
   * Returns whether a host operates the drone. Avoids streams, because every datagram of a flood
   * passes through here.
   */
  private boolean operates(InetAddress host) {
    Optional<Peer> operator = simulation.snapshot().drones().get(drone - 1).link().operator();
    return operator.isPresent() && operator.get().address().getAddress().equals(host);
  }
}
