package tellosimulator.network;

import tellosimulator.sim.SimInput;
import tellosimulator.sim.SimListener;
import tellosimulator.time.SimTime;

/**
 * Shows a tap the datagrams that a simulation takes. Not before: it is the moment of the taking
 * that decides what they do.
 *
 * @param ports have the tap
 */
record TakenDatagrams(Ports ports) implements SimListener {

  @Override
  public void taken(SimTime now, SimInput input) {
    if (input instanceof SimInput.Datagram datagram) {
      ports.tap().received(datagram.drone(), datagram.peer(), datagram.text());
    }
  }
}
