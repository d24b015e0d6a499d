package tellosimulator.sim;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import tellosimulator.command.DroneProtocol;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.OperatorSession;
import tellosimulator.command.Peer;
import tellosimulator.command.ProtocolContext;
import tellosimulator.command.TextProtocol;
import tellosimulator.controller.FlightEvent;
import tellosimulator.protocol.app.AppProtocol;
import tellosimulator.protocol.app.NamedPacket;
import tellosimulator.words.Phrase;

/**
 * The protocols through which programs operate a drone, and the session that the protocols share.
 * Confined to the simulation thread.
 */
final class DroneProtocols {

  private final ProtocolContext drone;
  private final OperatorSession session;

  /**
   * All protocols of the drone. A datagram goes to the first one that claims it; texts are last.
   */
  private final List<DroneProtocol> protocols;

  DroneProtocols(ProtocolContext drone) {
    this.drone = drone;
    session = drone.session();
    protocols = List.of(new AppProtocol(drone), new TextProtocol(drone));
  }

  /** Handles a datagram that has arrived at the drone. Called only while the drone is on. */
  void receive(LinkDatagram datagram) {
    byte[] bytes = datagram.bytes();
    protocols.stream()
        .filter(protocol -> protocol.claims(bytes))
        .findFirst()
        .ifPresent(protocol -> protocol.receive(datagram.peer(), bytes));
  }

  /** Reports a datagram that has no effect. */
  void ignore(LinkDatagram datagram, Phrase reason) {
    drone.observer().ignored(datagram.peer(), NamedPacket.text(datagram.bytes()), reason);
  }

  /**
   * Handles the report that a destination is unreachable. An unreachable state port suspends the
   * state lines; an unreachable operator port ends the session.
   */
  void unreachable(InetSocketAddress destination) {
    if (destination.equals(session.link().operator().map(Peer::address).orElse(null))) {
      drone.controller().endSession();
      note(
          Phrase.of(
              "is free, because its replies at %s:%d are no longer received; `command` starts a new session",
              destination.getAddress().getHostAddress(), destination.getPort()));
    } else if (goesTo(session.link().statePort(), destination)) {
      session.restState(drone.controller().now());
    }
  }

  private boolean goesTo(int port, InetSocketAddress destination) {
    return session.link().at(port).map(Peer::address).filter(destination::equals).isPresent();
  }

  /** Ends the session at the user's request. */
  void release() {
    Phrase free = Phrase.of("is free: whoever sends `command` next operates it");
    Optional<Peer> operator = session.link().operator();
    note(operator.map(lost -> Phrase.of("%s; %s has lost it", free, lost.host())).orElse(free));
    drone.controller().endSession();
  }

  /** Resets the protocols. The operator keeps the drone until another one takes over. */
  void reset() {
    protocols.forEach(DroneProtocol::reset);
    session.release();
  }

  /** Ends the session, as a loss of power does. */
  void powerOff() {
    session.close();
    protocols.forEach(DroneProtocol::powerOff);
  }

  void output() {
    protocols.forEach(DroneProtocol::output);
  }

  /** Whether a client is waiting for output that is not due yet. */
  boolean hasPending() {
    for (DroneProtocol protocol : protocols) {
      if (protocol.hasPending()) {
        return true;
      }
    }
    return false;
  }

  private void note(Phrase phrase) {
    drone.observer().happened(new FlightEvent.Note(phrase));
  }
}
