package tellosimulator.protocol.app;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.Peer;
import tellosimulator.command.ProtocolContext;
import tellosimulator.fault.LinkDirection;
import tellosimulator.protocol.app.Telemetry.Notification;
import tellosimulator.time.SimTime;

/**
 * What the drone sends of its own accord to a connected program: telemetry, log, video and photos.
 * Confined to the simulation thread.
 */
final class AppLink {

  /** Time from the connection to the question for the time [s]. Decided. */
  private static final double ASKS_TIME = 1;

  /**
   * Time from the connection to the video, unless a packet arrives before [s]. Decided: a host that
   * did not ask for the connection reports a closed port meanwhile, and receives no video.
   */
  private static final double FILMS_AFTER = 0.5;

  /** Minimum time between key pictures that are asked for [s]. Decided: four a second. */
  private static final double KEY_PERIOD = 0.25;

  private final ProtocolContext drone;
  private final Telemetry telemetry;
  private final AppLog log;
  private final SimTime since;
  private int sequence;
  private boolean timeAsked;
  private boolean films;

  /** Whether a packet has come since the last notification. */
  private boolean owed;

  private SimTime keyPicture;
  private int photos;
  private Optional<PhotoTransfer> photo = Optional.empty();

  /** Begins now. */
  AppLink(ProtocolContext drone) {
    this.drone = drone;
    telemetry = new Telemetry(drone);
    log = new AppLog(drone);
    since = now();
    keyPicture = since;
  }

  private SimTime now() {
    return drone.controller().now();
  }

  /** Records that a packet has arrived. */
  void heard() {
    owed = true;
    film();
  }

  private void film() {
    if (!films) {
      films = true;
      drone.controller().equipment().stream(true);
    }
  }

  /** Whether a program is waiting for a notification. */
  boolean owes() {
    return owed || photo.filter(PhotoTransfer::beingTaken).isPresent();
  }

  AppLog log() {
    return log;
  }

  /** Sends a key picture, but not too often. */
  void sendKeyPicture() {
    if (now().since(keyPicture) >= KEY_PERIOD) {
      keyPicture = now();
      drone.controller().equipment().sendKeyPicture();
    }
  }

  /** The photo that is being sent, if any. */
  Optional<PhotoTransfer> photo() {
    return photo;
  }

  /**
   * Begins to send a photo.
   *
   * @param supplier waits for the photo
   */
  void send(Supplier<byte[]> supplier) {
    photo = Optional.of(new PhotoTransfer(photos & 0xffff, supplier, now()));
    photos++;
  }

  /**
   * Sends everything that is due at the end of this step.
   *
   * @param lowBattery charge at which the battery counts as low [%]
   */
  void output(int lowBattery) {
    if (now().since(since) >= FILMS_AFTER) {
      film();
    }
    if (!timeAsked && now().since(since) >= ASKS_TIME) {
      timeAsked = true;
      send(List.of(new Notification(MessageId.TIME, new byte[0])), LinkDirection.STATE);
    }
    send(telemetry.due(lowBattery), LinkDirection.STATE);
    send(log.due(), LinkDirection.STATE);
    photo.ifPresent(transfer -> send(transfer.due(now()), LinkDirection.REPLIES));
    photo = photo.filter(transfer -> !transfer.over());
  }

  /**
   * Sends notifications.
   *
   * @param direction state lines are lost more often than replies
   */
  private void send(List<Notification> notifications, LinkDirection direction) {
    Peer peer = drone.session().link().operator().orElseThrow();
    for (Notification each : notifications) {
      Packet packet =
          new Packet(Packet.NOTIFICATION, each.id().number(), sequence & 0xffff, each.payload());
      sequence++;
      drone.port().send(new LinkDatagram(direction, peer, packet.bytes(), owed));
      owed = false;
    }
  }
}
