package tellosimulator.command;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The retransmission scheme of the Tello EDU. Seven bytes precede a command: {@code Re}, an index,
 * a repeat number and a space. A command is carried out only once per index, and each copy is
 * answered under its own header. Measured: Multi-Tello-Formation (raw bytes) and RoboMaster SDK
 * (ASCII digits).
 *
 * <p>Remembers the last 64 indices of each peer, so that a late copy is not carried out again. A
 * known index with another text is a new command, because indices wrap around. A restarted program
 * begins with the same indices and often the same texts. A {@code command} reveals the restart if
 * it has no header, as the vendor's programs send it to discover drones, or if its exact header is
 * repeated after other indices. (Copies differ in their repeat numbers.) Confined to the simulation
 * thread.
 */
final class Retransmission {

  private static final String MARK = "Re";
  private static final int LENGTH = 7;
  private static final int INDEX_END = 4;

  /** Maximum number of remembered peers. Assumed: no school class has more clients. */
  private static final int MOST_PEERS = 64;

  /**
   * Maximum number of remembered indices per peer. Decided: fewer than the 100 indices of the
   * RoboMaster SDK, so that an index is forgotten before it is reused.
   */
  private static final int MOST_INDICES = 64;

  /** A command that was carried out, with the header of its first copy. */
  private record Known(String header, String text, Responder responder) {}

  /**
   * The remembered commands of each peer, by index, oldest first. The peers are ordered by the time
   * of their last command, the earliest first.
   */
  private final Map<Peer, Map<String, Known>> recent = bounded(MOST_PEERS, true);

  /** Returns the header of {@code text}; an empty text if there is none. */
  static String header(String text) {
    boolean present =
        text.length() >= LENGTH && text.startsWith(MARK) && text.charAt(LENGTH - 1) == ' ';
    return present ? text.substring(0, LENGTH) : "";
  }

  /**
   * Returns the length of a datagram's header [bytes]; 0 if there is none.
   *
   * @param bytes an array that begins with the datagram
   * @param length the length of the datagram [bytes]
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
   * Returns the responder of the original command if this command is a copy.
   *
   * @param header the header; empty for a text without a header
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
    indices.remove(index(header)); // otherwise the index would keep its old position
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
