package tellosimulator.sim;

import java.util.OptionalInt;
import tellosimulator.math.Pose;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * The initial setup of a drone. Immutable.
 *
 * @param start the drone's initial pose
 * @param product the drone's product, with its reference model
 * @param streamPorts ports on the operator's host
 * @param batteryPercent 0 to 100
 * @param rgb the colour of the drone's cover, as in #rrggbb; empty for the default colour of the
 *     drone's number
 * @param landsWhenSilent whether the drone lands automatically if no commands arrive, as a real
 *     drone does
 */
public record DroneSetup(
    Pose start,
    Product product,
    StreamPorts streamPorts,
    double batteryPercent,
    OptionalInt rgb,
    boolean landsWhenSilent) {

  /** Creates the setup of a drone that lands automatically if no commands arrive. */
  public DroneSetup(
      Pose start,
      Product product,
      StreamPorts streamPorts,
      double batteryPercent,
      OptionalInt rgb) {
    this(start, product, streamPorts, batteryPercent, rgb, true);
  }

  public DroneSetup {
    if (!(batteryPercent >= 0 && batteryPercent <= 100)) {
      throw new IllegalArgumentException(
          "batteryPercent is " + batteryPercent + ", but must be from 0 to 100");
    }
  }

  /** Returns the setup of a fully charged drone in the default colour of its number. */
  public static DroneSetup at(Pose start, Product product, StreamPorts streamPorts) {
    return new DroneSetup(start, product, streamPorts, 100, OptionalInt.empty());
  }

  public DroneSetup withStart(Pose newStart) {
    return new DroneSetup(newStart, product, streamPorts, batteryPercent, rgb, landsWhenSilent);
  }

  public DroneSetup withProduct(Product newProduct) {
    return new DroneSetup(start, newProduct, streamPorts, batteryPercent, rgb, landsWhenSilent);
  }

  public DroneSetup withStreamPorts(StreamPorts newStreamPorts) {
    return new DroneSetup(start, product, newStreamPorts, batteryPercent, rgb, landsWhenSilent);
  }

  /**
   * Returns a copy in another colour.
   *
   * @param newRgb as in #rrggbb; empty for the default colour of its number
   */
  public DroneSetup withColor(OptionalInt newRgb) {
    return new DroneSetup(start, product, streamPorts, batteryPercent, newRgb, landsWhenSilent);
  }

  /** Returns a copy that stays in the air if no commands arrive. */
  public DroneSetup withoutSafetyLanding() {
    return new DroneSetup(start, product, streamPorts, batteryPercent, rgb, false);
  }
}
