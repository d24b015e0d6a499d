package tellosimulator.command;

/**
 * The port through which one drone sends. Called on the simulation thread. Implementations must
 * neither block nor throw.
 */
@FunctionalInterface
public interface DronePort {

  /** Sends a reply or a state line. */
  void send(LinkDatagram datagram);

  /** Called when the drone's operator changes, or when the operator's address or ports change. */
  default void linked(OperatorEndpoint link) {}
}
