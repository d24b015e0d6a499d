package tellosimulator.junit;

import java.util.List;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultText;
import tellosimulator.fault.LinkPreset;
import tellosimulator.sim.Control;

/** What goes wrong in a simulation, on demand. Each test begins with that of its settings. */
public final class Faults {

  private final TelloSimulator simulator;

  Faults(TelloSimulator simulator) {
    this.simulator = simulator;
  }

  /**
   * Adds one; it begins at once unless it says otherwise.
   *
   * @param text such as {@code no-valid-imu drone 1 after "forward 100" for 3s}
   * @throws IllegalArgumentException with a sentence, if it is none, or of no drone
   */
  public void inject(String text) {
    Fault fault = FaultText.read(text);
    fault.target().drone().ifPresent(simulator::drone);
    simulator.carryOut(new Control.InjectFault(fault));
  }

  /** Ends all. */
  public void clear() {
    simulator.carryOut(new Control.ClearFaults());
  }

  /**
   * Makes the link better or worse.
   *
   * @param preset {@code ideal}, {@code lab}, {@code classroom} or {@code crowded}
   * @throws IllegalArgumentException with a sentence, if there is none of that name
   */
  public void link(String preset) {
    simulator.carryOut(new Control.SetLink(LinkPreset.of(preset)));
  }

  /**
   * What goes wrong now with a drone, each in a line.
   *
   * @param drone its number, from 1
   */
  public List<String> running(int drone) {
    simulator.settle();
    return simulator.drone(drone).faults();
  }
}
