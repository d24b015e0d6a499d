package tellosimulator.network;

import java.net.InetAddress;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import tellosimulator.command.OperatorRule;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.sim.Simulation;
import tellosimulator.time.TokenBucket;
import tellosimulator.words.Phrase;

/**
 * Decides at the receiver whether a datagram may cost the simulation a turn. Commands of the
 * operator's host always may; everything else is limited by a token bucket for each host, and what
 * comes from outside the machine's own networks never may. What is turned away is counted, and told
 * in sums. For any thread.
 *
 * <p>This only keeps floods away. Which command has which effect is up to the simulation.
 */
final class AdmissionControl {

  /**
   * What a host may send besides the operator's commands [1/s]. Decided: a program that looks on,
   * or that finds its drone free after each power cycle; typing errors are fewer.
   */
  private static final double RATE = 200;

  private static final double BURST = 1000;

  /** The same of all hosts together that do not operate the drone [1/s]. Decided: two classes. */
  private static final double STRANGERS_RATE = 500;

  private static final double STRANGERS_BURST = 2000;

  /** Hosts that are remembered. Assumed: more than any class has. */
  private static final int MOST_HOSTS = 256;

  private static final Phrase TOO_MANY = Phrase.of("too many at once");
  private static final Phrase FOREIGN =
      Phrase.of(
          "only private addresses of this machine's own networks are listened to;"
              + " --operator names another one");

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

  /** What came from a host. */
  private static final class Source {
    private final TokenBucket bucket;
    private long dropped;

    Source(LongSupplier nanos) {
      bucket = new TokenBucket(RATE, BURST, nanos);
    }
  }

  /**
   * By the wall clock.
   *
   * @param drone its number, from 1
   */
  AdmissionControl(int drone, Simulation simulation) {
    this(drone, simulation, TokenBucket.WALL_CLOCK);
  }

  /**
   * By some clock.
   *
   * @param drone its number, from 1
   * @param nanos a clock that never goes back [ns]
   */
  AdmissionControl(int drone, Simulation simulation, LongSupplier nanos) {
    this.drone = drone;
    this.simulation = simulation;
    this.nanos = nanos;
    this.strangers = new TokenBucket(STRANGERS_RATE, STRANGERS_BURST, nanos);
  }

  /**
   * Whether a datagram is to be taken.
   *
   * @param via the address of this machine that it came to
   * @param bytes begin with the datagram
   * @param length of the datagram [bytes]
   * @param networks of this machine
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
    if (operates && WireText.beginsLikeCommand(bytes, length)) {
      return true;
    }
    Source source = source(sender);
    boolean room = source.bucket.tryTake() && (operates || strangers.tryTake());
    if (!room) {
      source.dropped++;
    }
    return room;
  }

  /** Tells the simulation how many datagrams were turned away since this was called last. */
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
    Source known = sources.get(host); // computeIfAbsent would make an object for each datagram
    if (known == null) {
      known = new Source(nanos);
      sources.put(host, known);
    }
    return known;
  }

  /** Written without a stream, as floods come through here. */
  private boolean operates(InetAddress host) {
    Optional<Peer> operator = simulation.snapshot().drones().get(drone - 1).link().operator();
    return operator.isPresent() && operator.get().address().getAddress().equals(host);
  }
}
