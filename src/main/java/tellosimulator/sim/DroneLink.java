package tellosimulator.sim;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.command.Link;
import tellosimulator.command.Peer;
import tellosimulator.command.ReplyPort;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Corruption;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkChannel;
import tellosimulator.fault.LinkDirection;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.sim.StatePort.StateReport;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * What is between a drone and its sockets: a channel each for commands, replies and state lines. On
 * an ideal link it hands everything on at once. For the simulation thread.
 */
final class DroneLink implements ReplyPort {

  /** Length of a state line, which is made later [bytes]. Measured: 140 to 175. */
  private static final int STATE_LENGTH = 160;

  /** A reply on its way. */
  private record Outgoing(Peer peer, String text) {}

  private final ReplyPort replyPort;
  private final StatePort statePort;
  private final Consumer<SimInput.Datagram> drone;
  private final DroneEvents events;
  private final Supplier<SimTime> now;
  private final LinkChannel<SimInput.Datagram> commands;
  private final LinkChannel<Outgoing> replies;
  private final LinkChannel<StateReport> states;
  private final TrafficFaults interference;
  private ActiveFaults faults = ActiveFaults.NONE;

  /**
   * The two ends of a link, and who is told what becomes of datagrams.
   *
   * @param number of the drone
   */
  record Ends(
      int number,
      ReplyPort replies,
      StatePort states,
      Consumer<SimInput.Datagram> drone,
      DroneEvents events,
      Supplier<SimTime> now) {}

  DroneLink(Ends ends, SeededNoise noise) {
    replyPort = ends.replies();
    statePort = ends.states();
    drone = ends.drone();
    events = ends.events();
    now = ends.now();
    commands = new LinkChannel<>(noise, LinkDirection.COMMANDS, new CommandReceiver());
    replies = new LinkChannel<>(noise, LinkDirection.REPLIES, new ReplyReceiver());
    states = new LinkChannel<>(noise, LinkDirection.STATE, new StateReceiver());
    interference =
        new TrafficFaults(
            (peer, text) -> replies.send(new Outgoing(peer, text), false, now.get()),
            (peer, text) -> drone.accept(new SimInput.Datagram(ends.number(), peer, text)));
  }

  /** Lets other faults act from now on. */
  void set(ActiveFaults newFaults) {
    faults = newFaults;
    commands.set(faults);
    replies.set(faults);
    states.set(faults);
  }

  ActiveFaults faults() {
    return faults;
  }

  /** A datagram has come to the drone's socket. */
  void receive(SimInput.Datagram datagram) {
    commands.send(datagram, true, now.get());
    tellDropped();
  }

  @Override
  public void reply(Peer peer, String text) {
    if (TrafficFaults.concerns(peer)) {
      return;
    }
    if (replies.clear()) {
      replyPort.reply(peer, text);
    } else {
      replies.send(new Outgoing(peer, text), true, now.get());
    }
  }

  @Override
  public void linked(Link link) {
    replyPort.linked(link);
  }

  /**
   * Sends a state line.
   *
   * @param expected whether a command came since the last one
   */
  void send(StateReport report, boolean expected) {
    states.send(report, expected, now.get());
  }

  /** Hands commands to the drone that are due, also those of nobody. */
  void deliverCommands(Optional<Peer> operator) {
    commands.deliver(now.get());
    if (!faults.faults().isEmpty() && operator.isPresent()) {
      interference.act(faults, now.get(), operator.get());
    }
    tellDropped();
  }

  /** Hands on what is due to leave. */
  void deliverReplies() {
    replies.deliver(now.get());
    states.deliver(now.get());
    tellDropped();
  }

  /** Whether commands may come without anybody sending one. */
  boolean brings() {
    return commands.owes() || !faults.faults().isEmpty();
  }

  /** Whether somebody waits for what is on its way. */
  boolean owes() {
    return commands.owes() || replies.owes() || states.owes();
  }

  /** Drops what is on its way, as a drone does that loses its power. */
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

  private final class CommandReceiver implements LinkChannel.Receiver<SimInput.Datagram> {

    @Override
    public void arrived(SimInput.Datagram datagram) {
      drone.accept(datagram);
    }

    @Override
    public void lost(SimInput.Datagram datagram, Fault fault) {
      events.commandLost(datagram.peer(), datagram.text(), cause(fault));
    }

    @Override
    public SimInput.Datagram corrupted(SimInput.Datagram datagram, Corruption corruption) {
      return new SimInput.Datagram(
          datagram.drone(), datagram.peer(), corruption.applied(datagram.text()));
    }

    @Override
    public int length(SimInput.Datagram datagram) {
      return datagram.text().length();
    }

    @Override
    public Object party(SimInput.Datagram datagram) {
      return datagram.peer();
    }
  }

  private final class ReplyReceiver implements LinkChannel.Receiver<Outgoing> {

    @Override
    public void arrived(Outgoing reply) {
      replyPort.reply(reply.peer(), reply.text());
    }

    @Override
    public void lost(Outgoing reply, Fault fault) {
      events.replyLost(reply.peer(), reply.text(), cause(fault));
    }

    @Override
    public Outgoing corrupted(Outgoing reply, Corruption corruption) {
      return new Outgoing(reply.peer(), corruption.applied(reply.text()));
    }

    @Override
    public int length(Outgoing reply) {
      return reply.text().length();
    }

    @Override
    public Object party(Outgoing reply) {
      return reply.peer();
    }
  }

  private final class StateReceiver implements LinkChannel.Receiver<StateReport> {

    @Override
    public void arrived(StateReport report) {
      statePort.send(report);
    }

    @Override
    public void lost(StateReport report, Fault fault) {
      // ten a second: the log would hold nothing else
    }

    @Override
    public StateReport corrupted(StateReport report, Corruption corruption) {
      return report.with(corruption);
    }

    @Override
    public int length(StateReport report) {
      return STATE_LENGTH;
    }

    @Override
    public Object party(StateReport report) {
      return LinkDirection.STATE;
    }
  }
}
