package tellosimulator.sim;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import tellosimulator.command.DronePort;
import tellosimulator.command.LinkDatagram;
import tellosimulator.command.OperatorSession;
import tellosimulator.command.PhotoCamera;
import tellosimulator.command.ProtocolContext;
import tellosimulator.command.Reply;
import tellosimulator.controller.ControllerContext;
import tellosimulator.controller.DroneController;
import tellosimulator.controller.FlightEvent;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.LinkPreset;
import tellosimulator.fault.SensorFaults;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneModel;
import tellosimulator.model.DroneSpec;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sensor.Instruments;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.sim.SimConfig.Rules;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.PendingWork;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;
import tellosimulator.world.Room;

/**
 * A drone with all its parts, and with a method for each phase of a step. Confined to the
 * simulation thread.
 */
final class SimDrone {

  private final DroneSetup setup;
  private final Neighborhood neighborhood;
  private final DronePort port;
  private final DroneModel model;
  private final OperatorSession session;
  private final RadioLink link;
  private final DroneController controller;
  private final DroneProtocols protocols;
  private final DroneBody body;
  private final DroneEvents events;
  private final PadSense padSense = new PadSense();
  private SimTime now = SimTime.ZERO;

  /**
   * The parts that all drones of a simulation share.
   *
   * @param seed the seed of all randomness
   * @param rules the rules of the simulation
   * @param collisionWorld the surroundings
   * @param camera takes the drones' photos
   * @param events receives all events
   */
  record Neighborhood(
      long seed,
      Rules rules,
      CollisionWorld collisionWorld,
      PhotoCamera camera,
      Consumer<SimEvent> events) {}

  /**
   * Creates a drone that is switched off.
   *
   * @param number the number of the drone, from 1
   */
  SimDrone(int number, DroneSetup setup, DronePort port, Neighborhood neighborhood) {
    this(new DroneModel(number, setup.start()), setup, port, neighborhood);
    model.setBattery(new Battery(setup.batteryPercent() / 100));
  }

  private SimDrone(DroneModel model, DroneSetup setup, DronePort port, Neighborhood neighborhood) {
    int number = model.drone();
    this.model = model;
    this.setup = setup;
    this.neighborhood = neighborhood;
    this.port = port;
    Profile profile = setup.product().profile();
    Behavior behavior = setup.product().behavior();
    events = new DroneEvents(number, () -> now, this::happened);
    SeededNoise noise = new SeededNoise(neighborhood.seed(), number);
    link = new RadioLink(port, this::receive, events, noise);
    controller =
        new DroneController(
            new ControllerContext(
                model,
                profile,
                behavior,
                neighborhood.rules().crashSpeed(),
                setup.landsWhenSilent(),
                noise,
                events,
                link::faults,
                this::endSession));
    session =
        new OperatorSession(
            neighborhood.rules().operators(),
            setup.streamPorts().statePort(),
            setup.streamPorts().videoPort(),
            port::linked);
    Instruments instruments =
        new Instruments(
            behavior,
            noise,
            neighborhood.collisionWorld().echoes(number),
            readings -> SensorFaults.applied(readings, link.faults()));
    protocols =
        new DroneProtocols(
            new ProtocolContext(
                controller,
                profile,
                behavior,
                instruments,
                noise,
                () -> model.snapshot(now),
                link::faults,
                session,
                link,
                neighborhood.camera(),
                events));
    body = new DroneBody(model, controller);
  }

  // --- datagrams ---

  /** Returns the link through which datagrams reach the drone. */
  RadioLink link() {
    return link;
  }

  DroneProtocols protocols() {
    return protocols;
  }

  /** Handles the commands whose delay is over. */
  void receiveDelayed() {
    link.deliverCommands(session.link().operator());
  }

  private void receive(LinkDatagram datagram) {
    if (model.phase() == FlightPhase.OFF) {
      protocols.ignore(datagram, Phrase.of("the drone is off"));
    } else {
      protocols.receive(datagram);
    }
  }

  // --- controls and changes of the surroundings ---

  /**
   * Sets the active faults.
   *
   * @param preset the link quality apart from faults; empty for the default of the drone's
   *     behaviour
   */
  void disturb(Optional<LinkPreset> preset, List<Fault> acting) {
    Behavior behavior = setup.product().behavior();
    link.set(new ActiveFaults(preset.orElseGet(() -> LinkPreset.usual(behavior)), acting));
  }

  void apply(Control.ForDrone control, Room room) {
    if (control instanceof Control.Power power) {
      if (power.on()) {
        controller.powerOn();
      } else {
        controller.powerOff();
      }
    } else if (control instanceof Control.Reset) {
      controller.reset();
      protocols.reset();
      body.settle(neighborhood.collisionWorld());
    } else if (control instanceof Control.Land) {
      controller.landAtEndOfProgram();
    } else if (control instanceof Control.Release) {
      protocols.release();
    } else if (control instanceof Control.SetBattery battery) {
      model.setBattery(new Battery(battery.percent() / 100));
      note(Phrase.of("has %d %% of its battery now", model.battery().percent()));
    } else if (control instanceof Control.SetStart start) {
      Vec3 place = room.nearestInside(start.position().withZ(0), DroneSpec.COLLIDER);
      setStart(new Pose(place, Attitude.ofHeading(start.heading())));
    }
  }

  /**
   * Returns a copy of this drone with another product and other ports, at the same place. If this
   * drone is on, logs that it was not changed, and returns this drone.
   */
  SimDrone configured(Control.Configure change) {
    if (model.phase() != FlightPhase.OFF) {
      note(Phrase.of("was not changed, because it is on: switch it off first"));
      return this;
    }
    Profile newProfile = change.product().profile();
    Behavior newBehavior = change.product().behavior();
    DroneSetup newSetup = setup.withProduct(change.product()).withStreamPorts(change.streamPorts());
    SimDrone other = new SimDrone(model, newSetup, port, neighborhood);
    other.plan(now);
    if (!change.product().equals(setup.product())) {
      other.note(
          Phrase.of(
              "is of profile %s and behaviour %s now", newProfile.option(), newBehavior.option()));
    }
    if (!change.streamPorts().equals(setup.streamPorts())) {
      other.note(
          Phrase.of(
              "sends its state to port %d and its video to port %d from now on",
              change.streamPorts().statePort(), change.streamPorts().videoPort()));
    }
    return other;
  }

  /**
   * Adapts to changed surroundings: the drone may have lost its support, or may overlap something.
   */
  void lookAround(CollisionWorld collisionWorld) {
    model.moveInto(collisionWorld.arena().room());
    body.settle(collisionWorld);
  }

  // --- queries ---

  int number() {
    return model.drone();
  }

  DroneBody body() {
    return body;
  }

  // --- phases of a step ---

  void plan(SimTime time) {
    now = time;
    link.deliverReplies();
    controller.plan(now);
  }

  /** Detects mission pads. */
  void sense(CollisionWorld collisionWorld) {
    boolean blind = link.faults().find(FaultKind.PAD_BLIND).isPresent();
    padSense.sense(model, now, blind, collisionWorld);
  }

  void consume() {
    int before = model.battery().percent();
    model.consume(SimTime.STEP, setup.product().behavior().filmingEndurance());
    BatteryNotes.note(before, model.battery().percent()).ifPresent(this::note);
  }

  void finish() {
    controller.finish();
  }

  DroneSnapshot publish() {
    return new DroneSnapshot(
        model.snapshot(now),
        session.link(),
        setup.product(),
        model.start(),
        setup.rgb(),
        link.faults());
  }

  void output() {
    protocols.output();
    controller.watchOver();
  }

  /** Whether a client is waiting for the reply to a command that takes time. */
  boolean answers() {
    return controller.answers();
  }

  /** Returns the reason why simulated time must pass for this drone. */
  PendingWork demand() {
    return protocols.hasPending() || link.hasPending() ? PendingWork.REPLY : controller.demand();
  }

  private void setStart(Pose start) {
    model.setStart(start);
    if (model.resting() && !controller.flying()) {
      controller.reset();
      body.settle(neighborhood.collisionWorld());
    }
  }

  private void happened(SimEvent event) {
    if (event instanceof SimEvent.ReplySent sent && sent.reply().equals(Reply.OK)) {
      controller.saidOk();
    }
    neighborhood.events().accept(event);
  }

  private void note(Phrase phrase) {
    events.happened(new FlightEvent.Note(phrase));
  }

  private void endSession() {
    protocols.powerOff();
    link.forget();
  }
}
