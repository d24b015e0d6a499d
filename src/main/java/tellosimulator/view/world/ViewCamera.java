package tellosimulator.view.world;

/** The camera through which the 3D scene is seen. */
public enum ViewCamera {
  /** The camera that shows the room, or orbits a drone. */
  SIMULATOR,
  /** The camera in the drone's nose. */
  DRONE
}
