package tellosimulator.view;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.function.ObjIntConsumer;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.network.Reach;
import tellosimulator.network.Traffic;
import tellosimulator.sim.Control;

/**
 * What the window can do to the simulation: one message for each thing that a person does. For the
 * JavaFX thread; each method returns when the snapshot shows what was done.
 */
public final class SimulatorActions {

  private final OnlineSimulation simulation;
  private ObjIntConsumer<PortTakenException> refused = (refusal, drone) -> {};

  public SimulatorActions(OnlineSimulation simulation) {
    this.simulation = simulation;
  }

  /**
   * Uses a drone's power switch.
   *
   * @return why it stays off, if one of its ports cannot be had
   */
  public Optional<PortTakenException> switchPower(int drone, boolean on) {
    try {
      simulation.carryOut(new Control.Power(drone, on));
      return Optional.empty();
    } catch (PortTakenException e) {
      refused.accept(e, drone);
      return Optional.of(e);
    }
  }

  /** Tells somebody of each drone that stays off, and why. */
  void onRefused(ObjIntConsumer<PortTakenException> listener) {
    refused = listener;
  }

  /** Does anything else than using the power switch. */
  public void carryOut(Control control) {
    if (control instanceof Control.Power) {
      throw new IllegalArgumentException("the power switch is switchPower's");
    }
    try {
      simulation.carryOut(control);
    } catch (PortTakenException e) {
      throw new IllegalStateException("no port is opened for " + control, e);
    }
  }

  /** Lets a drone listen on another port from the next time it is switched on. */
  public void setCommandPort(int drone, int port) {
    simulation.setCommandPort(drone, port);
  }

  /** Where a drone listens while it is on. */
  public List<InetSocketAddress> addresses(int drone) {
    return simulation.addresses(drone);
  }

  /** Whether other machines of the local networks reach the drones. */
  public boolean reachableFromNetwork() {
    return simulation.reach() == Reach.NETWORK;
  }

  /** Lets other machines reach the drones, or no longer; at once. */
  public void setReachableFromNetwork(boolean reachable) {
    simulation.setReach(reachable ? Reach.NETWORK : Reach.THIS_MACHINE);
  }

  /** Whether time stands still, even if no frame has shown it yet. */
  public boolean paused() {
    return simulation.snapshot().clock().paused();
  }

  /** What a drone received and sent. */
  public Traffic traffic(int drone) {
    return simulation.traffic(drone);
  }
}
