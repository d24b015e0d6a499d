package tellosimulator.controller;

import java.util.Optional;
import tellosimulator.controller.FlightEvent.Fell;
import tellosimulator.controller.FlightEvent.Note;
import tellosimulator.controller.FlightEvent.PutBack;
import tellosimulator.math.Arc;
import tellosimulator.math.Vec3;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneModel;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.FlightPhase;
import tellosimulator.physics.Setpoint;
import tellosimulator.time.PendingWork;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;
import tellosimulator.world.Collision;

/**
 * Carries out orders to one drone, regardless of the protocol through which they arrived. Checks
 * whether an order is possible, and leaves flights to {@code Flight}. Confined to the simulation
 * thread.
 */
public final class DroneController {

  private final ControllerContext context;
  private final DroneModel model;
  private final FlightObserver observer;
  private final Flight flight;
  private final FaultEffects faultEffects;
  private final Reboot restart = new Reboot();
  private final PathPlanner planner;
  private final PadMissions padMissions;
  private final Equipment equipment;
  private SimTime now = SimTime.ZERO;
  private double speed = DroneSpec.DEFAULT_SPEED;

  public DroneController(ControllerContext context) {
    this.context = context;
    this.model = context.model();
    this.observer = context.observer();
    this.flight = new Flight(context);
    this.faultEffects = new FaultEffects(context, flight);
    this.planner = new PathPlanner(context, flight);
    this.padMissions = new PadMissions(model, flight, planner);
    this.equipment = new Equipment(model, context.profile());
  }

  // --- called by the simulation in a step ---

  /** Sets the targets of the step that ends at {@code time}. */
  public void plan(SimTime time) {
    now = time;
    if (model.phase() != FlightPhase.OFF) {
      flight.drift(faultEffects.drift(time));
      flight.plan(time);
    }
  }

  /** Returns the setpoint of the motors for this step. */
  public Setpoint setpoint() {
    return flight.setpoint();
  }

  /** Handles a collision that stopped the drone. */
  public void touch(Collision collision) {
    flight.touch(collision);
  }

  /** Completes the order whose maneuver has ended, if any. */
  public void finish() {
    flight.finish();
  }

  /** Checks whether the drone must land or restart, and applies the effects of faults. */
  public void watchOver() {
    faultEffects.advance(now, restart);
    flight.watchOver();
    restart.advance(now, this::powerOff, this::powerOn);
  }

  /**
   * Records that the drone has replied {@code ok}. The fault {@code not-joystick} depends on the
   * time of the last reply.
   */
  public void saidOk() {
    faultEffects.provoke(now);
  }

  /** Whether a client is waiting for the reply to a command. */
  public boolean answers() {
    return flight.answers();
  }

  /** Returns the reason why simulated time must pass for this drone. */
  public PendingWork demand() {
    return restart.pending() ? PendingWork.REPLY : flight.demand();
  }

  // --- controls ---

  public void powerOn() {
    if (model.phase() == FlightPhase.OFF) {
      flight.reset();
      model.powerOn(now);
      restart.forget();
      observer.happened(new Note(Phrase.of("is on and waits for commands")));
    }
  }

  /** Switches the drone off. An airborne drone falls. */
  public void powerOff() {
    restart.forget();
    if (model.phase() == FlightPhase.OFF) {
      return;
    }
    if (flight.airborne()) {
      observer.happened(new Fell(Phrase.of("it was switched off")));
    }
    flight.reset();
    speed = DroneSpec.DEFAULT_SPEED;
    model.powerOff();
    context.sessionEnded().run();
    observer.happened(new Note(Phrase.of("is off")));
  }

  /** Puts the drone back at its start, as if newly placed there. */
  public void reset() {
    flight.reset();
    model.reset();
    speed = DroneSpec.DEFAULT_SPEED;
    observer.happened(new PutBack());
  }

  /**
   * Lands the drone because its program has ended, unless it is already on the ground or landing. A
   * client that is waiting gets no reply.
   */
  public void landAtEndOfProgram() {
    flight.landByItself(
        Phrase.of("the program has ended"), FlightEvent.LandingCause.END_OF_PROGRAM);
  }

  /**
   * Stops the video, and ends the session that the protocols share. The drone continues its flight
   * until the safety landing.
   */
  public void endSession() {
    model.setVideo(model.video().stopped());
    context.sessionEnded().run();
  }

  // --- queries by protocols ---

  /**
   * Returns the order that is being carried out, with its progress; empty if no sender is waiting
   * for an order to complete.
   */
  public Optional<Phrase> running() {
    return flight.running();
  }

  /** Returns the reason why the drone carries out no orders; empty if it carries them out. */
  public Optional<Phrase> unactivated() {
    return faultEffects.unactivated();
  }

  /** Returns why a fault prevents a takeoff; empty if none does. */
  public Optional<RefusalKind> objectionToTakeoff() {
    return faultEffects.objectionToTakeoff().map(Result.Refused::kind);
  }

  /** Returns the simulated time at the end of the last step. */
  public SimTime now() {
    return now;
  }

  public boolean flying() {
    return flight.flying();
  }

  /** Whether the drone is in the air with its motors running. */
  public boolean airborne() {
    return flight.airborne();
  }

  /** Returns the reason why the drone is not flying, and what to do about it. */
  public Phrase notFlying() {
    return Preflight.check(model).map(Result.Refused::reason).orElseGet(flight::notFlying);
  }

  /** Returns the speed of moves that specify none [m/s]. */
  public double speed() {
    return speed;
  }

  // --- notifications by protocols ---

  /** Called when a host that may operate the drone sends anything. Defers the safety landing. */
  public void linkAlive() {
    flight.contact();
  }

  /** Called when a known order arrives. Ends a safety landing. */
  public void commandArrived() {
    flight.cancelSafetyLanding();
  }

  // --- orders ---

  public Result takeoff() {
    Optional<Result.Refused> objection =
        Preflight.check(model).or(faultEffects::objectionToTakeoff);
    if (objection.isPresent()) {
      return objection.get();
    }
    double height = faultEffects.takeoffHeight(context.behavior().takeoffHeight());
    return new Result.Running(flight.takeoff(height));
  }

  public Result land() {
    if (flight.landsOnCommand()) {
      return new Result.Refused(RefusalKind.BUSY, running().orElseThrow());
    }
    flight.interrupt(RefusalKind.LANDING, Phrase.of("it was interrupted by `land`"));
    return new Result.Running(flight.land());
  }

  /** Brakes. The order is complete when the drone has come to rest. */
  public Result stop() {
    if (!flight.airborne()) {
      return new Result.Refused(RefusalKind.GENERAL, Phrase.of("the drone does not fly"));
    }
    Optional<Result> refusal = refusalForBattery();
    return refusal.isPresent() ? refusal.get() : new Result.Running(flight.stop());
  }

  /** Stops the motors at once. */
  public void emergency() {
    if (model.phase() == FlightPhase.IDLING) {
      model.setPhase(FlightPhase.GROUNDED);
    }
    if (flight.flying() && model.resting()) {
      flight.motorsOff(FlightPhase.GROUNDED);
    } else if (flight.flying()) {
      flight.motorsOff(FlightPhase.FALLING);
      observer.happened(new Fell(Phrase.of("`emergency` stopped its motors")));
    }
  }

  /**
   * Flies straight along an axis of the level body frame.
   *
   * @param distance the distance [m]
   */
  public Result move(Direction direction, double distance) {
    boolean stoppedShort =
        direction == Direction.DOWN
            && flight.basePosition().z() - distance < context.behavior().lowestHover();
    Vec3 way = direction.unit().times(distance);
    return refusal()
        .orElseGet(
            () ->
                stoppedShort && !context.behavior().answersLowDown()
                    ? inVain(planner.by(way, speed))
                    : running(planner.by(way, speed)));
  }

  /** Flies a maneuver, and returns a result that never completes. */
  private Result inVain(Maneuver maneuver) {
    observer.happened(
        new Note(Phrase.of("stops above the floor and never reports that it has arrived")));
    flight.fly(maneuver, Completion.NONE);
    return new Result.Running(new Completion());
  }

  /**
   * Flies straight.
   *
   * @param way the displacement in the level body frame [m]
   * @param metersPerSecond the speed [m/s]
   */
  public Result go(Vec3 way, double metersPerSecond) {
    return refusal().orElseGet(() -> running(planner.by(way, metersPerSecond)));
  }

  /**
   * Flies along an arc.
   *
   * @param arc the arc relative to the current position, in the level body frame [m]
   * @param metersPerSecond the speed [m/s]
   */
  public Result curve(Arc arc, double metersPerSecond) {
    return refusal()
        .orElseGet(() -> running(planner.along(arc, metersPerSecond, flight.baseHeading())));
  }

  /**
   * Turns on the spot.
   *
   * @param angle the angle, counter-clockwise seen from above [rad]; can exceed a full turn
   */
  public Result turn(double angle) {
    return refusal().orElseGet(() -> running(planner.turn(angle)));
  }

  /** Flips in a direction other than up or down. */
  public Result flip(Direction direction) {
    int percent = model.battery().percent();
    Optional<Result> refusal = refusal();
    if (refusal.isPresent()) {
      return refusal.get();
    }
    if (percent < Battery.LEAST_FOR_FLIP) {
      return new Result.Refused(
          RefusalKind.GENERAL,
          Phrase.of(
              "the battery is at %d %%, a flip needs at least %d %%",
              percent, Battery.LEAST_FOR_FLIP));
    }
    return running(
        new Flip(flight.basePosition(), flight.baseHeading(), direction.unit(), planner.miss()));
  }

  /**
   * Flies to a point over a mission pad.
   *
   * @param goal the goal in the pad's frame [m]
   * @param metersPerSecond the speed [m/s]
   */
  public Result goToPad(Vec3 goal, double metersPerSecond, PadChoice pad) {
    return refusal().orElseGet(() -> padMissions.go(goal, metersPerSecond, pad));
  }

  /**
   * Flies an arc over a mission pad.
   *
   * @param via the first point of the arc in the pad's frame [m]
   * @param end the second point of the arc in the pad's frame [m]
   * @param metersPerSecond the speed [m/s]
   */
  public Result curveOverPad(Vec3 via, Vec3 end, double metersPerSecond, PadChoice pad) {
    return refusal().orElseGet(() -> padMissions.curve(via, end, metersPerSecond, pad));
  }

  /**
   * Flies from one mission pad to another.
   *
   * @param goal the goal in the first pad's frame [m]
   * @param metersPerSecond the speed [m/s]
   * @param heading the heading at the end, in the second pad's frame, counter-clockwise [rad]
   */
  public Result jump(
      Vec3 goal, double metersPerSecond, PadChoice first, double heading, PadChoice second) {
    return refusal()
        .orElseGet(() -> padMissions.jump(goal, metersPerSecond, first, heading, second));
  }

  /** Sets the speed of moves that specify none [m/s]. */
  public Result setSpeed(double metersPerSecond) {
    speed = metersPerSecond;
    return Result.DONE;
  }

  /** Sets the sticks. */
  public void steer(Sticks sticks) {
    flight.steer(sticks);
    faultEffects.provoke(now);
  }

  /** Starts or stops the motors of a drone on the ground. */
  public Result spinMotors(boolean on) {
    FlightPhase wanted = on ? FlightPhase.IDLING : FlightPhase.GROUNDED;
    boolean standing = model.phase() == FlightPhase.GROUNDED || model.phase() == FlightPhase.IDLING;
    if (standing && model.upright()) {
      model.setPhase(wanted);
      return Result.DONE;
    }
    return new Result.Refused(
        RefusalKind.GENERAL, Phrase.of("the drone does not stand on the ground"));
  }

  /**
   * Switches the drone off and on again, either at once or after the delay that the drone
   * announces.
   */
  public void reboot(boolean announced) {
    restart.schedule(now, announced ? Reboot.NOTICE : 0);
  }

  public Equipment equipment() {
    return equipment;
  }

  private Result running(Maneuver maneuver) {
    return new Result.Running(flight.fly(maneuver));
  }

  /** Returns the reason why no maneuver can begin now; empty if one can. */
  private Optional<Result> refusal() {
    return refusalForBattery().or(() -> faultEffects.objectionToNewMove(now).map(found -> found));
  }

  private Optional<Result> refusalForBattery() {
    return flight.landsForBattery()
        ? Optional.of(
            new Result.Refused(
                RefusalKind.LANDING, Phrase.of("the drone lands because of its battery")))
        : Optional.empty();
  }
}
