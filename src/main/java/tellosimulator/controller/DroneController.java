package tellosimulator.controller;

import java.util.Optional;
import tellosimulator.command.Command;
import tellosimulator.command.CommandTarget;
import tellosimulator.command.Direction;
import tellosimulator.command.OperatorSession;
import tellosimulator.command.Reply;
import tellosimulator.command.Responder;
import tellosimulator.controller.FlightEvent.Fell;
import tellosimulator.controller.FlightEvent.Note;
import tellosimulator.controller.FlightEvent.PutBack;
import tellosimulator.math.Vec3;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneModel;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.FlightPhase;
import tellosimulator.physics.Setpoint;
import tellosimulator.time.Demand;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;
import tellosimulator.world.Collision;

/**
 * Executes the commands of one drone: all flight logic except how maneuvers are flown. For the
 * simulation thread.
 */
public final class DroneController implements CommandTarget {

  private final ControllerContext context;
  private final DroneModel model;
  private final OperatorSession session;
  private final FlightObserver observer;
  private final Flight flight;
  private final FaultEffects faultEffects;
  private final Restart restart = new Restart();
  private final PathPlanner planner;
  private final PadMissions padMissions;
  private final Equipment equipment;
  private SimTime now = SimTime.ZERO;
  private double speed = DroneSpec.DEFAULT_SPEED;

  public DroneController(ControllerContext context) {
    this.context = context;
    this.model = context.model();
    this.session = context.session();
    this.observer = context.observer();
    this.flight = new Flight(context);
    this.faultEffects = new FaultEffects(context, flight);
    this.planner = new PathPlanner(context, flight);
    this.padMissions = new PadMissions(model, flight, planner);
    this.equipment = new Equipment(model, context.profile(), context.session(), observer);
  }

  // --- what the simulation calls in a step ---

  /** Sets the targets of the step that ends at {@code time}. */
  public void plan(SimTime time) {
    now = time;
    if (model.phase() != FlightPhase.OFF) {
      flight.drift(faultEffects.drift(time));
      flight.plan(time);
    }
  }

  /** What the motors shall achieve in this step. */
  public Setpoint setpoint() {
    return flight.setpoint();
  }

  /** Something stopped the drone. */
  public void touch(Collision collision) {
    flight.touch(collision);
  }

  /** Ends what has come to its end, and answers. */
  public void finish() {
    flight.finish();
  }

  /** Safety landing, low battery, restart. */
  public void watchOver() {
    faultEffects.advance(now, restart);
    flight.watchOver();
    restart.advance(now, this::powerOff, this::powerOn);
  }

  /** It has answered {@code ok}. */
  public void saidOk() {
    faultEffects.provoke(now);
  }

  /** Whether somebody waits for the answer to a command. */
  public boolean answers() {
    return flight.answers();
  }

  /** Why time must pass for it. */
  public Demand demand() {
    return restart.pending() ? Demand.DEBT : flight.demand();
  }

  // --- what people do to the drone ---

  public void powerOn() {
    if (model.phase() == FlightPhase.OFF) {
      flight.reset();
      model.powerOn(now);
      restart.forget();
      observer.happened(new Note(Phrase.of("is on and waits for commands")));
    }
  }

  /** Power goes: in the air the drone falls. */
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
    context.forgetLink().run();
    observer.happened(new Note(Phrase.of("is off")));
  }

  /** Back to the start, as if it had just been put there. */
  public void reset() {
    flight.reset();
    model.reset();
    speed = DroneSpec.DEFAULT_SPEED;
    observer.happened(new PutBack());
  }

  /**
   * Lands it, unless it stands or lands already; a caller that waits gets no answer.
   *
   * @param reason for people
   */
  public void landByItself(Phrase reason) {
    flight.landByItself(reason);
  }

  /** Forgets SDK mode and films no more; a flight goes on until the safety landing. */
  public void endSession() {
    model.setVideo(model.video().stopped());
    context.forgetLink().run();
  }

  // --- CommandTarget ---

  @Override
  public Optional<Phrase> running() {
    return flight.running();
  }

  @Override
  public Optional<Phrase> unactivated() {
    return faultEffects.unactivated();
  }

  @Override
  public boolean flying() {
    return flight.flying();
  }

  @Override
  public Phrase notFlying() {
    return Preflight.check(model).map(Preflight.Objection::reason).orElseGet(flight::notFlying);
  }

  @Override
  public void linkAlive() {
    flight.contact();
  }

  @Override
  public void commandArrived() {
    flight.cancelSafetyLanding();
  }

  @Override
  public void enterSdkMode(Command.EnterSdkMode command, Responder responder) {
    session.open(responder.peer(), now, !flight.airborne()).ifPresent(context.operatorChanged());
    String operator = session.link().operator().orElseThrow().host();
    if (!operator.equals(responder.peer().host())) {
      observer.happened(
          new Note(
              Phrase.of("answers %s, but is operated by %s", responder.peer().host(), operator)));
    }
    responder.reply(Reply.OK);
  }

  @Override
  public void takeoff(Command.Takeoff command, Responder responder) {
    Optional<Preflight.Objection> objection =
        Preflight.check(model).or(faultEffects::objectionToTakeoff);
    if (objection.isPresent()) {
      responder.refuse(objection.get().reply(), objection.get().reason());
    } else {
      double height = faultEffects.takeoffHeight(context.behavior().takeoffHeight());
      flight.takeoff(height, CompletionHandler.of(responder));
    }
  }

  @Override
  public void land(Command.Land command, Responder responder) {
    if (flight.landsOnCommand()) {
      responder.refuse(Reply.NOT_JOYSTICK, running().orElseThrow());
      return;
    }
    flight.interrupt(Reply.AUTO_LAND, Phrase.of("`land` cut it off"));
    flight.land(CompletionHandler.of(responder));
  }

  @Override
  public void stop(Command.Stop command, Responder responder) {
    if (!flight.airborne()) {
      responder.refuse(Reply.ERROR, Phrase.of("the drone does not fly"));
    } else if (!refusedForBattery(responder)) {
      responder.reply(Reply.OK);
      flight.stop(responder);
    }
  }

  @Override
  public void emergency(Command.Emergency command, Responder responder) {
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

  @Override
  public void move(Command.Move command, Responder responder) {
    if (refused(responder)) {
      return;
    }
    boolean stoppedShort =
        command.direction() == Direction.DOWN
            && flight.basePosition().z() - command.distance() < context.behavior().lowestHover();
    boolean silent = stoppedShort && !context.behavior().answersLowDown();
    if (silent) {
      observer.happened(
          new Note(Phrase.of("stops above the floor and never answers `%s`", responder.text())));
    }
    Vec3 way = command.direction().unit().times(command.distance());
    flight.fly(
        planner.by(way, speed),
        silent ? CompletionHandler.NOBODY : CompletionHandler.of(responder));
  }

  @Override
  public void go(Command.Go command, Responder responder) {
    if (!refused(responder)) {
      flight.fly(planner.by(command.way(), command.speed()), CompletionHandler.of(responder));
    }
  }

  @Override
  public void curve(Command.Curve command, Responder responder) {
    if (!refused(responder)) {
      flight.fly(planner.along(command, flight.baseHeading()), CompletionHandler.of(responder));
    }
  }

  @Override
  public void turn(Command.Turn command, Responder responder) {
    if (!refused(responder)) {
      flight.fly(planner.turn(command.angle()), CompletionHandler.of(responder));
    }
  }

  @Override
  public void flip(Command.Flip command, Responder responder) {
    int percent = model.battery().percent();
    if (refused(responder)) {
      return;
    }
    if (percent < Battery.LEAST_FOR_FLIP) {
      responder.refuse(
          Reply.ERROR,
          Phrase.of(
              "the battery is at %d %%, a flip needs at least %d %%",
              percent, Battery.LEAST_FOR_FLIP));
      return;
    }
    flight.fly(
        new Flip(
            flight.basePosition(),
            flight.baseHeading(),
            command.direction().unit(),
            planner.miss()),
        CompletionHandler.of(responder));
  }

  @Override
  public void goToPad(Command.GoToPad command, Responder responder) {
    if (!refused(responder)) {
      padMissions.go(command, responder);
    }
  }

  @Override
  public void curveOverPad(Command.CurveOverPad command, Responder responder) {
    if (!refused(responder)) {
      padMissions.curve(command, responder);
    }
  }

  @Override
  public void jump(Command.Jump command, Responder responder) {
    if (!refused(responder)) {
      padMissions.jump(command, responder);
    }
  }

  @Override
  public void setSpeed(Command.SetSpeed command, Responder responder) {
    speed = command.speed();
    responder.reply(Reply.OK);
  }

  @Override
  public void rc(Command.Rc command, Responder responder) {
    flight.steer(command.sticks());
    faultEffects.provoke(now);
  }

  @Override
  public void setNetwork(Command.SetNetwork command, Responder responder) {
    if (context.behavior().restartsForNetwork()) {
      responder.reply(command.done());
      restart.schedule(now, Restart.NOTICE);
      return;
    }
    observer.happened(new Note(Phrase.of("joins no network, because it is simulated")));
    responder.reply(Reply.OK);
  }

  @Override
  public void detectPads(Command.DetectPads command, Responder responder) {
    equipment.detectPads(command, responder);
  }

  @Override
  public void setPadDirection(Command.SetPadDirection command, Responder responder) {
    equipment.setPadDirection(command, responder);
  }

  @Override
  public void stream(Command.Stream command, Responder responder) {
    equipment.stream(command, responder);
  }

  @Override
  public void setVideo(Command.SetVideo command, Responder responder) {
    equipment.setVideo(command, responder);
  }

  @Override
  public void setPorts(Command.SetPorts command, Responder responder) {
    if (session.setPorts(responder.peer(), command.statePort(), command.videoPort())) {
      responder.reply(Reply.OK);
    } else {
      responder.refuse(Reply.ERROR, Phrase.of("state and video go to another host"));
    }
  }

  @Override
  public void spinMotors(Command.SpinMotors command, Responder responder) {
    FlightPhase wanted = command.on() ? FlightPhase.IDLING : FlightPhase.GROUNDED;
    boolean standing = model.phase() == FlightPhase.GROUNDED || model.phase() == FlightPhase.IDLING;
    if (standing && model.upright()) {
      model.setPhase(wanted);
      responder.reply(Reply.OK);
    } else {
      responder.refuse(Reply.ERROR, Phrase.of("the drone does not stand on the ground"));
    }
  }

  @Override
  public void reboot(Command.Reboot command, Responder responder) {
    restart.schedule(now, 0);
  }

  @Override
  public void light(Command.Light command, Responder responder) {
    equipment.light(command, responder, now);
  }

  @Override
  public void acknowledge(Command.Acknowledge command, Responder responder) {
    responder.reply(command.reply());
  }

  @Override
  public void read(Command.Read command, Responder responder) {
    responder.reply(context.reads().reply(command.reading(), model, speed, now));
  }

  private boolean refused(Responder responder) {
    if (refusedForBattery(responder)) {
      return true;
    }
    Optional<Preflight.Objection> objection = faultEffects.objectionToNewMove(now);
    objection.ifPresent(found -> responder.refuse(found.reply(), found.reason()));
    return objection.isPresent();
  }

  private boolean refusedForBattery(Responder responder) {
    if (flight.landsForBattery()) {
      responder.refuse(Reply.AUTO_LAND, Phrase.of("the drone lands because of its battery"));
    }
    return flight.landsForBattery();
  }
}
