package tellosimulator.sim;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.function.BiConsumer;
import tellosimulator.command.CommandSyntax;
import tellosimulator.command.Peer;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.FaultParameter;
import tellosimulator.fault.StrayDatagram;
import tellosimulator.time.SimTime;

/**
 * What comes between a drone and its operator on demand: stray datagrams of the drone itself, and a
 * stranger who commands it, too. For the simulation thread.
 */
final class TrafficFaults {

  /** Where the stranger is: on this machine, so that nothing gets into a network. */
  private static final InetSocketAddress STRANGER = stranger();

  /** Something that a fault repeats. */
  private static final class Repeated {

    private final FaultKind kind;
    private SimTime due = SimTime.ZERO;
    private int count;
    private boolean acting;

    Repeated(FaultKind kind) {
      this.kind = kind;
    }

    /** Whether it happens now; if so, it is counted. */
    boolean due(ActiveFaults faults, SimTime now) {
      Optional<Fault> fault = faults.find(kind);
      if (fault.isEmpty()) {
        acting = false;
        return false;
      }
      if (!acting) {
        acting = true;
        due = now;
        count = 0;
      }
      if (now.isBefore(due)) {
        return false;
      }
      due = due.plus(fault.get().value(FaultParameter.EVERY));
      count++;
      return true;
    }
  }

  private final BiConsumer<Peer, String> sender;
  private final BiConsumer<Peer, String> drone;
  private final Repeated strays = new Repeated(FaultKind.STRAY_BINARY);
  private final Repeated commands = new Repeated(FaultKind.STRANGER);

  /**
   * @param sender takes what the drone sends
   * @param drone takes what the stranger commands
   */
  TrafficFaults(BiConsumer<Peer, String> sender, BiConsumer<Peer, String> drone) {
    this.sender = sender;
    this.drone = drone;
  }

  /** Whether it is the stranger, to whom nothing is sent. */
  static boolean concerns(Peer peer) {
    return peer.address().equals(STRANGER);
  }

  /** Does what is due. */
  void act(ActiveFaults faults, SimTime now, Peer operator) {
    if (strays.due(faults, now)) {
      sender.accept(operator, StrayDatagram.of(strays.count - 1));
    }
    if (commands.due(faults, now)) {
      CommandSyntax next = commands.count == 1 ? CommandSyntax.COMMAND : CommandSyntax.LAND;
      drone.accept(new Peer(STRANGER, operator.via()), next.verb());
    }
  }

  private static InetSocketAddress stranger() {
    try {
      return new InetSocketAddress(InetAddress.getByAddress(new byte[] {127, 0, 0, 66}), 6666);
    } catch (UnknownHostException e) {
      throw new IllegalStateException(e);
    }
  }
}
