package tellosimulator.sim;

import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.command.CommandObserver;
import tellosimulator.command.OperatorSession;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.controller.FlightEvent;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/** Turns what happens to a drone, and between it and operators, into events. For one thread. */
final class DroneEvents implements CommandObserver {

  private final int drone;
  private final Supplier<SimTime> now;
  private final Consumer<SimEvent> events;

  /**
   * @param drone its number, from 1
   */
  DroneEvents(int drone, Supplier<SimTime> now, Consumer<SimEvent> events) {
    this.drone = drone;
    this.now = now;
    this.events = events;
  }

  void happened(FlightEvent event) {
    events.accept(new SimEvent.DroneFlight(now.get(), drone, event));
  }

  /** What is on its way found no room. */
  void dropped(long count) {
    events.accept(new SimEvent.WaitingDropped(now.get(), drone, count));
  }

  void commandLost(Peer peer, String text, Phrase cause) {
    events.accept(new SimEvent.CommandLost(now.get(), drone, peer, text, cause));
  }

  void replyLost(Peer peer, String text, Phrase cause) {
    events.accept(new SimEvent.ReplyLost(now.get(), drone, peer, text, cause));
  }

  void operatorChanged(OperatorSession.Takeover takeover, int statePort) {
    events.accept(
        new SimEvent.OperatorChanged(
            now.get(), drone, takeover.operator(), statePort, takeover.before()));
  }

  @Override
  public void received(Peer peer, String text) {
    events.accept(new SimEvent.CommandReceived(now.get(), drone, peer, text));
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
  public void replied(Peer peer, String text, Reply reply) {
    events.accept(new SimEvent.ReplySent(now.get(), drone, peer, text, reply));
  }

  @Override
  public void failed(Peer peer, String text, Reply reply, Phrase reason) {
    events.accept(new SimEvent.CommandFailed(now.get(), drone, peer, text, reply, reason));
  }

  @Override
  public void refused(Peer peer, String text, Reply reply, Phrase reason) {
    events.accept(new SimEvent.CommandRefused(now.get(), drone, peer, text, reply, reason));
  }
}
