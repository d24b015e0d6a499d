package tellosimulator.junit;

/** The way into assertions about drones in the manner of AssertJ, which must be there for them. */
public final class TelloAssertions {

  private TelloAssertions() {}

  /** Assertions about what a drone did since the test began, and is doing now. */
  public static DroneAssert assertThat(SimulatedDrone drone) {
    return new DroneAssert(drone);
  }
}
