package tellosimulator.protocol.app;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToIntFunction;
import tellosimulator.command.DroneProtocol;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.OperatorSession;
import tellosimulator.command.Peer;
import tellosimulator.command.ProtocolContext;
import tellosimulator.command.WireText;
import tellosimulator.controller.DroneController;
import tellosimulator.controller.FlightEvent.Note;
import tellosimulator.controller.RefusalKind;
import tellosimulator.controller.Result;
import tellosimulator.fault.FaultKind;
import tellosimulator.model.VideoOption;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The binary protocol of the drone's app, which TelloPy, gobot and other libraries speak. A program
 * connects with {@code conn_req:} and the port for its video; from then on the drone sends
 * telemetry, and takes packets from its host. A packet with a wrong checksum has no effect, as on
 * the drone. {@code command} ends the connection.
 */
public final class AppProtocol implements DroneProtocol {

  /** Bit rates [Mbit/s] by the number in a packet; 0 is automatic. 1.5 counts as 2. */
  private static final int[] BIT_RATES = {0, 1, 2, 2, 3, 4};

  /** Version of the firmware. Measured: the version that most logs of clients show. */
  private static final String VERSION = "01.04.92.01";

  /** Length of the answer to a question for the version [bytes]. Measured: nodetello. */
  private static final int VERSION_LENGTH = 31;

  /** Orders that are accepted, although the simulator has nothing that they could change. */
  private static final Set<MessageId> WITHOUT_EFFECT =
      EnumSet.of(
          MessageId.SET_SSID,
          MessageId.SET_PASSWORD,
          MessageId.SET_REGION,
          MessageId.DYNAMIC_BIT_RATE,
          MessageId.STABILIZATION,
          MessageId.RECORD,
          MessageId.EXPOSURE,
          MessageId.CALIBRATE);

  /** The six sides of the drone, all of which are calibrated. Measured: TelloPy 0.7.0. */
  private static final byte SIDES = 0x3f;

  /** Quality of a JPEG file, low and high. Decided; the real drone's files have some 640 kB. */
  private static final float[] QUALITIES = {0.6f, 0.92f};

  private final ProtocolContext drone;
  private final DroneController controller;
  private final OperatorSession session;
  private final AppLimits limits = new AppLimits();
  private final FlightOrders orders;

  /** What the drone does with each message, and the payload of its answer; empty if it has none. */
  private final Map<MessageId, Function<Packet, Optional<byte[]>>> table =
      new EnumMap<>(MessageId.class);

  private Optional<AppLink> link = Optional.empty();
  private float photoQuality = QUALITIES[1];

  /** Index in {@link #BIT_RATES}. */
  private int bitRate;

  private long damaged;

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
    order(MessageId.PICTURE_MODE, packet -> done(setWide(packet.unsigned(0))));
    order(MessageId.PHOTO_QUALITY, packet -> done(setPhotoQuality(packet.unsigned(0))));
    order(MessageId.PHOTO, packet -> orders.photo(this::takePhoto));
    WITHOUT_EFFECT.forEach(id -> order(id, packet -> FlightOrders.DONE));
    silent(
        MessageId.STICKS, packet -> StickPacket.parse(packet.payload()).ifPresent(orders::steer));
    silent(MessageId.KEY_PICTURE, packet -> connected().sendKeyPicture());
    silent(MessageId.LOG_HEADER, packet -> connected().log().answered(packet.payload()));
    silent(MessageId.TIME, packet -> {}); // the drone needs none
    table.put(MessageId.FILE_SIZE, this::fileSize);
    silent(MessageId.FILE_DATA, this::fileData);
    silent(MessageId.FILE_DONE, packet -> transfer(photo -> photo.acknowledged(0, true, now())));
    table.put(MessageId.ASK_BIT_RATE, packet -> values((byte) bitRate));
    table.put(MessageId.HEIGHT_LIMIT, packet -> values((byte) limits.height(), (byte) 0));
    table.put(
        MessageId.ASK_BATTERY_THRESHOLD, packet -> values((byte) limits.lowBattery(), (byte) 0));
    table.put(MessageId.ASK_ATTITUDE_LIMIT, packet -> attitudeLimit());
    table.put(MessageId.SSID, packet -> ssid());
    table.put(MessageId.VERSION, packet -> version());
    table.put(MessageId.LOADER_VERSION, packet -> version());
    table.put(MessageId.PASSWORD, packet -> values((byte) 0)); // the network is open
    table.put(MessageId.REGION, packet -> values((byte) 0));
    table.put(MessageId.CALIBRATION, packet -> values(SIDES, (byte) 0, (byte) 100, (byte) 0));
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

  /**
   * Returns whether a datagram is a packet of this protocol, whole or damaged.
   *
   * @param bytes an array that begins with the datagram
   * @param length the length of the datagram [bytes]
   */
  public static boolean isPacket(byte[] bytes, int length) {
    return length > 0 && bytes[0] == Packet.MARK;
  }

  @Override
  public boolean claims(byte[] datagram) {
    return isPacket(datagram, datagram.length) || isRequest(datagram);
  }

  private static boolean isRequest(byte[] datagram) {
    return WireText.decode(datagram).startsWith(NamedPacket.REQUEST);
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
        drone.observer().turnedAway(peer, NamedPacket.words(packet), session.refusal(peer));
      }
      return;
    }
    session.heard(peer, now());
    controller.linkAlive();
    link.ifPresent(AppLink::heard);
    table
        .get(id)
        .apply(packet)
        .map(packet::answer)
        .ifPresent(answer -> answer(peer, packet, answer));
  }

  private void answer(Peer peer, Packet packet, Packet answer) {
    boolean reported = FlightOrders.MESSAGES.contains(MessageId.of(packet.id()).orElseThrow());
    if (!reported && NamedPacket.isCommand(packet)) {
      orders.report(peer, packet, answer);
    }
    drone.port().send(LinkDatagram.reply(peer, answer.bytes()));
  }

  private void connect(Peer peer, byte[] request) {
    OptionalInt port = VideoPort.of(request);
    if (port.isEmpty()) {
      Phrase reason = Phrase.of("after `conn_req:`, there must be two bytes with the video port");
      drone.observer().ignored(peer, NamedPacket.CONNECTION, reason);
      return;
    }
    connect(peer, port.getAsInt());
  }

  private void connect(Peer peer, int port) {
    boolean again = session.link().app() && session.admits(peer);
    boolean standing = !controller.airborne();
    if (!session.openForApp(peer, now(), standing, port, new AppPacketizer())) {
      drone.observer().ignored(peer, NamedPacket.CONNECTION, refusal(peer));
      return;
    }
    if (!again) {
      note(
          Phrase.of(
              "is operated by %s now with the protocol of its app, and films for port %d there",
              peer.host(), port));
    }
    link = Optional.of(new AppLink(drone));
    controller.linkAlive();
    if (drone.faults().get().find(FaultKind.CONN_ACK_LOST).isEmpty()) {
      orders.connected(peer);
      drone.port().send(LinkDatagram.reply(peer, VideoPort.acknowledgement(port)));
    }
  }

  private Phrase refusal(Peer peer) {
    return session.admits(peer)
        ? Phrase.of("after `command`, the drone speaks the text protocol until it loses power")
        : session.refusal(peer);
  }

  // --- settings and questions ---

  private SimTime now() {
    return controller.now();
  }

  /** The link, for messages that are taken only while there is one. */
  private AppLink connected() {
    return link.orElseThrow();
  }

  private boolean setBitRate(int number) {
    boolean valid = number >= 0 && number < BIT_RATES.length;
    if (valid) {
      bitRate = number;
      controller.equipment().setVideo(VideoOption.BIT_RATE, BIT_RATES[number]);
    }
    return valid;
  }

  private boolean setWide(int mode) {
    if (mode == 0 || mode == 1) {
      controller.equipment().setVideo(VideoOption.WIDE, mode);
    }
    return mode == 0 || mode == 1;
  }

  private boolean setPhotoQuality(int number) {
    boolean valid = number >= 0 && number < QUALITIES.length;
    photoQuality = valid ? QUALITIES[number] : photoQuality;
    return valid;
  }

  private Result takePhoto() {
    if (connected().photo().isPresent()) {
      return new Result.Refused(RefusalKind.BUSY, Phrase.of("the last photo is still being sent"));
    }
    int number = drone.state().get().drone();
    Optional<Supplier<byte[]>> photo = drone.camera().take(number, photoQuality);
    photo.ifPresent(connected()::send);
    return photo.isPresent()
        ? Result.DONE
        : new Result.Refused(RefusalKind.GENERAL, Phrase.of("nothing renders what the drone sees"));
  }

  private void transfer(Consumer<PhotoTransfer> action) {
    connected().photo().ifPresent(action);
  }

  /**
   * Handles the acknowledgement of a file's size. It is answered only if it is the drone's own
   * packet sent back, as TelloPy does. Measured: TelloPy 25.
   */
  private Optional<byte[]> fileSize(Packet packet) {
    transfer(photo -> photo.sizeAcknowledged(now()));
    return packet.kind() == Packet.NOTIFICATION ? Optional.of(new byte[1]) : Optional.empty();
  }

  private void fileData(Packet packet) {
    transfer(photo -> photo.acknowledged(packet.integer(3), packet.unsigned(0) == 1, now()));
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
    link.ifPresent(
        connected -> {
          orders.watchOver();
          connected.output(limits.lowBattery());
        });
  }

  @Override
  public boolean hasPending() {
    return link.filter(AppLink::owes).isPresent();
  }

  @Override
  public void reset() {
    orders.reset();
  }

  @Override
  public void powerOff() {
    end();
    limits.reset();
    photoQuality = QUALITIES[1];
    bitRate = 0;
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
