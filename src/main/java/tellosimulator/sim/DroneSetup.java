package tellosimulator.sim;

import java.util.OptionalInt;
import tellosimulator.math.Pose;
import tellosimulator.sim.SimConfig.Outlets;
import tellosimulator.sim.SimConfig.Product;

/**
 * What one drone starts from. Immutable.
 *
 * @param start where it stands
 * @param product which drone, after which account
 * @param outlets ports on the operator's host
 * @param batteryPercent 0 to 100
 * @param rgb colour of its cover, as one writes #rrggbb; empty for that of its number
 * @param landsWhenSilent whether it lands by itself when no command comes, as a real one does
 */
public record DroneSetup(
    Pose start,
    Product product,
    Outlets outlets,
    double batteryPercent,
    OptionalInt rgb,
    boolean landsWhenSilent) {

  /** One that lands by itself when no command comes. */
  public DroneSetup(
      Pose start, Product product, Outlets outlets, double batteryPercent, OptionalInt rgb) {
    this(start, product, outlets, batteryPercent, rgb, true);
  }

  public DroneSetup {
    if (!(batteryPercent >= 0 && batteryPercent <= 100)) {
      throw new IllegalArgumentException(
          "batteryPercent is " + batteryPercent + ", but must be from 0 to 100");
    }
  }

  /** A full one in the colour of its number. */
  public static DroneSetup at(Pose start, Product product, Outlets outlets) {
    return new DroneSetup(start, product, outlets, 100, OptionalInt.empty());
  }

  public DroneSetup withStart(Pose newStart) {
    return new DroneSetup(newStart, product, outlets, batteryPercent, rgb, landsWhenSilent);
  }

  public DroneSetup withProduct(Product newProduct) {
    return new DroneSetup(start, newProduct, outlets, batteryPercent, rgb, landsWhenSilent);
  }

  public DroneSetup withOutlets(Outlets newOutlets) {
    return new DroneSetup(start, product, newOutlets, batteryPercent, rgb, landsWhenSilent);
  }

  /** One that stays in the air however long no command comes. */
  public DroneSetup withoutSafetyLanding() {
    return new DroneSetup(start, product, outlets, batteryPercent, rgb, false);
  }
}
