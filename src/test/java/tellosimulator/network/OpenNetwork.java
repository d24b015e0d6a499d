package tellosimulator.network;

/** Opens networks for tests. */
final class OpenNetwork {

  private OpenNetwork() {}

  /** Creates a network and opens the sockets of all drones. */
  static DroneNetwork of(AddressPlan plan) throws PortTakenException {
    DroneNetwork network = DroneNetwork.of(plan);
    try {
      for (int drone = 1; drone <= plan.drones().size(); drone++) {
        network.open(drone);
      }
      return network;
    } catch (PortTakenException e) {
      network.close();
      throw e;
    }
  }
}
