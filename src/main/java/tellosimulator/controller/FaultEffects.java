package tellosimulator.controller;

import java.util.Optional;
import java.util.function.Supplier;
import tellosimulator.controller.FlightEvent.Fell;
import tellosimulator.controller.FlightEvent.LandingCause;
import tellosimulator.controller.FlightEvent.LandsByItself;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.FaultParameter;
import tellosimulator.math.Vec3;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneModel;
import tellosimulator.model.FlightPhase;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * Applies faults to a drone and its flight. One instance per drone, confined to the simulation
 * thread.
 */
final class FaultEffects {

  /** Time between changes of the drift's direction [s]. Assumed. */
  private static final double DRIFT_PERIOD = 2;

  private final DroneModel model;
  private final Flight flight;
  private final FlightObserver observer;
  private final Supplier<ActiveFaults> faults;
  private final SeededNoise noise;
  private boolean restarted;

  /** Time of the last {@code rc} or {@code ok}. */
  private Optional<SimTime> provoked = Optional.empty();

  private long moves;

  /** Duration of the flight in the dark so far [s]. */
  private double dark;

  FaultEffects(ControllerContext context, Flight flight) {
    this.model = context.model();
    this.observer = context.observer();
    this.faults = context.faults();
    this.noise = context.noise();
    this.flight = flight;
  }

  private boolean none() {
    return faults.get().faults().isEmpty();
  }

  /** Returns the reason why the drone cannot take off; empty if no fault prevents a takeoff. */
  Optional<Result.Refused> objectionToTakeoff() {
    return acting(FaultKind.SENSOR_ERROR)
        .map(fault -> new Result.Refused(RefusalKind.GENERAL, cause(fault)))
        .or(
            () ->
                acting(FaultKind.OVERHEAT)
                    .map(fault -> new Result.Refused(RefusalKind.OVERHEATED, cause(fault))));
  }

  /** Returns the reason why the drone cannot move; empty if no fault prevents moves. */
  Optional<Result.Refused> objectionToMove() {
    return lost().map(fault -> new Result.Refused(RefusalKind.POSITION_UNKNOWN, cause(fault)));
  }

  /**
   * Returns the reason why the drone cannot begin a move now; empty if no fault prevents the move.
   * Draws a random number for each move that the fault {@code not-joystick} may refuse.
   */
  Optional<Result.Refused> objectionToNewMove(SimTime now) {
    return objectionToMove()
        .or(
            () ->
                acting(FaultKind.NOT_JOYSTICK)
                    .filter(fault -> refusesMove(fault, now))
                    .map(fault -> new Result.Refused(RefusalKind.BUSY, cause(fault))));
  }

  private boolean refusesMove(Fault fault, SimTime now) {
    boolean soon =
        provoked.isPresent() && now.since(provoked.get()) <= fault.value(FaultParameter.TIME);
    return soon
        && noise.between(0, 1, SeededNoise.Channel.REFUSED_MOVE, moves++)
            < fault.value(FaultParameter.SHARE);
  }

  /** Records that the drone has been steered, or has replied {@code ok}. */
  void provoke(SimTime now) {
    provoked = Optional.of(now);
  }

  /**
   * Returns the reason why the drone refuses all commands except {@code command}; empty if it does
   * not refuse them.
   */
  Optional<Phrase> unactivated() {
    return acting(FaultKind.UNACTIVATED).map(FaultEffects::cause);
  }

  /** Returns the height of a takeoff [m]. A fault can reduce the usual height. */
  double takeoffHeight(double usual) {
    return acting(FaultKind.WEAK_TAKEOFF)
        .map(fault -> Math.min(usual, fault.value(FaultParameter.HEIGHT)))
        .orElse(usual);
  }

  /** Returns the drift velocity, in the room frame [m/s]. */
  Vec3 drift(SimTime now) {
    if (none()) {
      return Vec3.ZERO;
    }
    double speed =
        acting(FaultKind.NO_VALID_IMU)
            .or(() -> acting(FaultKind.DARK))
            .map(fault -> fault.value(FaultParameter.SPEED))
            .orElse(0.0);
    long part = (long) (now.seconds() / DRIFT_PERIOD);
    double heading = noise.between(-Math.PI, Math.PI, SeededNoise.Channel.DRIFT, part);
    return new Vec3(StrictMath.cos(heading) * speed, StrictMath.sin(heading) * speed, 0);
  }

  /**
   * Applies the effects of faults at the end of a step.
   *
   * @param restart restarts the drone if a fault requires it
   */
  void advance(SimTime now, Reboot restart) {
    if (none()) {
      restarted = false;
      dark = 0;
      return;
    }
    restart(now, restart);
    dark = acting(FaultKind.DARK).isPresent() && flight.airborne() ? dark + SimTime.STEP : 0;
    acting(FaultKind.YAW_DRIFT)
        .ifPresent(
            fault ->
                model.turnReference(
                    StrictMath.toRadians(fault.value(FaultParameter.TURN)) * SimTime.STEP));
    acting(FaultKind.LOW_BATTERY).ifPresent(this::drain);
    acting(FaultKind.OVERHEAT).ifPresent(this::overheat);
    acting(FaultKind.MOTOR_STOP).filter(fault -> flight.airborne()).ifPresent(this::stopMotors);
    acting(FaultKind.SILENT_LAND)
        .filter(fault -> flight.airborne())
        .ifPresent(fault -> flight.landByItself(cause(fault), LandingCause.FAULT));
    if (model.phase() == FlightPhase.FLYING && flight.answers()) {
      objectionToMove().ifPresent(objection -> flight.gaveUp(objection.kind(), objection.reason()));
    }
  }

  /** Restarts the drone once each time the reboot fault begins. */
  private void restart(SimTime now, Reboot restart) {
    boolean wanted = acting(FaultKind.REBOOT).isPresent();
    if (wanted && !restarted && model.phase() != FlightPhase.OFF) {
      restart.schedule(now, 0);
    }
    restarted = wanted;
  }

  private void drain(Fault fault) {
    double level = fault.value(FaultParameter.LEVEL);
    if (model.battery().level() > level) {
      model.setBattery(new Battery(level));
    }
  }

  private void overheat(Fault fault) {
    model.heat(fault.value(FaultParameter.HEAT));
    if (flight.airborne() && model.phase() != FlightPhase.LANDING) {
      Phrase reason = cause(fault);
      flight.interrupt(RefusalKind.LANDING, reason);
      flight.land(Completion.NONE);
      observer.happened(new LandsByItself(reason, LandingCause.FAULT));
    }
  }

  private void stopMotors(Fault fault) {
    Phrase reason = cause(fault);
    flight.interrupt(RefusalKind.MOTORS_OFF, reason);
    flight.motorsOff(FlightPhase.FALLING);
    observer.happened(new Fell(reason));
  }

  /** Returns the fault that made the drone lose its position, if any. */
  private Optional<Fault> lost() {
    return acting(FaultKind.NO_VALID_IMU)
        .or(
            () ->
                acting(FaultKind.DARK)
                    .filter(fault -> dark > 0 && dark >= fault.value(FaultParameter.TIME)));
  }

  private Optional<Fault> acting(FaultKind kind) {
    return none() ? Optional.empty() : faults.get().find(kind);
  }

  private static Phrase cause(Fault fault) {
    return Phrase.of("the fault %s acts", fault.text());
  }
}
