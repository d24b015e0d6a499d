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

/** Finds mission pads in what the cameras see. Immutable; for any thread. */
public final class PadDetector {

  /**
   * Nearest and farthest that a pad is recognised, along its own axis [m]. Measured: 30 to 120 cm
   * (TelloEduSwarmSearch, DJITelloPy); two centimetres less, because a drone that hovers at 30 cm
   * and pitches sees the pad below it all the time.
   */
  static final double NEAREST = 0.28;

  static final double FARTHEST = 1.2;

  /** Steepest look at a pad, as the cosine of the angle to its axis. Assumed: 60 degrees. */
  private static final double STEEPEST = 0.5;

  /** Periods of looking with one camera and with both [ns]. Documented: 20 and 10 Hz (SDK 2.0). */
  private static final long ONE_CAMERA = 50_000_000;

  private static final long BOTH_CAMERAS = 100_000_000;

  /** From the body's axes to those of the camera in the underside: x down, y to the left. */
  private static final Attitude UNDERSIDE = pitchedDown(Math.PI / 2);

  private static final Attitude NOSE = pitchedDown(DroneSpec.CAMERA_TILT);

  private final double tanAcross = StrictMath.tan(DroneSpec.CAMERA_FIELD_OF_VIEW / 2);
  private final double tanUp = tanAcross * DroneSpec.CAMERA_HEIGHT_SHARE;

  /** A pad in the room. */
  public record Card(int id, Pose pose) {}

  /** Whether something stands between two places. */
  @FunctionalInterface
  public interface Sight {
    boolean free(Vec3 from, Vec3 to);
  }

  /** Whether it looks at this moment. */
  public static boolean looksAt(SimTime time, PadMode mode) {
    long period = mode == PadMode.BOTH ? BOTH_CAMERAS : ONE_CAMERA;
    return mode != PadMode.OFF && time.nanos() % period == 0;
  }

  /**
   * What it sees now: first what is below, and of several the nearest.
   *
   * @param moment now, and from where it looks
   * @param before where it looks, and what it saw when it looked last
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

  /** A pad that hangs is none to fly over, even if a tilted drone sees it with its underside. */
  private static boolean lies(Card card) {
    return card.pose().attitude().up().z() > STEEPEST;
  }

  /**
   * @param camera its attitude in the body's axes
   * @param longAlongNose whether the longer edge of its picture lies along the nose
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
