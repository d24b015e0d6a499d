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
 * The parts of one drone. Body and lamp are in the body frame; a propeller is at the origin of its
 * own. Immutable; for any thread.
 */
public final class DroneParts {

  /** How far a propeller that stands still is turned, times its number [rad]. Decided: by eye. */
  private static final double AT_REST = Math.toRadians(35);

  private final Part body;
  private final Part clockwise;
  private final Part counterClockwise;

  /** What is the same for all drones; made for the first one. */
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
   * @param cover colour of the drone's cover
   */
  public DroneParts(Rgb cover) {
    Texture colors = Palette.texture(cover);
    body = new Part(Shared.BODY, colors, Shading.GLOSSY);
    clockwise = new Part(Shared.CLOCKWISE, colors, Shading.GLOSSY);
    counterClockwise = new Part(Shared.COUNTER_CLOCKWISE, colors, Shading.GLOSSY);
  }

  /** All but lamp and propellers. */
  public Part body() {
    return body;
  }

  /** The lamp beside the lens. */
  public Part lamp(StatusLight light) {
    return Shared.LAMP.get(light);
  }

  /** What people see around the lamp while it is lit; translucent. */
  public Part glow(StatusLight light) {
    return Shared.GLOW.get(light);
  }

  /** The hubs of the propellers, body frame [m]: front left, front right, back left, right. */
  public List<Vec3> propellers() {
    return Shared.PROPELLERS;
  }

  /**
   * A propeller: its blades, or a disc when they turn fast.
   *
   * @param index its place in {@link #propellers}
   */
  public Part propeller(int index, boolean blurred) {
    if (blurred) {
      return Shared.DISC;
    }
    return turnsClockwise(index) ? clockwise : counterClockwise;
  }

  /**
   * How far a propeller is turned about the body's z axis, counter-clockwise seen from above [rad].
   *
   * @param index its place in {@link #propellers}
   * @param spin how far it has turned since it stood still [rad]
   */
  public double heading(int index, double spin) {
    return (index + 1) * AT_REST + (turnsClockwise(index) ? -spin : spin);
  }

  /** Front right and back left. Documented: parts list of the Tello; the others turn against it. */
  private static boolean turnsClockwise(int index) {
    return index == 1 || index == 2;
  }
}
