package tellosimulator.controller;

import java.util.Optional;
import java.util.function.Supplier;
import tellosimulator.command.Reply;
import tellosimulator.controller.FlightEvent.Fell;
import tellosimulator.controller.FlightEvent.LandsByItself;
import tellosimulator.controller.Preflight.Objection;
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

/** The effects of faults on a drone and its flight. For one drone and the simulation thread. */
final class FaultEffects {

  /** How long it drifts one way [s]. Assumed. */
  private static final double DRIFT_PERIOD = 2;

  private final DroneModel model;
  private final Flight flight;
  private final FlightObserver observer;
  private final Supplier<ActiveFaults> faults;
  private final SeededNoise noise;
  private boolean restarted;

  /** When the last {@code rc} or {@code ok} was. */
  private Optional<SimTime> provoked = Optional.empty();

  private long moves;

  /** How long it has flown in the dark [s]. */
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

  /** Why it does not take off; empty if no fault keeps it. */
  Optional<Objection> objectionToTakeoff() {
    return acting(FaultKind.SENSOR_ERROR)
        .map(fault -> new Objection(Reply.ERROR, cause(fault)))
        .or(
            () ->
                acting(FaultKind.OVERHEAT)
                    .map(fault -> new Objection(Reply.HIGH_TEMPERATURE, cause(fault))));
  }

  /** Why it does not move; empty if no fault keeps it. */
  Optional<Objection> objectionToMove() {
    return lost().map(fault -> new Objection(Reply.NO_VALID_IMU, cause(fault)));
  }

  /** Why it takes no move now; empty if no fault keeps it. Draws once for each move. */
  Optional<Objection> objectionToNewMove(SimTime now) {
    return objectionToMove()
        .or(
            () ->
                acting(FaultKind.NOT_JOYSTICK)
                    .filter(fault -> refusesMove(fault, now))
                    .map(fault -> new Objection(Reply.NOT_JOYSTICK, cause(fault))));
  }

  private boolean refusesMove(Fault fault, SimTime now) {
    boolean soon =
        provoked.isPresent() && now.since(provoked.get()) <= fault.value(FaultParameter.TIME);
    return soon
        && noise.between(0, 1, SeededNoise.Channel.REFUSED_MOVE, moves++)
            < fault.value(FaultParameter.SHARE);
  }

  /** It was steered, or has said {@code ok}. */
  void provoke(SimTime now) {
    provoked = Optional.of(now);
  }

  /** Why it carries out nothing but {@code command}; empty if it does. */
  Optional<Phrase> unactivated() {
    return acting(FaultKind.UNACTIVATED).map(FaultEffects::cause);
  }

  /** How high a takeoff gets, if that is less than usual [m]. */
  double takeoffHeight(double usual) {
    return acting(FaultKind.WEAK_TAKEOFF)
        .map(fault -> Math.min(usual, fault.value(FaultParameter.HEIGHT)))
        .orElse(usual);
  }

  /** How it drifts, room frame [m/s]. */
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
   * Lets faults do what they do at the end of a step.
   *
   * @param restart to switch itself off and on again
   */
  void advance(SimTime now, Restart restart) {
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
        .ifPresent(fault -> flight.landByItself(cause(fault)));
    if (model.phase() == FlightPhase.FLYING && flight.answers()) {
      objectionToMove()
          .ifPresent(objection -> flight.gaveUp(objection.reply(), objection.reason()));
    }
  }

  /** Once for each time that the fault begins. */
  private void restart(SimTime now, Restart restart) {
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
      flight.interrupt(Reply.AUTO_LAND, reason);
      flight.land(CompletionHandler.NOBODY);
      observer.happened(new LandsByItself(reason, false));
    }
  }

  private void stopMotors(Fault fault) {
    Phrase reason = cause(fault);
    flight.interrupt(Reply.MOTOR_STOP, reason);
    flight.motorsOff(FlightPhase.FALLING);
    observer.happened(new Fell(reason));
  }

  /** What it does not know its place by. */
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
