package tellosimulator.sensor;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.PadMode;
import tellosimulator.model.PadSighting;
import tellosimulator.model.Perception;
import tellosimulator.time.SimTime;

/** Detects mission pads in the view of the cameras. Immutable. */
public final class PadDetector {

  /**
   * Minimum distance at which a pad is recognised, along its own axis [m]. Measured: 30 cm
   * (TelloEduSwarmSearch, DJITelloPy). The value is two centimetres less than measured, so that a
   * drone that hovers at 30 cm and pitches does not lose sight of the pad below it.
   */
  static final double NEAREST = 0.28;

  /**
   * Maximum distance at which a pad is recognised, along its own axis [m]. Measured: 120 cm
   * (TelloEduSwarmSearch, DJITelloPy).
   */
  static final double FARTHEST = 1.2;

  /**
   * The cosine of the maximum angle between the line of sight and the pad's axis. Assumed: 60
   * degrees.
   */
  private static final double STEEPEST = 0.5;

  /** Interval between detections with one camera [ns]. Documented: 20 Hz (SDK 2.0). */
  private static final long ONE_CAMERA = 50_000_000;

  /** Interval between detections with both cameras [ns]. Documented: 10 Hz (SDK 2.0). */
  private static final long BOTH_CAMERAS = 100_000_000;

  /** The rotation from the body's axes to those of the downward camera: x down, y to the left. */
  private static final Attitude UNDERSIDE = pitchedDown(Math.PI / 2);

  private static final Attitude NOSE = pitchedDown(DroneSpec.CAMERA_TILT);

  private final double tanAcross = StrictMath.tan(DroneSpec.CAMERA_FIELD_OF_VIEW / 2);
  private final double tanUp = tanAcross * DroneSpec.CAMERA_HEIGHT_SHARE;

  /** A mission pad in the room. */
  public record Card(int id, Pose pose) {}

  /** Tests whether the line of sight between two places is free. */
  @FunctionalInterface
  public interface Sight {
    boolean free(Vec3 from, Vec3 to);
  }

  /** Whether a detection is due at a given time. */
  public static boolean looksAt(SimTime time, PadMode mode) {
    long period = mode == PadMode.BOTH ? BOTH_CAMERAS : ONE_CAMERA;
    return mode != PadMode.OFF && time.nanos() % period == 0;
  }

  /**
   * Returns the pads in sight: first the pads below, then the pads ahead, each group in order of
   * increasing distance.
   *
   * @param moment the current time, and the drone's pose
   * @param before the directions of detection, and the previous result
   */
  public Perception look(
      PadSighting.Moment moment, Perception before, List<Card> cards, Sight sight) {
    PadMode mode = before.padMode();
    List<PadSighting> found = new ArrayList<>();
    for (Card card : cards) {
      boolean below =
          mode != PadMode.FORWARD && lies(card) && sees(moment.drone(), card, UNDERSIDE, true);
      boolean ahead = mode != PadMode.DOWN && sees(moment.drone(), card, NOSE, false);
      if ((below || ahead) && sight.free(moment.drone().position(), card.pose().position())) {
        PadSighting.Moment seen = since(card.id(), moment, before.pads());
        found.add(new PadSighting(card.id(), card.pose(), seen, below));
      }
    }
    found.sort(
        Comparator.comparing(PadSighting::below)
            .reversed()
            .thenComparing(sighting -> sighting.offset().norm()));
    return new Perception(mode, true, found);
  }

  private static PadSighting.Moment since(
      int id, PadSighting.Moment now, List<PadSighting> before) {
    return before.stream()
        .filter(sighting -> sighting.id() == id)
        .findFirst()
        .map(sighting -> new PadSighting.Moment(sighting.moment().since(), now.drone()))
        .orElse(now);
  }

  /**
   * Whether a pad lies roughly flat. A drone cannot fly over a pad on a wall, even if it tilts so
   * far that its downward camera sees the pad.
   */
  private static boolean lies(Card card) {
    return card.pose().attitude().up().z() > STEEPEST;
  }

  /**
   * Whether a camera sees a pad.
   *
   * @param camera the attitude of the camera in the body's axes
   * @param longAlongNose whether the longer edge of the picture is parallel to the nose
   */
  private boolean sees(Pose drone, Card card, Attitude camera, boolean longAlongNose) {
    Vec3 offset = drone.position().minus(card.pose().position());
    double along = card.pose().attitude().toBody(offset).z();
    if (along < NEAREST || along > FARTHEST || along < STEEPEST * offset.norm()) {
      return false;
    }
    Vec3 inCamera = camera.toBody(drone.attitude().toBody(offset.times(-1)));
    double aside = Math.abs(inCamera.y());
    double upwards = Math.abs(inCamera.z());
    double tanAside = longAlongNose ? tanUp : tanAcross;
    double tanUpwards = longAlongNose ? tanAcross : tanUp;
    return inCamera.x() > 0
        && aside <= tanAside * inCamera.x()
        && upwards <= tanUpwards * inCamera.x();
  }

  private static Attitude pitchedDown(double angle) {
    return new Attitude(StrictMath.cos(angle / 2), 0, StrictMath.sin(angle / 2), 0);
  }
}
