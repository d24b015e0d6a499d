package tellosimulator.protocol.app;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import tellosimulator.command.Reply;
import tellosimulator.command.WireText;
import tellosimulator.controller.Direction;
import tellosimulator.controller.Sticks;

/**
 * A datagram of the app's protocol in words, as logs and recordings show it. Immutable.
 *
 * @param words the message and its values, such as {@code takeoff (app)} or {@code rc 0 50 0 0
 *     (app)}
 * @param command whether it moves the sticks, or has an answer of the drone
 * @param exchange a number that an answer has in common with its question
 * @param reply the reply that corresponds to an answer of the drone, such as {@code ok} or a value;
 *     empty for all other datagrams
 */
public record NamedPacket(String words, boolean command, int exchange, Optional<String> reply) {

  /** The words for a request to connect. */
  static final String CONNECTION = named("conn_req");

  /** The reply to {@link #CONNECTION}. */
  static final Reply CONNECTED = new Reply("conn_ack");

  static final String REQUEST = "conn_req:";
  static final String ACKNOWLEDGEMENT = "conn_ack:";

  /** Number of an exchange that packets, whose ids have 16 bits, do not have. */
  private static final int CONNECTING = -1;

  private static final int FROM_DRONE = 0x80;

  /** Kind of a packet of the app that answers one of the drone. */
  private static final int ANSWER = 0x50;

  /** Messages of the app to which the drone never replies. */
  private static final Set<MessageId> UNANSWERED =
      EnumSet.of(
          MessageId.KEY_PICTURE,
          MessageId.TIME,
          MessageId.FILE_SIZE,
          MessageId.FILE_DATA,
          MessageId.FILE_DONE,
          MessageId.LOG_HEADER);

  private static final int ID_SHIFT = 16;

  /** Describes a datagram; empty if it does not belong to the app's protocol. */
  public static Optional<NamedPacket> of(byte[] datagram) {
    if (datagram.length > 0 && datagram[0] == Packet.MARK) {
      return Optional.of(
          Packet.parse(datagram)
              .map(NamedPacket::of)
              .orElseGet(
                  () -> new NamedPacket(named("damaged packet"), false, 0, Optional.empty())));
    }
    String text = WireText.decode(datagram);
    if (text.startsWith(REQUEST)) {
      return Optional.of(new NamedPacket(CONNECTION, true, CONNECTING, Optional.empty()));
    }
    return text.startsWith(ACKNOWLEDGEMENT)
        ? Optional.of(
            new NamedPacket(named("conn_ack"), false, CONNECTING, Optional.of(CONNECTED.text())))
        : Optional.empty();
  }

  /** Returns the words of a datagram of the app's protocol, or the text of any other one. */
  public static String text(byte[] datagram) {
    return of(datagram).map(NamedPacket::words).orElseGet(() -> WireText.decode(datagram));
  }

  private static NamedPacket of(Packet packet) {
    boolean answers = (packet.kind() & FROM_DRONE) != 0 && packet.kind() != Packet.NOTIFICATION;
    return new NamedPacket(
        words(packet),
        isCommand(packet),
        packet.id() << ID_SHIFT | packet.sequence(),
        answers ? Optional.of(reply(packet).text()) : Optional.empty());
  }

  static boolean isCommand(Packet packet) {
    boolean sent = (packet.kind() & FROM_DRONE) == 0 && packet.kind() != ANSWER;
    return sent && !UNANSWERED.contains(MessageId.of(packet.id()).orElse(MessageId.TIME));
  }

  /** Returns words with the addition that distinguishes them from a text command. */
  static String named(String words) {
    return words + WireText.APP_SUFFIX;
  }

  /** Returns a packet in words. */
  static String words(Packet packet) {
    return named(
        MessageId.of(packet.id())
            .map(id -> (packet.kind() & FROM_DRONE) == 0 ? words(id, packet) : id.words())
            .orElseGet(() -> String.format(Locale.ROOT, "packet %04x", packet.id())));
  }

  private static String words(MessageId id, Packet packet) {
    int value = packet.unsigned(0);
    return switch (id) {
      case STICKS -> StickPacket.parse(packet.payload()).map(NamedPacket::rc).orElse(id.words());
      case FLIP -> FlightOrders.direction(value).map(NamedPacket::flip).orElse("flip " + value);
      case LAND -> value == 1 ? "stop landing" : id.words();
      case BIT_RATE,
          DYNAMIC_BIT_RATE,
          STABILIZATION,
          PICTURE_MODE,
          RECORD,
          EXPOSURE,
          PHOTO_QUALITY,
          SET_HEIGHT_LIMIT,
          SMART_VIDEO,
          BOUNCE,
          BATTERY_THRESHOLD ->
          id.words() + " " + value;
      case SET_ATTITUDE_LIMIT ->
          packet.number(0).map(degrees -> id.words() + " " + degrees).orElse(id.words());
      default -> id.words();
    };
  }

  /** Returns sticks as the text protocol has them. */
  static String rc(Sticks sticks) {
    return String.format(
        Locale.ROOT,
        "rc %d %d %d %d",
        Math.round(sticks.right()),
        Math.round(sticks.forward()),
        Math.round(sticks.up()),
        Math.round(sticks.clockwise()));
  }

  /** Returns a flip as the text protocol has it. */
  static String flip(Direction direction) {
    return "flip " + direction.name().substring(0, 1).toLowerCase(Locale.ROOT);
  }

  /** Returns the reply that corresponds to an answer: {@code ok}, {@code error} or a value. */
  static Reply reply(Packet answer) {
    byte[] payload = answer.payload();
    if (answer.unsigned(0) > 0) {
      return Reply.ERROR;
    }
    Optional<MessageId> id = MessageId.of(answer.id());
    if (payload.length <= 1 || id.isEmpty()) {
      return Reply.OK;
    }
    return switch (id.get()) {
      case SSID, PASSWORD -> Reply.line(text(payload, 2));
      case VERSION, LOADER_VERSION -> Reply.line(text(payload, 1));
      case ASK_ATTITUDE_LIMIT -> Reply.line(answer.number(1).map(String::valueOf).orElse(""));
      default -> Reply.line(Integer.toString(answer.unsigned(1)));
    };
  }

  private static String text(byte[] payload, int from) {
    byte[] text = Arrays.copyOfRange(payload, Math.min(from, payload.length), payload.length);
    return new String(text, StandardCharsets.US_ASCII).replace("\0", "");
  }
}
