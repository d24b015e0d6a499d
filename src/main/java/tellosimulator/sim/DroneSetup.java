package tellosimulator.sim;

import java.util.OptionalInt;
import tellosimulator.math.Pose;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * What one drone starts from. Immutable.
 *
 * @param start where it stands
 * @param product which drone, after which account
 * @param streamPorts ports on the operator's host
 * @param batteryPercent 0 to 100
 * @param rgb colour of its cover, as one writes #rrggbb; empty for that of its number
 * @param landsWhenSilent whether it lands by itself when no command comes, as a real one does
 */
public record DroneSetup(
    Pose start,
    Product product,
    StreamPorts streamPorts,
    double batteryPercent,
    OptionalInt rgb,
    boolean landsWhenSilent) {

  /** One that lands by itself when no command comes. */
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

  /** A full one in the colour of its number. */
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
   * The same in another colour.
   *
   * @param newRgb as one writes #rrggbb; empty for that of its number
   */
  public DroneSetup withColor(OptionalInt newRgb) {
    return new DroneSetup(start, product, streamPorts, batteryPercent, newRgb, landsWhenSilent);
  }

  /** One that stays in the air however long no command comes. */
  public DroneSetup withoutSafetyLanding() {
    return new DroneSetup(start, product, streamPorts, batteryPercent, rgb, false);
  }
}
