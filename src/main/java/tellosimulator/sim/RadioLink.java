package tellosimulator.sim;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.function.Consumer;
import tellosimulator.command.CommandSyntax;
import tellosimulator.command.DronePort;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Corruption;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.FaultParameter;
import tellosimulator.fault.LinkDirection;
import tellosimulator.fault.LossyChannel;
import tellosimulator.protocol.app.StrayPacket;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The radio link between a drone and its sockets: one channel each for commands, replies and state
 * lines. An ideal link forwards everything at once. Confined to the simulation thread.
 */
final class RadioLink implements DronePort {

  private final DronePort port;
  private final Consumer<LinkDatagram> drone;
  private final DroneEvents events;
  private final LossyChannel<LinkDatagram> commands;
  private final LossyChannel<LinkDatagram> replies;
  private final LossyChannel<LinkDatagram> states;
  private final TrafficFaults interference = new TrafficFaults();
  private ActiveFaults faults = ActiveFaults.NONE;

  /**
   * Creates an ideal link.
   *
   * @param port sends the drone's datagrams
   * @param drone receives the datagrams that arrive at the drone
   * @param events notified of lost datagrams
   */
  RadioLink(DronePort port, Consumer<LinkDatagram> drone, DroneEvents events, SeededNoise noise) {
    this.port = port;
    this.drone = drone;
    this.events = events;
    commands = new LossyChannel<>(noise, LinkDirection.COMMANDS, new Receiver(drone));
    replies = new LossyChannel<>(noise, LinkDirection.REPLIES, new Receiver(port::send));
    states = new LossyChannel<>(noise, LinkDirection.STATE, new Receiver(port::send));
  }

  /** Sets the active faults. */
  void set(ActiveFaults newFaults) {
    faults = newFaults;
    commands.set(faults);
    replies.set(faults);
    states.set(faults);
  }

  ActiveFaults faults() {
    return faults;
  }

  /** Accepts a datagram that arrived at the drone's socket. */
  void receive(Peer peer, byte[] bytes) {
    LinkDatagram datagram = LinkDatagram.command(peer, bytes);
    commands.send(datagram, datagram.expected(), events.now());
    tellDropped();
  }

  @Override
  public void send(LinkDatagram datagram) {
    if (!TrafficFaults.concerns(datagram.peer())) {
      boolean state = datagram.direction() == LinkDirection.STATE;
      (state ? states : replies).send(datagram, datagram.expected(), events.now());
    }
  }

  @Override
  public void linked(OperatorEndpoint link) {
    port.linked(link);
  }

  /** Delivers the commands that are due, and sends the datagrams that faults inject. */
  void deliverCommands(Optional<Peer> operator) {
    commands.deliver(events.now());
    if (!faults.faults().isEmpty() && operator.isPresent()) {
      interference.act(operator.get());
    }
    tellDropped();
  }

  /** Delivers the replies and state lines that are due. */
  void deliverReplies() {
    replies.deliver(events.now());
    states.deliver(events.now());
    tellDropped();
  }

  /**
   * Whether commands can arrive even if no operator sends any: delayed commands, or commands that a
   * fault injects.
   */
  boolean brings() {
    return commands.hasPending() || !faults.faults().isEmpty();
  }

  /** Whether time must pass because datagrams are in transit. */
  boolean hasPending() {
    return commands.hasPending() || replies.hasPending() || states.hasPending();
  }

  /** Drops everything in transit, as a drone does when it loses power. */
  void forget() {
    commands.forget();
    replies.forget();
    states.forget();
  }

  private void tellDropped() {
    long dropped = commands.takeDropped() + replies.takeDropped() + states.takeDropped();
    if (dropped > 0) {
      events.dropped(dropped);
    }
  }

  private Phrase cause(Fault fault) {
    return faults.faults().contains(fault)
        ? Phrase.of("the fault %s", fault.text())
        : Phrase.of("the link %s", faults.link().option());
  }

  private final class Receiver implements LossyChannel.Receiver<LinkDatagram> {

    private final Consumer<LinkDatagram> end;

    /**
     * @param end receives the datagrams that are not lost
     */
    Receiver(Consumer<LinkDatagram> end) {
      this.end = end;
    }

    @Override
    public void arrived(LinkDatagram datagram) {
      end.accept(datagram);
    }

    @Override
    public void lost(LinkDatagram datagram, Fault fault) {
      events.lost(datagram, cause(fault));
    }

    @Override
    public LinkDatagram corrupted(LinkDatagram datagram, Corruption corruption) {
      return datagram.with(corruption.applied(datagram.bytes()));
    }

    @Override
    public int length(LinkDatagram datagram) {
      return datagram.bytes().length;
    }

    @Override
    public Object party(LinkDatagram datagram) {
      return datagram.peer();
    }
  }

  /**
   * Injects traffic on behalf of faults: stray datagrams from the drone to its operator, and
   * commands from a stranger. Confined to the simulation thread.
   */
  private final class TrafficFaults {

    /** The stranger's address. It is on this machine, so that nothing reaches a network. */
    private static final InetSocketAddress STRANGER = stranger();

    /** An effect of a fault that is repeated periodically. */
    private final class Repeated {

      private final FaultKind kind;
      private SimTime due = SimTime.ZERO;
      private int count;
      private boolean acting;

      Repeated(FaultKind kind) {
        this.kind = kind;
      }

      /** Returns whether the effect is due now, and counts it if so. */
      boolean due() {
        SimTime now = events.now();
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

    private final Repeated strays = new Repeated(FaultKind.STRAY_BINARY);
    private final Repeated strangers = new Repeated(FaultKind.STRANGER);

    /** Whether a peer is the stranger. Nothing is sent to the stranger. */
    static boolean concerns(Peer peer) {
      return peer.address().equals(STRANGER);
    }

    /** Sends the injected datagrams that are due. */
    void act(Peer operator) {
      if (strays.due()) {
        byte[] stray = StrayPacket.of(strays.count - 1);
        send(new LinkDatagram(LinkDirection.REPLIES, operator, stray, false));
      }
      if (strangers.due()) {
        CommandSyntax next = strangers.count == 1 ? CommandSyntax.COMMAND : CommandSyntax.LAND;
        byte[] command = WireText.encode(next.verb());
        drone.accept(LinkDatagram.command(new Peer(STRANGER, operator.via()), command));
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
}
