package tellosimulator.command;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The loss protection of the EDU: seven bytes {@code Re}, index, repeat number and a blank before a
 * command. An index is executed once; each copy is answered under its own header. Measured:
 * Multi-Tello-Formation (raw bytes) and RoboMaster SDK (ASCII digits).
 *
 * <p>Remembers the latest index of each peer. For the simulation thread.
 */
final class Retransmission {

  private static final String MARK = "Re";
  private static final int LENGTH = 7;
  private static final int INDEX_END = 4;

  /** Peers whose latest index is remembered. Assumed: more than any class has. */
  private static final int MOST_PEERS = 64;

  private record Known(String index, String text, Responder responder) {}

  private final Map<Peer, Known> latest =
      new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Peer, Known> eldest) {
          return size() > MOST_PEERS;
        }
      };

  /** The header that {@code text} begins with, or nothing. */
  static String header(String text) {
    boolean present =
        text.length() >= LENGTH && text.startsWith(MARK) && text.charAt(LENGTH - 1) == ' ';
    return present ? text.substring(0, LENGTH) : "";
  }

  /** The command of which this is a copy, if it is one. */
  Optional<Responder> original(Peer peer, String header, String text) {
    return Optional.ofNullable(latest.get(peer))
        .filter(known -> known.index().equals(index(header)) && known.text().equals(text))
        .map(Known::responder);
  }

  void remember(String header, String text, Responder responder) {
    latest.put(responder.peer(), new Known(index(header), text, responder));
  }

  void forgetAll() {
    latest.clear();
  }

  private static String index(String header) {
    return header.substring(MARK.length(), INDEX_END);
  }
}
