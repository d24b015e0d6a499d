package tellosimulator.sim;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import tellosimulator.command.WireText;
import tellosimulator.sim.SimEvent.FromPeer;
import tellosimulator.time.TokenBucket;

/**
 * Stands before a log and keeps floods out of it: of what hosts send in vain, and of replies that
 * are dropped, it passes on some events a second, and tells the others in sums. Called on the
 * simulation thread, in wall-clock time.
 */
public final class LogLimiter implements SimListener {

  /** Hosts that have an account of their own. Assumed: more than any class has. */
  private static final int MOST_HOSTS = 256;

  /** Silence after which a host gives its account to another one [ns]. Decided. */
  private static final long FORGOTTEN_AFTER_NANOS = 60_000_000_000L;

  /** What is limited, and to how much. Decided. */
  private enum Kind {
    /** Texts that are no commands. */
    UNKNOWN(5, 40),
    /** Those of somebody who does not operate the drone. */
    TURNED_AWAY(1, 1),
    /** Replies that found no room. */
    DROPPED(1, 1);

    private final double perSecond;
    private final double burst;

    Kind(double perSecond, double burst) {
      this.perSecond = perSecond;
      this.burst = burst;
    }
  }

  /**
   * Whose events are counted together.
   *
   * @param host empty for all hosts that have no account of their own
   */
  private record Key(int drone, Optional<String> host, Kind kind) {}

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

  /** The one that was used longest ago comes first. */
  private final Map<Key, Account> accounts = new LinkedHashMap<>(16, 0.75f, true);

  /** Those that are not for one host. */
  private final Map<Key, Account> shared = new LinkedHashMap<>();

  /**
   * @param log is told what passes
   */
  public LogLimiter(SimListener log) {
    this(log, TokenBucket.WALL_CLOCK);
  }

  /**
   * @param nanos a clock that never goes back [ns]
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

  /** Whether there was an account that nobody has used for long. */
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
