package tellosimulator.model;

import java.util.List;
import tellosimulator.extension.BoardLights;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState.Energy;
import tellosimulator.model.DroneState.Reference;
import tellosimulator.time.SimTime;
import tellosimulator.world.Room;

/**
 * The single source of truth about a drone. Only the controller and its collaborators write to it,
 * on the simulation thread. All other code reads a {@link DroneState}, which is a copy.
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
   * Creates a drone that is switched off.
   *
   * @param drone the number of the drone, from 1
   * @param start the drone's pose on the floor
   */
  public DroneModel(int drone, Pose start) {
    this.drone = drone;
    this.start = start;
    this.motion = Motion.restingAt(start);
    this.reference =
        new Reference(SimTime.ZERO, start.attitude().heading(), 0, start.position().z());
  }

  /** Returns an immutable copy of the current state. */
  public DroneState snapshot(SimTime now) {
    Energy energy = new Energy(battery, temperature, motorTime);
    return new DroneState(drone, now, motion, phase, energy, reference, perception, video, lights);
  }

  /** Switches the drone on. Initializes all state except the battery, the start and the motion. */
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

  /**
   * Puts the drone back at its start, at rest. The instruments then measure relative to the start.
   */
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

  /** Moves the start and the drone into a changed room if they would otherwise be outside it. */
  public void moveInto(Room room) {
    start = new Pose(room.nearestInside(start.position(), DroneSpec.COLLIDER), start.attitude());
    Vec3 inside = room.nearestInside(motion.position(), DroneSpec.COLLIDER);
    if (!inside.equals(motion.position())) {
      motion = motion.heldAt(inside, Vec3.ZERO);
    }
  }

  /**
   * Updates battery, temperature and motor time after a step.
   *
   * @param seconds the length of the step
   * @param filmingEndurance the time that a full battery lasts in flight while video is sent [s]
   */
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

  /** Turns the reference of the heading by an angle [rad], as if the gyro had drifted. */
  public void turnReference(double angle) {
    reference =
        new Reference(
            reference.poweredAt(),
            reference.heading() + angle,
            reference.takeoffs(),
            reference.height());
  }

  /** Raises the temperature to at least the given value [°C]. */
  public void heat(double celsius) {
    temperature = Math.max(temperature, celsius);
  }

  /** Counts a takeoff, and sets the height reference. */
  public void countTakeoff() {
    reference =
        new Reference(
            reference.poweredAt(),
            reference.heading(),
            reference.takeoffs() + 1,
            motion.position().z());
  }

  /** Brings the drone to rest in place: level if it is upright, otherwise on its back. */
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

  /** Sets whether the drone's own sensors detect that wind pushes it. */
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

  /** Sets the directions in which to detect mission pads, and clears the detected pads. */
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

  /** Whether the drone lies or stands still with its motors off. */
  public boolean resting() {
    return resting;
  }

  /** Whether the drone's own sensors detect that wind pushes it. */
  public boolean pushed() {
    return pushed;
  }

  /** Whether the drone's feet point down. */
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

  /** Returns the lights of the extension board. They are dark if the drone has no board. */
  public BoardLights lights() {
    return lights;
  }

  /**
   * A model of the drone's temperature. The drone warms up while its motors are off, and its
   * propellers cool it.
   *
   * <p>Measured (xg590/Tello-Python, pgminin/tello-vision-telemetry-lab): 43 °C at power-on, and 80
   * to 90 °C after minutes on the ground. After takeoff, the temperature falls by about 11 K in 20
   * s, and then stays at 62 to 77 °C.
   */
  private static final class Temperature {

    /** Temperature at power-on [°C]. */
    static final double COLD = 43;

    private static final double IDLE_LIMIT = 88;
    private static final double IDLE_TIME_CONSTANT = 120;
    private static final double FLYING_LIMIT = 68;
    private static final double FLYING_TIME_CONSTANT = 36;

    private Temperature() {}

    static double after(double celsius, boolean motorsOn, double seconds) {
      double limit = motorsOn ? FLYING_LIMIT : IDLE_LIMIT;
      double timeConstant = motorsOn ? FLYING_TIME_CONSTANT : IDLE_TIME_CONSTANT;
      return celsius + (limit - celsius) * seconds / timeConstant;
    }
  }
}
