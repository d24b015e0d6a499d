package tellosimulator.fault;

import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Queue;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.sensor.SeededNoise.Channel;
import tellosimulator.time.SimTime;

/**
 * One direction of the link. It can forward a datagram late, twice, corrupted or not at all. While
 * no fault is active and no earlier datagram has to arrive first, it forwards every datagram at
 * once. The number of datagrams in transit is limited, both in total and per party, because
 * datagrams would otherwise pile up while time stands still. A party is a peer at the other end of
 * the link. At a limit, the oldest datagram is dropped. Confined to the simulation thread.
 *
 * @param <T> the type of the datagrams
 */
public final class LossyChannel<T> {

  /**
   * Maximum number of datagrams in transit per party. Decided: no client sends this many before the
   * first of them arrives.
   */
  static final int MOST_FOR_PARTY = 1024;

  /**
   * Maximum number of datagrams in transit. Decided: at most a few megabytes, whatever their
   * content.
   */
  static final int MOST = 4096;

  /** Length of the Ethernet, IP and UDP headers [bytes]. Documented: RFC 791, RFC 768. */
  private static final int HEADERS = 42;

  /**
   * Capacity of a slow link's buffer [s]. Decided: as long as the queue of a cheap access point.
   */
  private static final double BUFFER = 0.5;

  /**
   * Maximum number of attempts to draw a delay within its limits. If all fail, the median is used.
   */
  private static final int TRIES = 16;

  /** The receiver of datagrams. */
  public interface Receiver<T> {

    /** Called when a datagram arrives. */
    void arrived(T datagram);

    /** Called when a datagram is lost. */
    void lost(T datagram, Fault cause);

    /** Returns a corrupted copy of a datagram. */
    T corrupted(T datagram, Corruption corruption);

    /** Returns the length of a datagram [bytes]. */
    int length(T datagram);

    /**
     * Returns the peer that sent the datagram or is to receive it. The number of datagrams in
     * transit is limited for each peer.
     */
    Object party(T datagram);
  }

  private record Waiting<T>(SimTime due, long number, T datagram, boolean owed) {}

  private final SeededNoise noise;
  private final LinkDirection direction;
  private final Receiver<T> receiver;
  private final Deque<Waiting<T>> waiting = new ArrayDeque<>();
  private final Queue<Waiting<T>> overtaken =
      new PriorityQueue<>(
          Comparator.<Waiting<T>, SimTime>comparing(Waiting::due)
              .thenComparingLong(Waiting::number));
  private final Map<Object, Integer> counts = new HashMap<>();
  private Map<FaultKind, Fault> acting = Map.of();
  private long number;
  private boolean losing;
  private SimTime busyUntil = SimTime.ZERO;
  private int owed;
  private long dropped;

  /**
   * Creates a channel without active faults.
   *
   * @param noise the noise of the drone
   */
  public LossyChannel(SeededNoise noise, LinkDirection direction, Receiver<T> receiver) {
    this.noise = noise.of(direction.word());
    this.direction = direction;
    this.receiver = receiver;
  }

  /** Sets the faults for datagrams that are sent from now on. */
  public void set(ActiveFaults faults) {
    boolean none = faults.link() == LinkPreset.IDEAL && faults.faults().isEmpty();
    acting = none ? Map.of() : faults.on(direction);
  }

  /** Whether the channel forwards datagrams at once. */
  public boolean clear() {
    return acting.isEmpty() && waiting.isEmpty();
  }

  /** Drops all datagrams in transit, and restarts the random numbers. */
  public void restart() {
    forget();
    number = 0;
    losing = false;
    busyUntil = SimTime.ZERO;
  }

  /** Drops all datagrams in transit. */
  public void forget() {
    waiting.clear();
    overtaken.clear();
    counts.clear();
    owed = 0;
  }

  /** Whether a client is waiting for a datagram in transit. */
  public boolean hasPending() {
    return owed > 0;
  }

  /**
   * Sends a datagram.
   *
   * @param expected whether a client is waiting for it
   */
  public void send(T datagram, boolean expected, SimTime now) {
    if (clear()) {
      receiver.arrived(datagram);
      return;
    }
    number++;
    Optional<Fault> cause = loss(datagram, now);
    if (cause.isPresent()) {
      receiver.lost(datagram, cause.get());
      return;
    }
    T sent =
        happens(FaultKind.CORRUPT, Channel.LINK_CORRUPT)
            ? receiver.corrupted(datagram, corruption())
            : datagram;
    SimTime due = nearestStep((busyUntil.isBefore(now) ? now : busyUntil).plus(delay()));
    Optional<Fault> late = late();
    if (late.isPresent()) {
      SimTime later = due.plus(late.get().value(FaultParameter.TIME));
      add(overtaken, new Waiting<>(later, number, sent, expected));
    } else {
      SimTime last = waiting.isEmpty() ? due : waiting.getLast().due();
      Waiting<T> next = new Waiting<>(due.isBefore(last) ? last : due, number, sent, expected);
      add(waiting, next);
      if (happens(FaultKind.DUPLICATE, Channel.LINK_DUPLICATE)) {
        add(waiting, next);
      }
    }
    deliver(now);
  }

  /** Returns the fault that causes the datagram to be lost, if any. */
  private Optional<Fault> loss(T datagram, SimTime now) {
    Optional<Fault> loss = acting(FaultKind.LOSS).filter(this::loses);
    losing = loss.isPresent();
    return acting(FaultKind.CUT).or(() -> loss).or(() -> overflow(datagram, now));
  }

  private Optional<Fault> acting(FaultKind kind) {
    return Optional.ofNullable(acting.get(kind));
  }

  /**
   * Returns whether the next datagram is lost. The model has two states, in one of which all
   * datagrams are lost (Gilbert 1960, Elliott 1963). Without bursts, the loss of one datagram does
   * not depend on that of the previous one.
   */
  private boolean loses(Fault loss) {
    double share = loss.value(FaultParameter.SHARE);
    double stay = Math.max(share, 1 - 1 / loss.value(FaultParameter.BURST));
    double enter = share < 1 ? share * (1 - stay) / (1 - share) : 1;
    return draw(Channel.LINK_LOSS) < (losing ? stay : enter);
  }

  /**
   * Returns the bandwidth fault if the full buffer of the slow link causes the loss of the
   * datagram. Otherwise, returns empty, and reserves the link for the transmission time of the
   * datagram.
   */
  private Optional<Fault> overflow(T datagram, SimTime now) {
    Optional<Fault> bandwidth = acting(FaultKind.BANDWIDTH);
    SimTime start = busyUntil.isBefore(now) ? now : busyUntil;
    if (bandwidth.isEmpty() || start.since(now) > BUFFER) {
      return bandwidth;
    }
    double bits = 8.0 * (receiver.length(datagram) + HEADERS);
    busyUntil = start.plus(bits / bandwidth.get().value(FaultParameter.RATE));
    return Optional.empty();
  }

  /**
   * Rounds a time to the nearest step. A step is as long as the shortest delays, so rounding up
   * would lengthen every delay noticeably.
   */
  private static SimTime nearestStep(SimTime time) {
    long half = SimTime.STEP_NANOS / 2;
    return new SimTime((time.nanos() + half) / SimTime.STEP_NANOS * SimTime.STEP_NANOS);
  }

  private double delay() {
    return acting(FaultKind.DELAY).map(this::drawn).orElse(0.0);
  }

  /**
   * Draws a log-normal delay [s]. Its logarithm is normally distributed around the logarithm of the
   * median.
   */
  private double drawn(Fault delay) {
    double median = delay.value(FaultParameter.TIME);
    double spread = delay.value(FaultParameter.SPREAD);
    if (median == 0 || spread == 0) {
      return median;
    }
    double least = delay.value(FaultParameter.LEAST);
    double most = delay.value(FaultParameter.MOST);
    double sigma = StrictMath.log1p(spread / median);
    for (int i = 0; i < TRIES; i++) {
      double gaussian = noise.gaussian(Channel.LINK_DELAY, number * TRIES + i);
      double drawn = median * StrictMath.exp(sigma * gaussian);
      if (drawn >= least && drawn <= most) {
        return drawn;
      }
    }
    return median;
  }

  /** Returns the fault that lets subsequent datagrams overtake this one, if any. */
  private Optional<Fault> late() {
    return acting(FaultKind.LATE_REPLY)
        .or(
            () ->
                acting(FaultKind.REORDER)
                    .filter(reorder -> happens(FaultKind.REORDER, Channel.LINK_REORDER)));
  }

  private boolean happens(FaultKind kind, Channel channel) {
    return acting(kind).filter(f -> draw(channel) < f.value(FaultParameter.SHARE)).isPresent();
  }

  private Corruption corruption() {
    return new Corruption(1 + (long) noise.between(0, 1L << 52, Channel.LINK_BYTES, number));
  }

  private double draw(Channel channel) {
    return noise.between(0, 1, channel, number);
  }

  private void add(Queue<Waiting<T>> queue, Waiting<T> next) {
    Object party = receiver.party(next.datagram());
    if (counts.getOrDefault(party, 0) >= MOST_FOR_PARTY) {
      dropOldest(party);
    } else if (waiting.size() + overtaken.size() >= MOST) {
      leaves(waiting.isEmpty() ? overtaken.remove() : waiting.remove());
      dropped++;
    }
    queue.add(next);
    counts.merge(party, 1, Integer::sum);
    owed += next.owed() ? 1 : 0;
  }

  private void dropOldest(Object party) {
    if (!dropFirst(waiting.iterator(), party)) {
      dropFirst(overtaken.iterator(), party);
    }
    dropped++;
  }

  private boolean dropFirst(Iterator<Waiting<T>> candidates, Object party) {
    while (candidates.hasNext()) {
      Waiting<T> candidate = candidates.next();
      if (receiver.party(candidate.datagram()).equals(party)) {
        candidates.remove();
        leaves(candidate);
        return true;
      }
    }
    return false;
  }

  private void leaves(Waiting<T> gone) {
    owed -= gone.owed() ? 1 : 0;
    counts.computeIfPresent(
        receiver.party(gone.datagram()), (same, count) -> count == 1 ? null : count - 1);
  }

  /**
   * Returns the number of datagrams that have been dropped for lack of capacity since the last
   * call.
   */
  public long takeDropped() {
    long taken = dropped;
    dropped = 0;
    return taken;
  }

  /** Delivers the datagrams that are due. */
  public void deliver(SimTime now) {
    while (due(waiting, now) || due(overtaken, now)) {
      boolean late =
          due(overtaken, now)
              && (waiting.isEmpty() || overtaken.peek().due().isBefore(waiting.peek().due()));
      Waiting<T> next = late ? overtaken.remove() : waiting.remove();
      leaves(next);
      receiver.arrived(next.datagram());
    }
  }

  private boolean due(Queue<Waiting<T>> queue, SimTime now) {
    return !queue.isEmpty() && !now.isBefore(queue.peek().due());
  }
}
