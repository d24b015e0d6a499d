package tellosimulator.network;

/** From where drones can be reached that listen on the machine's own addresses. */
public enum Reach {
  /** Programs on this machine alone: drones listen on loopback. */
  THIS_MACHINE,
  /** Also other machines of the local networks: drones listen on all addresses. */
  NETWORK
}
