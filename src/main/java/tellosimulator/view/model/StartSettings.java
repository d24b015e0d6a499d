package tellosimulator.view.model;

import tellosimulator.sim.SimConfig;
import tellosimulator.video.camera.DroneOptics;

/**
 * The settings with which a simulation begins and which cannot change while it runs. Immutable.
 *
 * @param seed the seed of all random values
 * @param crashSpeed the impact speed above which a contact is a crash [m/s]
 * @param optics the optics of the drones' cameras
 */
public record StartSettings(long seed, double crashSpeed, DroneOptics optics) {

  /** Returns a copy of a configuration with this seed and crash speed. */
  public SimConfig appliedTo(SimConfig config) {
    return config.withSeed(seed).withCrashSpeed(crashSpeed);
  }
}
