package tellosimulator.model;

import java.util.List;
import tellosimulator.board.BoardLights;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState.Energy;
import tellosimulator.model.DroneState.Reference;
import tellosimulator.time.SimTime;
import tellosimulator.world.Room;

/**
 * The single source of truth about a drone. Written only on the simulation thread, by the
 * controller and by what it calls; everybody else reads a {@link DroneState} that was copied from
 * it.
 */
public final class DroneModel {

  private final int drone;
  private Pose start;
  private Motion motion;
  private boolean resting = true;
  private boolean pushed;
  private FlightPhase phase = FlightPhase.OFF;
  private Battery battery = Battery.FULL;
  private double temperature = Temperature.COLD;
  private double motorTime;
  private Reference reference;
  private Perception perception = Perception.OFF;
  private VideoSettings video = VideoSettings.DEFAULT;
  private BoardLights lights = BoardLights.DARK;

  /**
   * @param drone its number, from 1
   * @param start where it stands, on the floor
   */
  public DroneModel(int drone, Pose start) {
    this.drone = drone;
    this.start = start;
    this.motion = Motion.restingAt(start);
    this.reference =
        new Reference(SimTime.ZERO, start.attitude().heading(), 0, start.position().z());
  }

  /** An immutable copy of the present state. */
  public DroneState snapshot(SimTime now) {
    Energy energy = new Energy(battery, temperature, motorTime);
    return new DroneState(drone, now, motion, phase, energy, reference, perception, video, lights);
  }

  /** Power comes: SDK-independent state is as new, but for the battery and where it lies. */
  public void powerOn(SimTime now) {
    phase = resting ? FlightPhase.GROUNDED : FlightPhase.FALLING;
    temperature = Temperature.COLD;
    motorTime = 0;
    reference = new Reference(now, motion.attitude().heading(), 0, motion.position().z());
    look(PadMode.OFF);
    video = VideoSettings.DEFAULT;
    lights = lights.poweredOn(now);
  }

  public void powerOff() {
    phase = FlightPhase.OFF;
    video = VideoSettings.DEFAULT;
    lights = lights.poweredOff();
  }

  /** Back to the start, at rest; instruments count from there. */
  public void reset() {
    motion = Motion.restingAt(start);
    resting = true;
    reference =
        new Reference(
            reference.poweredAt(),
            start.attitude().heading(),
            reference.takeoffs(),
            start.position().z());
    look(PadMode.OFF);
    if (phase != FlightPhase.OFF) {
      phase = FlightPhase.GROUNDED;
    }
  }

  /** The room changed: start and drone move inside. */
  public void moveInto(Room room) {
    start = new Pose(room.nearestInside(start.position(), DroneSpec.COLLIDER), start.attitude());
    Vec3 inside = room.nearestInside(motion.position(), DroneSpec.COLLIDER);
    if (!inside.equals(motion.position())) {
      motion = motion.heldAt(inside, Vec3.ZERO);
    }
  }

  /** Lets time work on battery, temperature and motor time. */
  public void consume(double seconds, double filmingEndurance) {
    if (phase == FlightPhase.OFF) {
      return;
    }
    boolean motorsOn = phase.motorsOn();
    double flight = video.on() ? filmingEndurance : DroneSpec.ENDURANCE;
    battery = battery.after(seconds, phase.flying() ? flight : DroneSpec.IDLE_ENDURANCE);
    temperature = Temperature.after(temperature, motorsOn, seconds);
    if (motorsOn) {
      motorTime += seconds;
    }
  }

  /** The gyro drifts: heading counts from elsewhere [rad]. */
  public void turnReference(double angle) {
    reference =
        new Reference(
            reference.poweredAt(),
            reference.heading() + angle,
            reference.takeoffs(),
            reference.height());
  }

  /** It is at least so hot [°C]. */
  public void heat(double celsius) {
    temperature = Math.max(temperature, celsius);
  }

  /** A takeoff begins: height counts anew. */
  public void countTakeoff() {
    reference =
        new Reference(
            reference.poweredAt(),
            reference.heading(),
            reference.takeoffs() + 1,
            motion.position().z());
  }

  /** Comes to rest where it is: level if it is upright, on its back otherwise. */
  public void rest() {
    boolean upright = motion.attitude().up().z() > 0;
    Attitude heading = Attitude.ofHeading(motion.attitude().heading());
    Attitude lying = upright ? heading : heading.after(new Attitude(0, 1, 0, 0));
    motion = Motion.restingAt(new Pose(motion.position(), lying));
    resting = true;
  }

  public void setMotion(Motion newMotion) {
    motion = newMotion;
    resting = false;
  }

  /** Tells whether wind pushes it, as far as the drone itself feels that. */
  public void setPushed(boolean newPushed) {
    pushed = newPushed;
  }

  public void setPhase(FlightPhase newPhase) {
    phase = newPhase;
  }

  public void setBattery(Battery newBattery) {
    battery = newBattery;
  }

  public void setStart(Pose newStart) {
    start = newStart;
  }

  /** Looks for mission pads elsewhere; none is seen yet. */
  public void look(PadMode newPads) {
    perception = new Perception(newPads, false, List.of());
  }

  public void setPerception(Perception newPerception) {
    perception = newPerception;
  }

  public void setVideo(VideoSettings newVideo) {
    video = newVideo;
  }

  public void setLights(BoardLights newLights) {
    lights = newLights;
  }

  public int drone() {
    return drone;
  }

  public Pose start() {
    return start;
  }

  public Motion motion() {
    return motion;
  }

  public FlightPhase phase() {
    return phase;
  }

  /** Whether it lies or stands still without motors. */
  public boolean resting() {
    return resting;
  }

  /** Whether wind pushes it, as far as the drone itself feels that. */
  public boolean pushed() {
    return pushed;
  }

  /** Whether its feet are below it. */
  public boolean upright() {
    return motion.attitude().up().z() > 0;
  }

  public Battery battery() {
    return battery;
  }

  public Perception perception() {
    return perception;
  }

  public VideoSettings video() {
    return video;
  }

  /** Those of the extension board, dark if it has none. */
  public BoardLights lights() {
    return lights;
  }
}
