package tellosimulator.video;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Corruption;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.LinkChannel;
import tellosimulator.fault.LinkDirection;
import tellosimulator.network.DatagramPort;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;

/**
 * What faults do to a drone's stream: which moment it shows, and which datagrams arrive. As the
 * stream does, it follows the wall clock; what it loses depends on how many datagrams came before.
 * For the drone's video thread.
 */
final class VideoFaults {

  /** NAL units without which a decoder cannot begin. Documented: ITU-T H.264, table 7-1. */
  private static final int SEQUENCE_PARAMETERS = 7;

  private static final int PICTURE_PARAMETERS = 8;

  private static final int UNIT_TYPE = 0x1f;

  /** A datagram on its way. */
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

  private final LinkChannel<Packet> channel;
  private ActiveFaults faults = ActiveFaults.NONE;
  private Optional<SimSnapshot> frozen = Optional.empty();
  private SimTime before = SimTime.ZERO;

  VideoFaults(int drone) {
    channel = new LinkChannel<>(new SeededNoise(0, drone), LinkDirection.VIDEO, new Delivery());
  }

  /** Whether a drone sends no pictures though it says so. */
  static boolean silent(ActiveFaults faults) {
    return faults.find(FaultKind.NO_VIDEO_IN_STATION_MODE).isPresent();
  }

  /** Lets other faults act from now on. */
  void set(ActiveFaults newFaults) {
    if (!newFaults.equals(faults)) {
      faults = newFaults;
      channel.set(faults);
    }
  }

  /** The moment that is filmed. */
  SimSnapshot shown(SimSnapshot newest) {
    if (newest.time().isBefore(before)) { // the simulation began anew
      channel.restart();
      frozen = Optional.empty();
    }
    before = newest.time();
    boolean still = faults.find(FaultKind.VIDEO_FREEZE).isPresent();
    frozen = still ? frozen.or(() -> Optional.of(newest)) : Optional.empty();
    return frozen.orElse(newest);
  }

  /** What is sent of a picture. */
  List<byte[]> sent(List<byte[]> packets) {
    return faults.find(FaultKind.VIDEO_NO_PARAMETERS).isEmpty()
        ? packets
        : packets.stream().filter(packet -> !parameters(packet)).toList();
  }

  private static boolean parameters(byte[] packet) {
    int start = 0;
    while (start < packet.length && packet[start] == 0) {
      start++;
    }
    boolean unit = start >= 2 && start + 1 < packet.length && packet[start] == 1;
    int type = unit ? packet[start + 1] & UNIT_TYPE : 0;
    return type == SEQUENCE_PARAMETERS || type == PICTURE_PARAMETERS;
  }

  /**
   * Sends a datagram.
   *
   * @param nanos the wall clock [ns]
   */
  void send(DatagramPort port, InetSocketAddress to, byte[] bytes, long nanos) {
    if (channel.clear()) {
      port.send(bytes, to);
    } else {
      channel.send(new Packet(port, to, bytes), false, new SimTime(Math.max(0, nanos)));
    }
  }

  /**
   * Sends what is due.
   *
   * @param nanos the wall clock [ns]
   */
  void deliver(long nanos) {
    channel.deliver(new SimTime(Math.max(0, nanos)));
  }

  /** Forgets what is on its way. */
  void forget() {
    channel.forget();
  }

  private static final class Delivery implements LinkChannel.Receiver<Packet> {

    @Override
    public void arrived(Packet packet) {
      packet.port.send(packet.bytes, packet.to);
    }

    @Override
    public void lost(Packet packet, Fault cause) {
      // a hundred a second: the log would hold nothing else
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
