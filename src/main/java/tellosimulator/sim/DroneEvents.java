package tellosimulator.sim;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.command.CommandObserver;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.command.OperatorSession;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.command.Request;
import tellosimulator.controller.FlightEvent;
import tellosimulator.fault.LinkDirection;
import tellosimulator.protocol.app.NamedPacket;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * Converts a drone's flight events and its traffic with operators to simulation events. Not
 * thread-safe.
 */
final class DroneEvents implements CommandObserver {

  private final int drone;
  private final Supplier<SimTime> now;
  private final Consumer<SimEvent> events;

  /**
   * Creates the converter for the events of a drone.
   *
   * @param drone the number of the drone, from 1
   */
  DroneEvents(int drone, Supplier<SimTime> now, Consumer<SimEvent> events) {
    this.drone = drone;
    this.now = now;
    this.events = events;
  }

  SimTime now() {
    return now.get();
  }

  @Override
  public void happened(FlightEvent event) {
    events.accept(new SimEvent.DroneFlight(now.get(), drone, event));
  }

  /** Reports that datagrams were dropped because too many were in transit. */
  void dropped(long count) {
    events.accept(new SimEvent.WaitingDropped(now.get(), drone, count));
  }

  /**
   * Reports the loss of a datagram. State lines are not reported, since ten of them are sent per
   * second.
   */
  void lost(LinkDatagram datagram, Phrase cause) {
    Peer peer = datagram.peer();
    Optional<NamedPacket> packet = NamedPacket.of(datagram.bytes());
    if (datagram.direction() == LinkDirection.COMMANDS) {
      String text = packet.map(NamedPacket::words).orElseGet(datagram::text);
      events.accept(new SimEvent.CommandLost(now.get(), drone, peer, text, cause));
    } else if (datagram.direction() == LinkDirection.REPLIES) {
      String text = packet.flatMap(NamedPacket::reply).orElseGet(datagram::text);
      events.accept(new SimEvent.ReplyLost(now.get(), drone, peer, text, cause));
    }
  }

  @Override
  public void operatorChanged(OperatorSession.Takeover takeover, OperatorEndpoint link) {
    events.accept(
        new SimEvent.OperatorChanged(
            now.get(), drone, takeover.operator(), link.statePort(), takeover.before()));
  }

  @Override
  public void received(Request request) {
    events.accept(new SimEvent.CommandReceived(now.get(), drone, request));
  }

  @Override
  public void ignored(Peer peer, String text, Phrase reason) {
    events.accept(new SimEvent.CommandIgnored(now.get(), drone, peer, text, reason));
  }

  @Override
  public void turnedAway(Peer peer, String text, Phrase reason) {
    events.accept(new SimEvent.TurnedAway(now.get(), drone, peer, text, reason));
  }

  @Override
  public void replied(Request request, Reply reply) {
    events.accept(new SimEvent.ReplySent(now.get(), drone, request, reply));
  }

  @Override
  public void failed(Request request, Reply reply, Phrase reason) {
    events.accept(new SimEvent.CommandFailed(now.get(), drone, request, reply, reason));
  }

  @Override
  public void refused(Request request, Reply reply, Phrase reason) {
    events.accept(new SimEvent.CommandRefused(now.get(), drone, request, reply, reason));
  }
}
