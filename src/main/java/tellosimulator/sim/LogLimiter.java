package tellosimulator.sim;

import java.util.LinkedHashMap;
import java.util.Map;
import tellosimulator.command.WireText;
import tellosimulator.sim.SimEvent.FromPeer;
import tellosimulator.time.TokenBucket;

/**
 * Stands before a log and keeps floods out of it: of what hosts send in vain, it passes on some
 * events a second, and tells the others in sums. Called on the simulation thread, in wall-clock
 * time.
 */
public final class LogLimiter implements SimListener {

  /** Events about texts that are no commands, for each host [1/s]. Decided. */
  private static final double UNKNOWN_RATE = 5;

  private static final double UNKNOWN_BURST = 40;

  /** Events about one who is turned away, for each host [1/s]. Decided. */
  private static final double TURNED_AWAY_RATE = 1;

  /** Hosts that are remembered. Assumed: more than any class has. */
  private static final int MOST_HOSTS = 256;

  private final SimListener log;
  private final Map<Sender, Account> accounts =
      new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Sender, Account> eldest) {
          return size() > MOST_HOSTS;
        }
      };

  private record Sender(int drone, String host, boolean turnedAway) {}

  private static final class Account {
    private final TokenBucket bucket;
    private long omitted;

    Account(boolean turnedAway) {
      bucket =
          turnedAway
              ? new TokenBucket(TURNED_AWAY_RATE, 1)
              : new TokenBucket(UNKNOWN_RATE, UNKNOWN_BURST);
    }
  }

  /**
   * @param log is told what passes
   */
  public LogLimiter(SimListener log) {
    this.log = log;
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof FromPeer sent && inVain(sent)) {
      Sender sender =
          new Sender(sent.drone(), sent.peer().host(), sent instanceof SimEvent.TurnedAway);
      Account account =
          accounts.computeIfAbsent(sender, unseen -> new Account(sender.turnedAway()));
      if (!account.bucket.tryTake()) {
        account.omitted++;
        return;
      }
    }
    log.event(event);
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
    accounts.forEach(
        (sender, account) -> {
          if (account.omitted > 0 && account.bucket.tryTake()) {
            log.event(
                new SimEvent.Omitted(
                    snapshot.time(), sender.drone(), sender.host(), account.omitted));
            account.omitted = 0;
          }
        });
    log.stepped(snapshot);
  }
}
