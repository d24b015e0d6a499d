package tellosimulator.view.model;

import tellosimulator.sim.SimConfig;
import tellosimulator.video.camera.DroneOptics;

/**
 * What a simulation begins with and cannot change while it runs. Immutable.
 *
 * @param seed of everything random
 * @param crashSpeed above which a touch is a crash [m/s]
 * @param optics of the drones' cameras
 */
public record StartSettings(long seed, double crashSpeed, DroneOptics optics) {

  /** A configuration with this seed and crash speed. */
  public SimConfig appliedTo(SimConfig config) {
    return config.withSeed(seed).withCrashSpeed(crashSpeed);
  }
}
