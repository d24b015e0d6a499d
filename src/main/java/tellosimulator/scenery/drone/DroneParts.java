package tellosimulator.scenery.drone;

import java.util.List;
import java.util.Map;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;

/**
 * The parts of one drone. The body and the lamp are in the body frame; a propeller is at the origin
 * of its own frame. Immutable.
 */
public final class DroneParts {

  /**
   * Angle of the first propeller at rest; the others rest at multiples of this angle [rad].
   * Decided: by eye.
   */
  private static final double AT_REST = Math.toRadians(35);

  private final Part body;
  private final Part clockwise;
  private final Part counterClockwise;

  /** The parts that all drones share; they are created together with the first drone. */
  private static final class Shared {

    static final Mesh BODY = BodyMesh.create();
    static final Mesh CLOCKWISE = PropellerMesh.create(true);
    static final Mesh COUNTER_CLOCKWISE = PropellerMesh.create(false);
    static final Part DISC =
        new Part(PropellerDisc.mesh(), PropellerDisc.texture(), Shading.TRANSLUCENT);
    static final Map<StatusLight, Part> LAMP = StatusLamp.parts();
    static final Map<StatusLight, Part> GLOW = LampGlow.parts();
    static final List<Vec3> PROPELLERS = List.copyOf(BodyMesh.propellers());
  }

  /**
   * Creates the parts of one drone.
   *
   * @param cover colour of the drone's cover
   */
  public DroneParts(Rgb cover) {
    Texture colors = Palette.texture(cover);
    body = new Part(Shared.BODY, colors, Shading.GLOSSY);
    clockwise = new Part(Shared.CLOCKWISE, colors, Shading.GLOSSY);
    counterClockwise = new Part(Shared.COUNTER_CLOCKWISE, colors, Shading.GLOSSY);
  }

  /** Returns the body, which is everything except the lamp and the propellers. */
  public Part body() {
    return body;
  }

  /** Returns the lamp beside the lens. */
  public Part lamp(StatusLight light) {
    return Shared.LAMP.get(light);
  }

  /**
   * Returns the translucent glow around the lit lamp. The glow is visible to people, but not to
   * drones' cameras.
   */
  public Part glow(StatusLight light) {
    return Shared.GLOW.get(light);
  }

  /**
   * Returns the positions of the propeller hubs in the body frame [m]: front left, front right,
   * back left, back right.
   */
  public List<Vec3> propellers() {
    return Shared.PROPELLERS;
  }

  /**
   * Returns a propeller: its blades, or a disc if it spins fast.
   *
   * @param index index of the propeller in {@link #propellers}
   */
  public Part propeller(int index, boolean blurred) {
    if (blurred) {
      return Shared.DISC;
    }
    return turnsClockwise(index) ? clockwise : counterClockwise;
  }

  /**
   * Returns the angle of a propeller about the body's z axis, counter-clockwise seen from above
   * [rad].
   *
   * @param index index of the propeller in {@link #propellers}
   * @param spin angle through which it has turned from rest [rad]
   */
  public double heading(int index, double spin) {
    return (index + 1) * AT_REST + (turnsClockwise(index) ? -spin : spin);
  }

  /**
   * Returns whether a propeller turns clockwise: the front right and the back left propeller do;
   * the other two turn counter-clockwise. Documented: parts list of the Tello.
   */
  private static boolean turnsClockwise(int index) {
    return index == 1 || index == 2;
  }
}
