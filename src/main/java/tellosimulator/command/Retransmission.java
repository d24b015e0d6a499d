package tellosimulator.command;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The loss protection of the EDU: seven bytes {@code Re}, index, repeat number and a blank before a
 * command. An index is executed once; each copy is answered under its own header. Measured:
 * Multi-Tello-Formation (raw bytes) and RoboMaster SDK (ASCII digits).
 *
 * <p>Remembers the last 64 indices of each peer, so that a copy that arrives late is not flown
 * again. An index under which another text comes is a new command, because indices wrap around. A
 * program that starts anew begins with the same indices and often with the same texts; a {@code
 * command} tells that it has: one without a header, with which the vendor's programs look for
 * drones, or one whose own header comes again although other indices came since. Copies differ in
 * their repeat numbers. For the simulation thread.
 */
final class Retransmission {

  private static final String MARK = "Re";
  private static final int LENGTH = 7;
  private static final int INDEX_END = 4;

  /** Peers whose indices are remembered. Assumed: more than any class has. */
  private static final int MOST_PEERS = 64;

  /** Indices that are remembered of a peer. Decided: fewer than the 100 of the RoboMaster SDK. */
  private static final int MOST_INDICES = 64;

  /** A command that was carried out, with the header of the copy that came first. */
  private record Known(String header, String text, Responder responder) {}

  /** From the peer that was heard longest ago to the latest; indices from oldest to newest. */
  private final Map<Peer, Map<String, Known>> recent = bounded(MOST_PEERS, true);

  /** The header that {@code text} begins with, or nothing. */
  static String header(String text) {
    boolean present =
        text.length() >= LENGTH && text.startsWith(MARK) && text.charAt(LENGTH - 1) == ' ';
    return present ? text.substring(0, LENGTH) : "";
  }

  /**
   * How long the header is that a datagram begins with, or 0 [bytes].
   *
   * @param bytes begin with the datagram
   * @param length of the datagram [bytes]
   */
  static int headerLength(byte[] bytes, int length) {
    boolean present =
        length >= LENGTH
            && bytes[0] == MARK.charAt(0)
            && bytes[1] == MARK.charAt(1)
            && bytes[LENGTH - 1] == ' ';
    return present ? LENGTH : 0;
  }

  /**
   * The command of which this is a copy, if it is one.
   *
   * @param header empty for a text that came without
   */
  Optional<Responder> original(Peer peer, String header, String text) {
    Map<String, Known> indices = recent.getOrDefault(peer, Map.of());
    Optional<Known> known =
        Optional.ofNullable(indices.get(index(header))).filter(one -> one.text().equals(text));
    if (text.equals(CommandSyntax.COMMAND.verb()) && startsAnew(header, known, indices)) {
      recent.remove(peer);
      return Optional.empty();
    }
    return known.map(Known::responder);
  }

  private static boolean startsAnew(
      String header, Optional<Known> known, Map<String, Known> indices) {
    return header.isEmpty()
        || (known.filter(one -> one.header().equals(header)).isPresent()
            && !known.equals(newest(indices)));
  }

  private static Optional<Known> newest(Map<String, Known> indices) {
    return indices.values().stream().reduce((earlier, later) -> later);
  }

  void remember(String header, String text, Responder responder) {
    Map<String, Known> indices =
        recent.computeIfAbsent(responder.peer(), peer -> bounded(MOST_INDICES, false));
    indices.remove(index(header)); // or it would keep its place among the older ones
    indices.put(index(header), new Known(header, text, responder));
  }

  void forgetAll() {
    recent.clear();
  }

  private static String index(String header) {
    return header.isEmpty() ? "" : header.substring(MARK.length(), INDEX_END);
  }

  private static <K, V> Map<K, V> bounded(int most, boolean byUse) {
    return new LinkedHashMap<>(16, 0.75f, byUse) {
      @Override
      protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
        return size() > most;
      }
    };
  }
}
