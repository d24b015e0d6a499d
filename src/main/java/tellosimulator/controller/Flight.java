package tellosimulator.controller;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.controller.FlightEvent.Crashed;
import tellosimulator.controller.FlightEvent.Dropped;
import tellosimulator.controller.FlightEvent.Fell;
import tellosimulator.controller.FlightEvent.Landed;
import tellosimulator.controller.FlightEvent.LandingCanceled;
import tellosimulator.controller.FlightEvent.LandingCause;
import tellosimulator.controller.FlightEvent.LandsByItself;
import tellosimulator.controller.FlightEvent.TookOff;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneModel;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;
import tellosimulator.physics.Setpoint;
import tellosimulator.profile.Behavior;
import tellosimulator.time.PendingWork;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;
import tellosimulator.world.Collision;

/**
 * The flight of one drone: a sequence of maneuvers, each with the completion of the order that it
 * carries out. Handles takeoffs, landings (with and without a command) and crashes. Confined to the
 * simulation thread.
 */
final class Flight {

  /**
   * Time without commands after which the drone lands automatically [s]. Documented: SDK 2.0 User
   * Guide.
   */
  private static final double SILENCE = 15;

  /**
   * Speed below which the drone does not need to brake [m/s]. Decided: the maximum speed allowed at
   * the time of {@code ok}.
   */
  static final double STILL = 0.05;

  /**
   * Amount by which a fall may exceed the depth of a harmless fall without a crash [m]. Decided:
   * the accuracy with which a drone hovers.
   */
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
  private Completion completion = Completion.NONE;
  private final Contacts contacts;
  private boolean landingForSilence;
  private boolean landingForBattery;

  /**
   * The reason for the last landing without a command; empty if another maneuver has begun since.
   */
  private Optional<Phrase> loneLanding = Optional.empty();

  private boolean stands;
  private final double crashSpeed;
  private final boolean landsWhenSilent;

  /** The height at which the motors stopped in flight [m]; empty except during a fall. */
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

  // --- queries ---

  boolean flying() {
    return model.phase().flying();
  }

  /** Whether the drone is in the air with its motors running. */
  boolean airborne() {
    boolean down = autopilot.maneuver() instanceof Landing landing && landing.down();
    return flying() && !model.resting() && !down;
  }

  /** Whether the drone is landing because of a command whose sender is waiting for the reply. */
  boolean landsOnCommand() {
    return landing() && completion != Completion.NONE;
  }

  boolean landsForBattery() {
    return landingForBattery;
  }

  /** Explains why the drone is on the ground, and what to do about it. */
  Phrase notFlying() {
    Vec3 place = model.motion().position();
    return loneLanding
        .map(
            reason ->
                Phrase.of(
                    "the drone landed by itself at x %.0f, y %.0f (%s), send `takeoff` first",
                    wholeCm(place.x()), wholeCm(place.y()), reason))
        .orElse(Phrase.of("the drone does not fly, send `takeoff` first"));
  }

  /** Converts metres to whole centimetres; never returns negative zero. */
  private static double wholeCm(double meters) {
    return Math.round(Frames.centimeters(meters));
  }

  /** Returns the running command with its progress; empty if no client is waiting for its reply. */
  Optional<Phrase> running() {
    return completion == Completion.NONE
        ? Optional.empty()
        : Optional.of(
            Phrase.of(
                "`%s` is still running, %s", completion.name(), autopilot.maneuver().progress()));
  }

  /** Whether a client is waiting for the reply to a command. */
  boolean answers() {
    return completion != Completion.NONE;
  }

  /**
   * Returns the reason why simulated time must pass. There is always a reason while the drone is
   * flying with its sticks off centre.
   */
  PendingWork demand() {
    boolean steered = flying() && (!rc.sticks().centered() || autopilot.drifts());
    boolean settled = (steered || rc.atRest()) && autopilot.maneuver().atRest();
    boolean falls = !flying() && !model.resting();
    if (answers() || (flying() && !settled) || falls || forcedStop.pending()) {
      return PendingWork.REPLY;
    }
    return steered ? PendingWork.MOTION : PendingWork.NONE;
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

  // --- called by commands ---

  void contact() {
    lastContact = now;
  }

  /** Ends a safety landing because a command arrived. The drone then hovers. */
  void cancelSafetyLanding() {
    if (landingForSilence) {
      observer.happened(new LandingCanceled());
      hover();
    }
  }

  void steer(Sticks sticks) {
    rc.set(sticks, now);
  }

  /** Begins a maneuver requested by an order. */
  Completion fly(Maneuver maneuver) {
    Completion ordered = new Completion();
    fly(maneuver, ordered);
    return ordered;
  }

  void fly(Maneuver maneuver, Completion newCompletion) {
    landingForSilence = false;
    landingForBattery = false;
    loneLanding = Optional.empty();
    completion = newCompletion;
    model.setPhase(FlightPhase.FLYING);
    autopilot.fly(maneuver);
  }

  /**
   * Starts the motors and climbs.
   *
   * @param height the height above the drone's position on the ground [m]
   */
  Completion takeoff(double height) {
    Completion ordered =
        fly(new Takeoff(model.motion().position(), baseHeading(), height, behavior));
    model.countTakeoff();
    model.setPhase(FlightPhase.TAKING_OFF);
    stands = true;
    return ordered;
  }

  /** Begins a landing requested by an order. */
  Completion land() {
    Completion ordered = new Completion();
    land(ordered);
    return ordered;
  }

  void land(Completion newCompletion) {
    fly(new Landing(basePosition(), baseHeading(), behavior), newCompletion);
    model.setPhase(FlightPhase.LANDING);
  }

  /**
   * Lands the drone, unless it is already on the ground or landing. A client that is waiting gets
   * no reply.
   */
  void landByItself(Phrase reason, LandingCause cause) {
    if (flying() && !landing()) {
      land(Completion.NONE);
      observer.happened(new LandsByItself(reason, cause));
    }
  }

  /** Brakes and hovers. */
  void hover() {
    Vec3 steered = rc.velocity().turned(model.motion().attitude().heading());
    Vec3 own = model.motion().velocity().minus(steered);
    boolean still = own.norm() < STILL;
    fly(
        still
            ? new Hover(basePosition(), Vec3.ZERO, baseHeading())
            : new Hover(model.motion().position(), own, baseHeading()),
        Completion.NONE);
  }

  /** Centres the sticks and brakes. The order is complete when the drone has come to rest. */
  Completion stop() {
    rc.set(Sticks.CENTERED, now);
    hover();
    return forcedStop.expect(now);
  }

  /** Makes the running order fail. Does not end its maneuver. */
  void interrupt(RefusalKind kind, Phrase reason) {
    Completion interrupted = completion;
    completion = Completion.NONE;
    interrupted.failed(kind, reason);
  }

  /** Stops the motors, whatever the drone is doing. No client gets a reply. */
  void motorsOff(FlightPhase phase) {
    if (flying()) {
      fallFrom = OptionalDouble.of(model.motion().position().z());
    }
    completion = Completion.NONE;
    landingForSilence = false;
    landingForBattery = false;
    forcedStop.forget();
    autopilot.park();
    model.setPhase(phase);
  }

  /** Clears all state, on a reset or power-off. */
  void reset() {
    boolean powered = model.phase() != FlightPhase.OFF;
    motorsOff(powered ? FlightPhase.GROUNDED : FlightPhase.OFF);
    rc.center();
    contacts.forget();
    loneLanding = Optional.empty();
    lastContact = now;
  }

  // --- called in a step ---

  /** Sets the drift velocity, in the room frame [m/s]. The drift acts during every maneuver. */
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

  /** Handles a collision that stopped the drone. */
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

  /** Ends the maneuver if it is over, and completes or fails its order. */
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
        case HELD ->
            gaveUp(RefusalKind.GENERAL, Phrase.of("it was blocked by %s for 1 s", obstacle()));
        case RESTLESS -> gaveUp(RefusalKind.GENERAL, Phrase.of("it did not come to rest"));
        case LOST -> gaveUp(RefusalKind.PAD_LOST, autopilot.maneuver().lost().orElseThrow());
        case RUNNING -> {}
      }
    }
    forcedStop.report(now, model.motion(), completion == Completion.NONE && rc.sticks().centered());
  }

  /** Ends the flight if the battery or the silence of the operator requires it. */
  void watchOver() {
    if (model.phase() == FlightPhase.IDLING && model.battery().empty()) {
      model.setPhase(FlightPhase.GROUNDED);
    }
    if (completion != Completion.NONE) {
      lastContact = now;
    }
    if (!flying()) {
      return;
    }
    if (model.battery().empty()) {
      Phrase reason = Phrase.of("the battery is empty");
      interrupt(RefusalKind.MOTORS_OFF, reason);
      motorsOff(FlightPhase.FALLING);
      observer.happened(new Fell(reason));
    } else if (model.battery().percent() <= Battery.LANDS_BY_ITSELF && !landing()) {
      Phrase reason = Phrase.of("the battery is at %d %%", model.battery().percent());
      interrupt(RefusalKind.LANDING, reason);
      land(Completion.NONE);
      landingForBattery = true;
      loneLanding = Optional.of(reason);
      observer.happened(new LandsByItself(reason, LandingCause.BATTERY));
    } else if (landsWhenSilent && now.since(lastContact) >= SILENCE && !landing()) {
      Phrase reason = Phrase.of("no command came for %.0f s", SILENCE);
      land(Completion.NONE);
      landingForSilence = true;
      loneLanding = Optional.of(reason);
      observer.happened(new LandsByItself(reason, LandingCause.SILENCE));
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
    Completion finished = completion;
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

  /** Aborts the current maneuver. Its order fails. */
  void gaveUp(RefusalKind kind, Phrase reason) {
    Completion failed = completion;
    hover();
    failed.failed(kind, reason);
  }

  /** Returns the depth of a fall onto the current ground [m]; 0 if the drone did not fall. */
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
    interrupt(RefusalKind.MOTORS_OFF, Phrase.of("the drone %s", crashed.phrase()));
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

  /**
   * The completions of {@code stop}. A completion is due when the drone has come to rest, but not
   * earlier than half a second after the command. If another movement has begun, the completion is
   * due one second after the command. Confined to the simulation thread.
   */
  private static final class ForcedStop {

    /** Minimum time from the command to the reply [s]. Measured: replies come 0.5 to 1 s later. */
    private static final double EARLIEST = 0.5;

    /**
     * Time from the command to the reply if another movement has begun [s]. Measured: replies come
     * 0.5 to 1 s later.
     */
    private static final double LATEST = 1;

    /** Maximum number of pending replies, so that a flood of {@code stop} has a limited effect. */
    private static final int MOST_WAITING = 100;

    private record Waiting(Completion completion, SimTime since) {}

    private final List<Waiting> waiting = new ArrayList<>();

    /**
     * Returns a completion that is due when the drone has come to rest. It never completes if too
     * many completions are already pending.
     */
    Completion expect(SimTime now) {
      Completion completion = new Completion();
      if (waiting.size() < MOST_WAITING) {
        waiting.add(new Waiting(completion, now));
      }
      return completion;
    }

    boolean pending() {
      return !waiting.isEmpty();
    }

    void forget() {
      waiting.clear();
    }

    /**
     * Sends the replies that are due.
     *
     * @param hovering whether neither a command nor {@code rc} moves the drone
     */
    void report(SimTime now, Motion motion, boolean hovering) {
      if (waiting.isEmpty()) {
        return;
      }
      boolean still = hovering && motion.velocity().norm() < Flight.STILL;
      double due = still ? EARLIEST : LATEST;
      List<Waiting> ripe =
          waiting.stream()
              .filter(one -> now.since(one.since()) >= due && (still || !hovering))
              .toList();
      waiting.removeAll(ripe);
      ripe.forEach(one -> one.completion().done());
    }
  }
}
