package tellosimulator.command;

import java.util.Optional;
import java.util.function.Supplier;

/** The camera with which drones take photos. */
@FunctionalInterface
public interface PhotoCamera {

  /** Where there is no camera, because nothing renders what drones see. */
  PhotoCamera NONE = (drone, quality) -> Optional.empty();

  /**
   * Takes a photo of what is in front of a drone at the end of the last step. Called on the
   * simulation thread. Does not wait until the photo is ready.
   *
   * @param drone the drone's number, from 1
   * @param quality from 0 to 1
   * @return waits for the photo and supplies it as a JPEG file; empty if it failed
   */
  Optional<Supplier<byte[]>> take(int drone, float quality);
}
