package tellosimulator.protocol.app;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import tellosimulator.command.DroneProtocol;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.OperatorSession;
import tellosimulator.command.Peer;
import tellosimulator.command.ProtocolContext;
import tellosimulator.controller.DroneController;
import tellosimulator.controller.FlightEvent.Note;
import tellosimulator.controller.VideoOption;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.LinkDirection;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The binary protocol of the drone's app, which TelloPy, gobot and other libraries speak. A program
 * connects with {@code conn_req:} and the port for its video; from then on the drone sends
 * telemetry, and takes packets from its host. A packet with a wrong checksum has no effect, as on
 * the drone. {@code command} ends the connection.
 */
public final class AppProtocol implements DroneProtocol {

  /** A request to connect. Two bytes with the port for the video follow. Measured: all clients. */
  private static final byte[] REQUEST = "conn_req:".getBytes(StandardCharsets.US_ASCII);

  private static final byte[] ACKNOWLEDGEMENT = "conn_ack:".getBytes(StandardCharsets.US_ASCII);

  /** Time from the connection to the question for the time [s]. Decided. */
  private static final double ASKS_TIME = 1;

  /** Minimum time between key pictures that are asked for [s]. Decided: four a second. */
  private static final double KEY_PERIOD = 0.25;

  /** Bit rates [Mbit/s] by the number in a packet; 0 is automatic. 1.5 counts as 2. */
  private static final int[] BIT_RATES = {0, 1, 2, 2, 3, 4};

  /** Version of the firmware. Measured: the version that most logs of clients show. */
  private static final String VERSION = "01.04.92.01";

  /** Length of the answer to a question for the version [bytes]. Measured: nodetello. */
  private static final int VERSION_LENGTH = 31;

  private final ProtocolContext drone;
  private final DroneController controller;
  private final OperatorSession session;
  private final AppLimits limits = new AppLimits();
  private final FlightOrders orders;

  /** What the drone does with each message, and the payload of its answer; empty if it has none. */
  private final Map<MessageId, Function<Packet, Optional<byte[]>>> table =
      new EnumMap<>(MessageId.class);

  private Optional<Link> link = Optional.empty();
  private long damaged;

  /** What exists while a program is connected. */
  private static final class Link {
    private final Telemetry telemetry;
    private final FlightLog log;
    private final SimTime since;
    private int sequence;
    private boolean timeAsked;

    /** Whether a packet has come since the last notification. */
    private boolean owed;

    private SimTime keyPicture;

    Link(ProtocolContext drone) {
      telemetry = new Telemetry(drone);
      log = new FlightLog(drone);
      since = drone.controller().now();
      keyPicture = since;
    }
  }

  public AppProtocol(ProtocolContext drone) {
    this.drone = drone;
    controller = drone.controller();
    session = drone.session();
    orders = new FlightOrders(drone, limits);
    order(MessageId.TAKEOFF, packet -> orders.takeoff("takeoff"));
    order(MessageId.THROW_AND_GO, packet -> orders.takeoff("throw and go"));
    order(
        MessageId.LAND,
        packet -> packet.unsigned(0) == 1 ? orders.stopLanding() : orders.land("land"));
    order(MessageId.PALM_LANDING, packet -> orders.land("palm landing"));
    order(MessageId.FLIP, packet -> orders.flip(packet.unsigned(0)));
    order(MessageId.SMART_VIDEO, packet -> orders.smartVideo(packet.unsigned(0)));
    order(MessageId.BOUNCE, packet -> orders.bounce(packet.unsigned(0)));
    order(MessageId.SET_HEIGHT_LIMIT, packet -> done(limits.setHeight(packet.unsigned(0))));
    order(
        MessageId.SET_ATTITUDE_LIMIT,
        packet -> done(packet.number(0).filter(limits::setAttitude).isPresent()));
    order(MessageId.BATTERY_THRESHOLD, packet -> done(limits.setLowBattery(packet.unsigned(0))));
    order(MessageId.BIT_RATE, packet -> done(setBitRate(packet.unsigned(0))));
    order(MessageId.EXPOSURE, packet -> FlightOrders.DONE); // the camera has only one
    silent(
        MessageId.STICKS, packet -> StickPacket.parse(packet.payload()).ifPresent(orders::steer));
    silent(MessageId.KEY_PICTURE, packet -> keyPicture());
    silent(MessageId.LOG_HEADER, packet -> link.ifPresent(connected -> connected.log.answered()));
    silent(MessageId.TIME, packet -> {}); // the drone needs none
    table.put(
        MessageId.ASK_BIT_RATE, packet -> values((byte) drone.state().get().video().megabits()));
    table.put(MessageId.HEIGHT_LIMIT, packet -> values((byte) limits.height(), (byte) 0));
    table.put(
        MessageId.ASK_BATTERY_THRESHOLD, packet -> values((byte) limits.lowBattery(), (byte) 0));
    table.put(MessageId.ASK_ATTITUDE_LIMIT, packet -> attitudeLimit());
    table.put(MessageId.SSID, packet -> ssid());
    table.put(MessageId.VERSION, packet -> version());
  }

  private void order(MessageId id, ToIntFunction<Packet> order) {
    table.put(id, packet -> Optional.of(new byte[] {(byte) order.applyAsInt(packet)}));
  }

  private void silent(MessageId id, Consumer<Packet> action) {
    table.put(
        id,
        packet -> {
          action.accept(packet);
          return Optional.empty();
        });
  }

  private static byte done(boolean done) {
    return done ? FlightOrders.DONE : FlightOrders.REFUSED;
  }

  /** Returns an answer: success and values. */
  private static Optional<byte[]> values(byte... values) {
    return Optional.of(ByteBuffer.allocate(1 + values.length).put(1, values).array());
  }

  // --- input ---

  @Override
  public boolean claims(byte[] datagram) {
    return (datagram.length > 0 && datagram[0] == Packet.MARK) || isRequest(datagram);
  }

  private static boolean isRequest(byte[] datagram) {
    int difference = Arrays.mismatch(datagram, REQUEST);
    return difference < 0 || difference >= REQUEST.length;
  }

  @Override
  public void receive(Peer peer, byte[] datagram) {
    if (isRequest(datagram)) {
      connect(peer, datagram);
      return;
    }
    Optional<Packet> packet = Packet.parse(datagram);
    if (packet.isEmpty()) {
      damaged++;
      return;
    }
    MessageId.of(packet.get().id())
        .filter(id -> table.containsKey(id) && answers(id))
        .ifPresent(id -> take(peer, packet.get(), id));
  }

  /** Whether the drone reacts to a message now. Texts do not exclude the question for its name. */
  private boolean answers(MessageId id) {
    return session.link().app() || (session.link().sdkMode() && id == MessageId.SSID);
  }

  private void take(Peer peer, Packet packet, MessageId id) {
    if (!session.admits(peer)) {
      if (id != MessageId.STICKS) { // fifty of them a second would fill the log
        drone.observer().turnedAway(peer, id.words() + FlightOrders.SUFFIX, session.refusal(peer));
      }
      return;
    }
    controller.linkAlive();
    link.ifPresent(connected -> connected.owed = true);
    table
        .get(id)
        .apply(packet)
        .map(packet::answer)
        .ifPresent(answer -> drone.port().send(LinkDatagram.reply(peer, answer.bytes())));
  }

  private void connect(Peer peer, byte[] request) {
    if (request.length != REQUEST.length + 2) {
      return;
    }
    boolean again = session.link().app() && session.admits(peer);
    int port =
        Short.toUnsignedInt(
            ByteBuffer.wrap(request).order(ByteOrder.LITTLE_ENDIAN).getShort(REQUEST.length));
    boolean standing = !controller.airborne();
    if (!session.openForApp(peer, controller.now(), standing, port, new AppPacketizer())) {
      drone.observer().ignored(peer, "conn_req" + FlightOrders.SUFFIX, refusal(peer));
      return;
    }
    if (!again) {
      note(
          Phrase.of(
              "is operated by %s now with the protocol of its app, and films for port %d there",
              peer.host(), port));
    }
    link = Optional.of(new Link(drone));
    controller.linkAlive();
    controller.stream(true);
    byte[] answer = Arrays.copyOf(ACKNOWLEDGEMENT, request.length);
    System.arraycopy(request, REQUEST.length, answer, REQUEST.length, 2);
    if (drone.faults().get().find(FaultKind.CONN_ACK_LOST).isEmpty()) {
      drone.port().send(LinkDatagram.reply(peer, answer));
    }
  }

  private Phrase refusal(Peer peer) {
    return session.admits(peer)
        ? Phrase.of("after `command`, the drone speaks the text protocol until it loses power")
        : session.refusal(peer);
  }

  // --- settings and questions ---

  private void keyPicture() {
    Link connected = link.orElseThrow();
    if (controller.now().since(connected.keyPicture) >= KEY_PERIOD) {
      connected.keyPicture = controller.now();
      controller.sendKeyPicture();
    }
  }

  private boolean setBitRate(int number) {
    boolean valid = number >= 0 && number < BIT_RATES.length;
    if (valid) {
      controller.setVideo(VideoOption.BIT_RATE, BIT_RATES[number]);
    }
    return valid;
  }

  private Optional<byte[]> attitudeLimit() {
    ByteBuffer answer = ByteBuffer.allocate(1 + Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
    return Optional.of(answer.putFloat(1, limits.attitude()).array());
  }

  /** Returns the name of the drone's network, with the length in front of it. */
  private Optional<byte[]> ssid() {
    byte[] name =
        String.format(Locale.ROOT, "TELLO-%06d", drone.state().get().drone())
            .getBytes(StandardCharsets.US_ASCII);
    ByteBuffer answer = ByteBuffer.allocate(2 + name.length);
    return Optional.of(answer.put((byte) 0).put((byte) name.length).put(name).array());
  }

  private static Optional<byte[]> version() {
    byte[] text = VERSION.getBytes(StandardCharsets.US_ASCII);
    return Optional.of(ByteBuffer.allocate(VERSION_LENGTH).put(1, text).array());
  }

  // --- output ---

  @Override
  public void output() {
    if (link.isPresent() && !session.link().app()) {
      end();
    }
    link.ifPresent(this::output);
  }

  private void output(Link connected) {
    orders.watchOver();
    if (!connected.timeAsked && controller.now().since(connected.since) >= ASKS_TIME) {
      connected.timeAsked = true;
      notify(connected, MessageId.TIME, new byte[0]);
    }
    connected
        .telemetry
        .due(limits.lowBattery())
        .forEach(each -> notify(connected, each.id(), each.payload()));
    connected.log.header().ifPresent(head -> notify(connected, MessageId.LOG_HEADER, head));
    connected.log.records().ifPresent(data -> notify(connected, MessageId.LOG_DATA, data));
  }

  private void notify(Link connected, MessageId id, byte[] payload) {
    Packet packet =
        new Packet(Packet.NOTIFICATION, id.number(), connected.sequence & 0xffff, payload);
    connected.sequence++;
    Peer peer = session.link().operator().orElseThrow();
    boolean expected = connected.owed;
    connected.owed = false;
    drone.port().send(new LinkDatagram(LinkDirection.STATE, peer, packet.bytes(), expected));
  }

  @Override
  public boolean hasPending() {
    return link.isPresent() && link.get().owed;
  }

  @Override
  public void reset() {
    orders.reset();
  }

  @Override
  public void powerOff() {
    end();
    limits.reset();
  }

  private void end() {
    link = Optional.empty();
    orders.reset();
    if (damaged > 0) {
      note(Phrase.of("dropped %d damaged packets of its app's protocol", damaged));
      damaged = 0;
    }
  }

  private void note(Phrase phrase) {
    drone.observer().happened(new Note(phrase));
  }
}
