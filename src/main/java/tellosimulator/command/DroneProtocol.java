package tellosimulator.command;

/**
 * A protocol by which programs operate a drone over its command port. It turns datagrams into
 * orders to the {@code DroneController}, and results and measurements into datagrams. Each drone
 * has its own instance of each protocol. All protocols of a drone share one {@link
 * OperatorSession}, which also determines where the video goes. Confined to the simulation thread.
 */
public interface DroneProtocol {

  /**
   * Whether a datagram belongs to this protocol. This depends only on the bytes of the datagram,
   * not on the session.
   */
  boolean claims(byte[] datagram);

  /** Handles a datagram that this protocol claims. Called only while the drone is on. */
  void receive(Peer peer, byte[] datagram);

  /** Sends all output that is due at the end of a step, except for replies. */
  void output();

  /**
   * Whether a client is waiting for output that is not due yet, so that simulated time must pass.
   */
  boolean hasPending();

  /**
   * Forgets earlier datagrams, because the drone has been put back at its start. The session
   * continues.
   */
  void reset();

  /** Stops all output, because the drone has lost power or its session has ended. */
  void powerOff();
}
