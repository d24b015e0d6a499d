package tellosimulator.junit;

/** The entry point for AssertJ assertions about drones and points. Requires AssertJ. */
public final class TelloAssertions {

  private TelloAssertions() {}

  /** Returns assertions about a drone's current state and its history since the test began. */
  public static DroneAssert assertThat(SimulatedDrone drone) {
    return new DroneAssert(drone);
  }

  /** Returns assertions about the points for the goals of the scenario. */
  public static SimulationAssert assertThat(TelloSimulation simulation) {
    return new SimulationAssert(simulation);
  }
}
