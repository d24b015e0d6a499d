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
 * One way over the link: takes datagrams and hands them on, late, twice, wrong or not at all. While
 * nothing acts on it and nothing waits, it hands them on at once. How many wait is bounded, in all
 * and for each party, because time may stand still: the oldest is dropped. For the simulation
 * thread.
 *
 * @param <T> a datagram
 */
public final class LinkChannel<T> {

  /** Datagrams that may wait for one party. Decided: more than anybody asks within a delay. */
  static final int MOST_FOR_PARTY = 1024;

  /** Datagrams that may wait in all. Decided: some megabytes, whatever is in them. */
  static final int MOST = 4096;

  /** Headers of Ethernet, IP and UDP [bytes]. Documented: RFC 791, RFC 768. */
  private static final int HEADERS = 42;

  /** What a slow link buffers [s]. Decided: the queue of a cheap access point. */
  private static final double BUFFER = 0.5;

  /** How often a delay is drawn that shall be within limits. */
  private static final int TRIES = 16;

  /** Where datagrams go. */
  public interface Receiver<T> {

    /** One has arrived. */
    void arrived(T datagram);

    /** One never will. */
    void lost(T datagram, Fault cause);

    /** The same with wrong bytes. */
    T corrupted(T datagram, Corruption corruption);

    /** How long it is [bytes]. */
    int length(T datagram);

    /** Whose it is, who has a share of the room for those that wait. */
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
   * One on which nothing acts.
   *
   * @param noise of the drone
   */
  public LinkChannel(SeededNoise noise, LinkDirection direction, Receiver<T> receiver) {
    this.noise = noise.of(direction.word());
    this.direction = direction;
    this.receiver = receiver;
  }

  /** Lets other faults act on what comes from now on. */
  public void set(ActiveFaults faults) {
    boolean none = faults.link() == LinkPreset.IDEAL && faults.faults().isEmpty();
    acting = none ? Map.of() : faults.on(direction);
  }

  /** Whether it hands on at once what comes. */
  public boolean clear() {
    return acting.isEmpty() && waiting.isEmpty();
  }

  /** Forgets what waits, and begins with its random numbers anew. */
  public void restart() {
    forget();
    number = 0;
    losing = false;
    busyUntil = SimTime.ZERO;
  }

  /** Forgets what waits. */
  public void forget() {
    waiting.clear();
    overtaken.clear();
    counts.clear();
    owed = 0;
  }

  /** Whether somebody waits for something that is on its way. */
  public boolean owes() {
    return owed > 0;
  }

  /**
   * Takes a datagram.
   *
   * @param expected whether somebody waits for it
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

  /** What it is lost by, if it is. */
  private Optional<Fault> loss(T datagram, SimTime now) {
    Optional<Fault> loss = acting(FaultKind.LOSS).filter(this::loses);
    losing = loss.isPresent();
    return acting(FaultKind.CUT).or(() -> loss).or(() -> overflow(datagram, now));
  }

  private Optional<Fault> acting(FaultKind kind) {
    return Optional.ofNullable(acting.get(kind));
  }

  /**
   * Two states, one of which loses everything, after Gilbert (1960) and Elliott (1963). Without
   * bursts, one datagram says nothing about the next.
   */
  private boolean loses(Fault loss) {
    double share = loss.value(FaultParameter.SHARE);
    double stay = Math.max(share, 1 - 1 / loss.value(FaultParameter.BURST));
    double enter = share < 1 ? share * (1 - stay) / (1 - share) : 1;
    return draw(Channel.LINK_LOSS) < (losing ? stay : enter);
  }

  /** The slow link as the cause, if its buffer is full; else the datagram has its time on it. */
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

  /** Steps are as long as the shortest delays: rounding up would make all of them longer. */
  private static SimTime nearestStep(SimTime time) {
    long half = SimTime.STEP_NANOS / 2;
    return new SimTime((time.nanos() + half) / SimTime.STEP_NANOS * SimTime.STEP_NANOS);
  }

  private double delay() {
    return acting(FaultKind.DELAY).map(this::drawn).orElse(0.0);
  }

  /** Log-normal: the logarithm of the delay is normal around that of the median [s]. */
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

  /** What others overtake it for, if they do. */
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

  /** How many found no room and were dropped since this was asked last. */
  public long takeDropped() {
    long taken = dropped;
    dropped = 0;
    return taken;
  }

  /** Hands on what is due. */
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
