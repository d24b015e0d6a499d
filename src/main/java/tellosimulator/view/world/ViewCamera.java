package tellosimulator.view.world;

/** Through which camera the 3D scene is seen. */
public enum ViewCamera {
  /** The one that orbits the drone. */
  SIMULATOR,
  /** The one in the drone's nose. */
  DRONE
}
