package tellosimulator.video;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tellosimulator.command.Packetizer;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Corruption;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.LinkDirection;
import tellosimulator.fault.LossyChannel;
import tellosimulator.network.DatagramPort;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.video.codec.AccessUnit;

/**
 * The faults of a drone's video stream. They determine which moment the stream shows, and which
 * datagrams arrive. Like the stream, the faults follow the wall clock; losses depend on the number
 * of earlier datagrams. Confined to the drone's video thread.
 */
final class VideoFaults {

  /**
   * Type of the NAL unit with the sequence parameter set. A decoder cannot start without this set.
   * Documented: ITU-T H.264, table 7-1.
   */
  private static final int SEQUENCE_PARAMETERS = 7;

  /**
   * Type of the NAL unit with the picture parameter set. A decoder cannot start without this set.
   * Documented: ITU-T H.264, table 7-1.
   */
  private static final int PICTURE_PARAMETERS = 8;

  private static final int UNIT_TYPE = 0x1f;

  private static final int START_CODE_LENGTH = 4;

  /** A datagram in transit. */
  private static final class Packet {
    private final DatagramPort port;
    private final InetSocketAddress to;
    private final byte[] bytes;

    Packet(DatagramPort port, InetSocketAddress to, byte[] bytes) {
      this.port = port;
      this.to = to;
      this.bytes = bytes;
    }
  }

  private final LossyChannel<Packet> channel;
  private ActiveFaults faults = ActiveFaults.NONE;
  private Optional<SimSnapshot> frozen = Optional.empty();
  private SimTime before = SimTime.ZERO;

  VideoFaults(int drone) {
    channel = new LossyChannel<>(new SeededNoise(0, drone), LinkDirection.VIDEO, new Delivery());
  }

  /**
   * Returns whether a drone sends no video even though it replies {@code ok} to {@code streamon}.
   */
  static boolean silent(ActiveFaults faults) {
    return faults.find(FaultKind.NO_VIDEO_IN_STATION_MODE).isPresent();
  }

  /** Sets the active faults. */
  void set(ActiveFaults newFaults) {
    if (!newFaults.equals(faults)) {
      faults = newFaults;
      channel.set(faults);
    }
  }

  /**
   * Returns the snapshot to be rendered: the newest snapshot or, during a freeze, the snapshot with
   * which the freeze began.
   */
  SimSnapshot shown(SimSnapshot newest) {
    if (newest.time().isBefore(before)) { // the simulation has restarted
      channel.restart();
      frozen = Optional.empty();
    }
    before = newest.time();
    boolean still = faults.find(FaultKind.VIDEO_FREEZE).isPresent();
    frozen = still ? frozen.or(() -> Optional.of(newest)) : Optional.empty();
    return frozen.orElse(newest);
  }

  /** Returns the datagrams of a picture, without the parameter sets if a fault suppresses them. */
  List<byte[]> packets(AccessUnit picture, Packetizer packetizer) {
    boolean complete = faults.find(FaultKind.VIDEO_NO_PARAMETERS).isEmpty();
    List<byte[]> packets = new ArrayList<>();
    for (int i = 0; i < picture.nalUnits(); i++) {
      ByteBuffer unit = picture.nalUnit(i);
      if (complete || !parameters(unit)) {
        packets.addAll(packetizer.packets(unit));
      }
    }
    return packets;
  }

  private static boolean parameters(ByteBuffer unit) {
    int type = unit.get(unit.position() + START_CODE_LENGTH) & UNIT_TYPE;
    return type == SEQUENCE_PARAMETERS || type == PICTURE_PARAMETERS;
  }

  /**
   * Sends a datagram. An active fault may delay, damage or drop it.
   *
   * @param nanos wall clock [ns]
   */
  void send(DatagramPort port, InetSocketAddress to, byte[] bytes, long nanos) {
    if (channel.clear()) {
      port.send(bytes, to);
    } else {
      channel.send(new Packet(port, to, bytes), false, new SimTime(Math.max(0, nanos)));
    }
  }

  /**
   * Sends the delayed datagrams that are due.
   *
   * @param nanos wall clock [ns]
   */
  void deliver(long nanos) {
    channel.deliver(new SimTime(Math.max(0, nanos)));
  }

  /** Discards the datagrams in transit. */
  void forget() {
    channel.forget();
  }

  private static final class Delivery implements LossyChannel.Receiver<Packet> {

    @Override
    public void arrived(Packet packet) {
      packet.port.send(packet.bytes, packet.to);
    }

    @Override
    public void lost(Packet packet, Fault cause) {
      // not logged: a hundred messages a second would fill the log
    }

    @Override
    public Packet corrupted(Packet packet, Corruption corruption) {
      return new Packet(packet.port, packet.to, corruption.applied(packet.bytes));
    }

    @Override
    public int length(Packet packet) {
      return packet.bytes.length;
    }

    @Override
    public Object party(Packet packet) {
      return packet.to;
    }
  }
}
