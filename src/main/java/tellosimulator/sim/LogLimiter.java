package tellosimulator.sim;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import tellosimulator.command.WireText;
import tellosimulator.sim.SimEvent.FromPeer;
import tellosimulator.time.TokenBucket;

/**
 * Protects a log from floods of events about ineffective or dropped datagrams. The limiter forwards
 * a few of these events per second of wall clock time, and counts the others. Called on the
 * simulation thread.
 */
public final class LogLimiter implements SimListener {

  /** Maximum number of accounts of individual hosts. Assumed: more than a school class needs. */
  private static final int MOST_HOSTS = 256;

  /** Time without events after which a host's account can be reused [ns]. Decided. */
  private static final long FORGOTTEN_AFTER_NANOS = 60_000_000_000L;

  /** The limited kinds of events, each with its rate [events/s] and burst [events]. Decided. */
  private enum Kind {
    /** Texts that are not commands. */
    UNKNOWN(5, 40),
    /** Datagrams from hosts that do not operate the drone. */
    TURNED_AWAY(1, 1),
    /** Datagrams that exceeded a capacity. */
    DROPPED(1, 1);

    private final double perSecond;
    private final double burst;

    Kind(double perSecond, double burst) {
      this.perSecond = perSecond;
      this.burst = burst;
    }
  }

  /**
   * The key of an account.
   *
   * @param host the host; empty for the account that all other hosts share
   */
  private record Key(int drone, Optional<String> host, Kind kind) {}

  /** The token bucket of a key, and the number of omitted events that are not yet reported. */
  private final class Account {
    private final TokenBucket bucket;
    private long omitted;
    private long usedNanos;

    Account(Kind kind) {
      bucket = new TokenBucket(kind.perSecond, kind.burst, nanos);
    }

    boolean tryTake() {
      usedNanos = nanos.getAsLong();
      return bucket.tryTake();
    }

    long takeOmitted() {
      long taken = omitted;
      omitted = 0;
      return taken;
    }
  }

  private final SimListener log;
  private final LongSupplier nanos;

  /** Accounts of individual hosts, least recently used first. */
  private final Map<Key, Account> accounts = new LinkedHashMap<>(16, 0.75f, true);

  /** Accounts shared by all hosts without an account of their own. */
  private final Map<Key, Account> shared = new LinkedHashMap<>();

  /**
   * Creates a limiter that uses the wall clock.
   *
   * @param log receives the forwarded events
   */
  public LogLimiter(SimListener log) {
    this(log, TokenBucket.WALL_CLOCK);
  }

  /**
   * Creates a limiter with another clock.
   *
   * @param nanos a monotonic clock [ns]
   */
  LogLimiter(SimListener log, LongSupplier nanos) {
    this.log = log;
    this.nanos = nanos;
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.WaitingDropped dropped) {
      Account account = shared(new Key(dropped.drone(), Optional.empty(), Kind.DROPPED));
      account.omitted += dropped.count();
      if (account.tryTake()) {
        long count = account.takeOmitted();
        log.event(new SimEvent.WaitingDropped(dropped.time(), dropped.drone(), count));
      }
    } else if (event instanceof FromPeer sent && inVain(sent)) {
      Account account = account(sent);
      if (account.tryTake()) {
        log.event(event);
      } else {
        account.omitted++;
      }
    } else {
      log.event(event);
    }
  }

  private Account account(FromPeer sent) {
    Kind kind = sent instanceof SimEvent.TurnedAway ? Kind.TURNED_AWAY : Kind.UNKNOWN;
    Key key = new Key(sent.drone(), Optional.of(sent.peer().host()), kind);
    Account known = accounts.get(key);
    if (known != null) {
      return known;
    }
    if (accounts.size() >= MOST_HOSTS && !forgetOne()) {
      return shared(new Key(sent.drone(), Optional.empty(), kind));
    }
    return accounts.computeIfAbsent(key, unseen -> new Account(kind));
  }

  /** Removes the least recently used account if it has expired; returns whether it was removed. */
  private boolean forgetOne() {
    Map.Entry<Key, Account> oldest = accounts.entrySet().iterator().next();
    Account account = oldest.getValue();
    boolean forgotten =
        account.omitted == 0 && nanos.getAsLong() - account.usedNanos >= FORGOTTEN_AFTER_NANOS;
    if (forgotten) {
      accounts.remove(oldest.getKey());
    }
    return forgotten;
  }

  private Account shared(Key key) {
    return shared.computeIfAbsent(key, unseen -> new Account(key.kind()));
  }

  private static boolean inVain(FromPeer sent) {
    if (sent.text().endsWith(WireText.APP_SUFFIX)) {
      return sent instanceof SimEvent.TurnedAway || sent instanceof SimEvent.CommandIgnored;
    }
    boolean answered =
        sent instanceof SimEvent.CommandReceived || sent instanceof SimEvent.CommandRefused;
    return sent instanceof SimEvent.TurnedAway
        || sent instanceof SimEvent.CommandIgnored
        || (answered && !WireText.beginsLikeCommand(sent.text()));
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    accounts.forEach((key, account) -> tellOmitted(snapshot, key, account));
    shared.forEach((key, account) -> tellOmitted(snapshot, key, account));
    log.stepped(snapshot);
  }

  private void tellOmitted(SimSnapshot snapshot, Key key, Account account) {
    if (account.omitted == 0 || !account.tryTake()) {
      return;
    }
    long count = account.takeOmitted();
    log.event(
        key.kind() == Kind.DROPPED
            ? new SimEvent.WaitingDropped(snapshot.time(), key.drone(), count)
            : new SimEvent.Omitted(snapshot.time(), key.drone(), key.host(), count));
  }
}
