package tellosimulator.junit;

import java.util.List;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultText;
import tellosimulator.fault.LinkPreset;
import tellosimulator.sim.Control;

/**
 * Injects faults into a running simulation. Each test begins with the faults and the link quality
 * from its settings.
 */
public final class Faults {

  private final TelloSimulator simulator;

  Faults(TelloSimulator simulator) {
    this.simulator = simulator;
  }

  /**
   * Adds a fault. The fault begins at once unless its text specifies a later start.
   *
   * @param text the fault in words, such as {@code no-valid-imu drone 1 after "forward 100" for 3s}
   * @throws IllegalArgumentException if the text is not a valid fault or names a drone that does
   *     not exist; the message is one sentence
   */
  public void inject(String text) {
    Fault fault = FaultText.read(text);
    fault.target().drone().ifPresent(simulator::drone);
    simulator.carryOut(new Control.InjectFault(fault));
  }

  /** Ends all faults. */
  public void clear() {
    simulator.carryOut(new Control.ClearFaults());
  }

  /**
   * Sets the quality of the radio link.
   *
   * @param preset {@code ideal}, {@code lab}, {@code classroom} or {@code crowded}
   * @throws IllegalArgumentException if there is no preset with that name; the message is one
   *     sentence
   */
  public void link(String preset) {
    simulator.carryOut(new Control.SetLink(LinkPreset.of(preset)));
  }

  /**
   * Returns the faults that currently affect a drone, one line each.
   *
   * @param drone the number of the drone, from 1
   */
  public List<String> running(int drone) {
    simulator.settle();
    return simulator.drone(drone).faults();
  }
}
