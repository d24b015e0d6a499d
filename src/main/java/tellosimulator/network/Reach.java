package tellosimulator.network;

/**
 * The machines that can reach the drones that listen on this machine's own addresses. Does not
 * apply to drones with a fixed address.
 */
public enum Reach {
  /** This machine only: drones listen on loopback. */
  THIS_MACHINE,
  /** This machine and others in the local networks: drones listen on all addresses. */
  NETWORK
}
