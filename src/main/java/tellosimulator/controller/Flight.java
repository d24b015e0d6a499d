package tellosimulator.controller;

import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.command.Reply;
import tellosimulator.command.Responder;
import tellosimulator.command.Sticks;
import tellosimulator.controller.FlightEvent.Crashed;
import tellosimulator.controller.FlightEvent.Dropped;
import tellosimulator.controller.FlightEvent.Fell;
import tellosimulator.controller.FlightEvent.Landed;
import tellosimulator.controller.FlightEvent.LandingCanceled;
import tellosimulator.controller.FlightEvent.LandsByItself;
import tellosimulator.controller.FlightEvent.TookOff;
import tellosimulator.math.Vec3;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneModel;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.FlightPhase;
import tellosimulator.physics.Setpoint;
import tellosimulator.profile.Behavior;
import tellosimulator.time.Demand;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;
import tellosimulator.world.Collision;

/**
 * What one drone is doing in the air, from one maneuver to the next, and who waits for it: takeoff,
 * landing, crash, and the landings that nobody commanded. For the simulation thread.
 */
final class Flight {

  /** Silence after which it lands by itself [s]. Documented: SDK 2.0 User Guide. */
  private static final double SILENCE = 15;

  /** Below this speed there is nothing to brake from [m/s]. Decided: it counts as balanced out. */
  static final double STILL = 0.05;

  /** How exactly a drone hovers at the height of which a fall is told [m]. Decided. */
  private static final double ON_TARGET = 0.01;

  private static final double STEP = SimTime.STEP;

  private final DroneModel model;
  private final Behavior behavior;
  private final FlightObserver observer;
  private final RcSteering rc;
  private final Autopilot autopilot;
  private final ForcedStop forcedStop = new ForcedStop();
  private SimTime now = SimTime.ZERO;
  private SimTime lastContact = SimTime.ZERO;
  private CompletionHandler handler = CompletionHandler.NOBODY;
  private final Contacts contacts;
  private boolean landingForSilence;
  private boolean landingForBattery;

  /** Why it came down by itself, until it flies again. */
  private Optional<Phrase> loneLanding = Optional.empty();

  private boolean stands;
  private final double crashSpeed;
  private final boolean landsWhenSilent;

  /** Height at which the motors stopped in flight [m], while it falls. */
  private OptionalDouble fallFrom = OptionalDouble.empty();

  Flight(ControllerContext context) {
    this.model = context.model();
    this.behavior = context.behavior();
    this.observer = context.observer();
    this.crashSpeed = context.crashSpeed();
    this.landsWhenSilent = context.landsWhenSilent();
    this.rc = new RcSteering(behavior);
    this.autopilot = new Autopilot(behavior, rc);
    this.contacts = new Contacts(observer, crashSpeed);
  }

  // --- what others ask ---

  boolean flying() {
    return model.phase().flying();
  }

  /** Whether it is in the air, carried by its motors. */
  boolean airborne() {
    boolean down = autopilot.maneuver() instanceof Landing landing && landing.down();
    return flying() && !model.resting() && !down;
  }

  /** Whether it comes down because somebody said so, and that somebody waits. */
  boolean landsOnCommand() {
    return landing() && handler != CompletionHandler.NOBODY;
  }

  boolean landsForBattery() {
    return landingForBattery;
  }

  /** Why it stands, and what to do. */
  Phrase notFlying() {
    Vec3 place = model.motion().position();
    return loneLanding
        .map(
            reason ->
                Phrase.of(
                    "the drone landed by itself at x %.0f, y %.0f (%s), send `takeoff` first",
                    place.x() * 100, place.y() * 100, reason))
        .orElse(Phrase.of("the drone does not fly, send `takeoff` first"));
  }

  /** What runs and how far it is; empty if nobody waits for anything. */
  Optional<Phrase> running() {
    return handler == CompletionHandler.NOBODY
        ? Optional.empty()
        : Optional.of(
            Phrase.of(
                "`%s` is still running, %s", handler.text(), autopilot.maneuver().progress()));
  }

  /** Whether somebody waits for the answer to a command. */
  boolean answers() {
    return handler != CompletionHandler.NOBODY;
  }

  /** Why time must pass for it; sticks that are out of the centre steer without end. */
  Demand demand() {
    boolean steered = flying() && (!rc.sticks().centered() || autopilot.drifts());
    boolean settled = (steered || rc.atRest()) && autopilot.maneuver().atRest();
    boolean falls = !flying() && !model.resting();
    if (answers() || (flying() && !settled) || falls || forcedStop.pending()) {
      return Demand.DEBT;
    }
    return steered ? Demand.MOTION : Demand.NONE;
  }

  Setpoint setpoint() {
    return autopilot.setpoint();
  }

  Vec3 basePosition() {
    return autopilot.basePosition(model.motion());
  }

  double baseHeading() {
    return autopilot.baseHeading(model.motion());
  }

  // --- what commands do ---

  void contact() {
    lastContact = now;
  }

  /** A command arrived: a safety landing ends, the drone hovers. */
  void cancelSafetyLanding() {
    if (landingForSilence) {
      observer.happened(new LandingCanceled());
      hover();
    }
  }

  void steer(Sticks sticks) {
    rc.set(sticks, now);
  }

  void fly(Maneuver maneuver, CompletionHandler newHandler) {
    landingForSilence = false;
    landingForBattery = false;
    loneLanding = Optional.empty();
    handler = newHandler;
    model.setPhase(FlightPhase.FLYING);
    autopilot.fly(maneuver);
  }

  /**
   * Starts the motors and climbs.
   *
   * @param height above where it stands [m]
   */
  void takeoff(double height, CompletionHandler newHandler) {
    fly(new Takeoff(model.motion().position(), baseHeading(), height, behavior), newHandler);
    model.countTakeoff();
    model.setPhase(FlightPhase.TAKING_OFF);
    stands = true;
  }

  void land(CompletionHandler newHandler) {
    fly(new Landing(basePosition(), baseHeading(), behavior), newHandler);
    model.setPhase(FlightPhase.LANDING);
  }

  /** Lands it, unless it stands or lands already; a caller that waits gets no answer. */
  void landByItself(Phrase reason) {
    if (flying() && !landing()) {
      land(CompletionHandler.NOBODY);
      observer.happened(new LandsByItself(reason, false));
    }
  }

  /** Brakes and stays. */
  void hover() {
    Vec3 steered = rc.velocity().turned(model.motion().attitude().heading());
    Vec3 own = model.motion().velocity().minus(steered);
    boolean still = own.norm() < STILL;
    fly(
        still
            ? new Hover(basePosition(), Vec3.ZERO, baseHeading())
            : new Hover(model.motion().position(), own, baseHeading()),
        CompletionHandler.NOBODY);
  }

  /** Centres the sticks, brakes, and answers the second time when it stands still. */
  void stop(Responder responder) {
    rc.set(Sticks.CENTERED, now);
    hover();
    forcedStop.expect(responder, now);
  }

  /** Cuts off what runs, with an answer. */
  void interrupt(Reply reply, Phrase reason) {
    CompletionHandler interrupted = handler;
    handler = CompletionHandler.NOBODY;
    interrupted.failed(reply, reason);
  }

  /** Stops the motors, whatever the drone is doing; nobody is answered. */
  void motorsOff(FlightPhase phase) {
    if (flying()) {
      fallFrom = OptionalDouble.of(model.motion().position().z());
    }
    handler = CompletionHandler.NOBODY;
    landingForSilence = false;
    landingForBattery = false;
    forcedStop.forget();
    autopilot.park();
    model.setPhase(phase);
  }

  /** Forgets everything, as reset and power-off do. */
  void reset() {
    boolean powered = model.phase() != FlightPhase.OFF;
    motorsOff(powered ? FlightPhase.GROUNDED : FlightPhase.OFF);
    rc.center();
    contacts.forget();
    loneLanding = Optional.empty();
    lastContact = now;
  }

  // --- what happens in a step ---

  /** How it drifts from now on, whatever it does, room frame [m/s]. */
  void drift(Vec3 velocity) {
    autopilot.drift(airborne() ? velocity : Vec3.ZERO);
  }

  /** Sets the targets of the step that ends at {@code time}. */
  void plan(SimTime time) {
    now = time;
    if (model.resting()) {
      fallFrom = OptionalDouble.empty();
    }
    if (airborne()) {
      rc.follow(now, STEP);
    } else {
      rc.hold(now);
    }
    autopilot.steer(model.motion(), contacts.onGround(), STEP);
    contacts.next(now);
  }

  /** Something stopped the drone. */
  void touch(Collision collision) {
    contacts.add(collision, flying());
    double fallen = fallen(collision);
    if (tooHard(collision, fallen)) {
      crash(collision, fallen);
    } else if (fallen > 0) {
      observer.happened(new Dropped(collision.touched(), collision.speed(), fallen));
    }
    if (!flying() && collision.onGround()) {
      comeToRest();
    }
  }

  /** Ends what has come to its end. */
  void finish() {
    if (stands && airborne()) {
      stands = false;
      observer.happened(new TookOff());
    }
    if (flying()) {
      contacts.part(model.motion().position());
      Vec3 normal = contacts.obstacle().map(Collision::normal).orElse(Vec3.ZERO);
      autopilot.observe(model.motion(), normal, model.pushed());
      switch (autopilot.outcome()) {
        case ARRIVED -> arrived();
        case HELD -> gaveUp(Reply.ERROR, Phrase.of("it was blocked by %s for 1 s", obstacle()));
        case RESTLESS -> gaveUp(Reply.ERROR, Phrase.of("it did not come to rest"));
        case LOST -> gaveUp(Reply.RUN_TIMEOUT, autopilot.maneuver().lost().orElseThrow());
        case RUNNING -> {}
      }
    }
    forcedStop.report(
        now, model.motion(), handler == CompletionHandler.NOBODY && rc.sticks().centered());
  }

  /** Lands if the battery or a silent operator asks for it. */
  void watchOver() {
    if (model.phase() == FlightPhase.IDLING && model.battery().empty()) {
      model.setPhase(FlightPhase.GROUNDED);
    }
    if (handler != CompletionHandler.NOBODY) {
      lastContact = now;
    }
    if (!flying()) {
      return;
    }
    if (model.battery().empty()) {
      Phrase reason = Phrase.of("the battery is empty");
      interrupt(Reply.MOTOR_STOP, reason);
      motorsOff(FlightPhase.FALLING);
      observer.happened(new Fell(reason));
    } else if (model.battery().percent() <= Battery.LANDS_BY_ITSELF && !landing()) {
      Phrase reason = Phrase.of("the battery is at %d %%", model.battery().percent());
      interrupt(Reply.AUTO_LAND, reason);
      land(CompletionHandler.NOBODY);
      landingForBattery = true;
      loneLanding = Optional.of(reason);
      observer.happened(new LandsByItself(reason, false));
    } else if (landsWhenSilent && now.since(lastContact) >= SILENCE && !landing()) {
      Phrase reason = Phrase.of("no command came for %.0f s", SILENCE);
      land(CompletionHandler.NOBODY);
      landingForSilence = true;
      loneLanding = Optional.of(reason);
      observer.happened(new LandsByItself(reason, true));
    }
  }

  private boolean landing() {
    return model.phase() == FlightPhase.LANDING;
  }

  private Phrase obstacle() {
    return contacts
        .obstacle()
        .map(collision -> collision.touched().phrase())
        .orElse(Phrase.of("something"));
  }

  private void arrived() {
    CompletionHandler finished = handler;
    if (landing()) {
      motorsOff(FlightPhase.GROUNDED);
      comeToRest();
      contacts.partFromAll();
      observer.happened(new Landed(contacts.ground()));
    } else {
      hover();
    }
    finished.done();
  }

  /** The maneuver ends here, with an answer. */
  void gaveUp(Reply reply, Phrase reason) {
    CompletionHandler failed = handler;
    hover();
    failed.failed(reply, reason);
  }

  /** How deep it has fallen onto what carries it now [m]; 0 if it did not fall. */
  private double fallen(Collision collision) {
    boolean landed = !flying() && collision.onGround() && fallFrom.isPresent();
    return landed ? Math.max(0, fallFrom.getAsDouble() - collision.position().z()) : 0;
  }

  private boolean tooHard(Collision collision, double fallen) {
    boolean stands = !flying() && collision.onGround();
    return model.phase() != FlightPhase.CRASHED
        && collision.speed() > crashSpeed
        && (!stands || fallen > DroneSpec.HARMLESS_FALL + ON_TARGET);
  }

  private void crash(Collision collision, double fallen) {
    Crashed crashed =
        new Crashed(collision.touched(), collision.speed(), fallen, collision.position());
    interrupt(Reply.MOTOR_STOP, Phrase.of("the drone %s", crashed.phrase()));
    boolean powered = model.phase() != FlightPhase.OFF;
    motorsOff(powered ? FlightPhase.CRASHED : FlightPhase.OFF);
    fallFrom = OptionalDouble.empty();
    contacts.forget();
    observer.happened(crashed);
  }

  private void comeToRest() {
    model.rest();
    if (model.phase() == FlightPhase.FALLING) {
      model.setPhase(FlightPhase.GROUNDED);
    }
  }
}
