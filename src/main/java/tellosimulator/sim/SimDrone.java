package tellosimulator.sim;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import tellosimulator.command.CommandHandler;
import tellosimulator.command.OperatorSession;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.command.ReplyPort;
import tellosimulator.controller.ControllerContext;
import tellosimulator.controller.DroneController;
import tellosimulator.controller.FlightEvent;
import tellosimulator.controller.ReadReplies;
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
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.physics.QuadcopterDynamics;
import tellosimulator.physics.Setpoint;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sensor.Instruments;
import tellosimulator.sensor.SeededNoise;
import tellosimulator.sim.SimConfig.Rules;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.Demand;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;
import tellosimulator.world.Collision;
import tellosimulator.world.Room;

/** One drone with all its parts, and its share of each part of a step. */
final class SimDrone {

  private final DroneSetup setup;
  private final Neighborhood neighborhood;
  private final ReplyPort replies;
  private final Profile profile;
  private final Behavior behavior;
  private final Instruments instruments;
  private final DroneModel model;
  private final OperatorSession session;
  private final DroneLink link;
  private final CommandHandler handler;
  private final DroneController controller;
  private final QuadcopterDynamics dynamics = new QuadcopterDynamics();
  private final DroneEvents events;
  private final StateLines stateLines;
  private final StateFaults stateFaults = new StateFaults();
  private final PadSense padSense = new PadSense();
  private SimTime now = SimTime.ZERO;
  private Vec3 before;
  private DroneState state;

  /**
   * What all drones of a simulation share.
   *
   * @param seed of everything random
   * @param rules of the simulation
   * @param collisionWorld what is around them
   * @param states the way out for state lines
   * @param events takes what happens
   */
  record Neighborhood(
      long seed,
      Rules rules,
      CollisionWorld collisionWorld,
      StatePort states,
      Consumer<SimEvent> events) {}

  /**
   * @param number from 1
   */
  SimDrone(int number, DroneSetup setup, ReplyPort replies, Neighborhood neighborhood) {
    this(new DroneModel(number, setup.start()), setup, replies, neighborhood);
    model.setBattery(new Battery(setup.batteryPercent() / 100));
  }

  private SimDrone(
      DroneModel model, DroneSetup setup, ReplyPort replies, Neighborhood neighborhood) {
    int number = model.drone();
    this.model = model;
    this.setup = setup;
    this.neighborhood = neighborhood;
    this.before = model.motion().position();
    this.replies = replies;
    this.profile = setup.product().profile();
    this.behavior = setup.product().behavior();
    this.events = new DroneEvents(number, () -> now, this::happened);
    SeededNoise noise = new SeededNoise(neighborhood.seed(), number);
    this.stateLines = new StateLines(behavior, noise);
    this.instruments =
        new Instruments(
            behavior,
            noise,
            neighborhood.collisionWorld().echoes(number),
            readings -> SensorFaults.applied(readings, faults()));
    this.state = model.snapshot(now);
    StreamPorts streamPorts = setup.streamPorts();
    this.session =
        new OperatorSession(
            neighborhood.rules().operators(),
            streamPorts.statePort(),
            streamPorts.videoPort(),
            replies::linked);
    this.link =
        new DroneLink(
            new DroneLink.Ends(
                number, replies, neighborhood.states(), this::handle, events, () -> now),
            noise);
    this.controller =
        new DroneController(
            new ControllerContext(
                model,
                profile,
                behavior,
                neighborhood.rules().crashSpeed(),
                setup.landsWhenSilent(),
                session,
                noise,
                new ReadReplies(instruments, profile, number),
                events::happened,
                this::faults,
                this::operatorChanged,
                this::forgetLink));
    this.handler =
        CommandHandler.of(profile, behavior)
            .target(controller)
            .session(session)
            .replies(link)
            .observer(events)
            .build();
  }

  // --- step 1 ---

  /** A datagram has come to its socket. */
  void receive(SimInput.Datagram datagram) {
    link.receive(datagram);
  }

  /** Whether commands may come that are not in the inbox. */
  boolean expectsCommands() {
    return link.brings();
  }

  /** Takes the commands that have been on their way until now. */
  void receiveDelayed() {
    link.deliverCommands(session.link().operator());
  }

  private void handle(SimInput.Datagram datagram) {
    Peer peer = datagram.peer();
    String text = datagram.text();
    if (model.phase() == FlightPhase.OFF) {
      events.ignored(peer, text, Phrase.of("the drone is off"));
    } else {
      handler.handle(peer, text, now);
      stateLines.owe();
    }
  }

  // --- step 2 ---

  /**
   * Lets other faults act from now on.
   *
   * @param preset how good the link is otherwise; empty for that of its behaviour
   */
  void disturb(Optional<LinkPreset> preset, List<Fault> acting) {
    link.set(new ActiveFaults(preset.orElseGet(() -> LinkPreset.usual(behavior)), acting));
  }

  private ActiveFaults faults() {
    return link.faults();
  }

  /**
   * Something sent to its operator did not arrive: the stream that nobody takes rests, and where it
   * was a reply, the session ends.
   */
  void unreachable(InetSocketAddress destination) {
    Optional<InetSocketAddress> operator = session.link().operator().map(Peer::address);
    if (operator.filter(destination::equals).isPresent()) {
      controller.endSession();
      note(
          Phrase.of(
              "is free, because nobody takes its replies at %s:%d any more; `command` starts anew",
              destination.getAddress().getHostAddress(), destination.getPort()));
    } else if (destination.getPort() == session.link().statePort()
        && operator
            .map(InetSocketAddress::getAddress)
            .equals(Optional.of(destination.getAddress()))) {
      session.restState(now);
    }
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
      handler.forgetCopies();
      session.release();
      settle(neighborhood.collisionWorld());
    } else if (control instanceof Control.Land) {
      controller.landByItself(Phrase.of("the program has ended"));
    } else if (control instanceof Control.Release) {
      Phrase free = Phrase.of("is free: who sends `command` next operates it");
      note(
          session
              .link()
              .operator()
              .map(lost -> Phrase.of("%s; %s has lost it", free, lost.host()))
              .orElse(free));
      controller.endSession();
    } else if (control instanceof Control.SetBattery battery) {
      model.setBattery(new Battery(battery.percent() / 100));
      note(Phrase.of("has %d %% of its battery now", model.battery().percent()));
    } else if (control instanceof Control.SetStart start) {
      Vec3 place = room.nearestInside(start.position().withZ(0), DroneSpec.COLLIDER);
      setStart(new Pose(place, Attitude.ofHeading(start.heading())));
    }
  }

  /** The same body as another product; itself, with a note, while it is on. */
  SimDrone configured(Control.Configure change) {
    if (model.phase() != FlightPhase.OFF) {
      note(Phrase.of("was not changed, because it is on: switch it off first"));
      return this;
    }
    Profile newProfile = change.product().profile();
    Behavior newBehavior = change.product().behavior();
    DroneSetup newSetup = setup.withProduct(change.product()).withStreamPorts(change.streamPorts());
    SimDrone other = new SimDrone(model, newSetup, replies, neighborhood);
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

  /** Other things stand around it: what carried it may be gone, or something is where it is. */
  void lookAround(CollisionWorld collisionWorld) {
    model.moveInto(collisionWorld.arena().room());
    settle(collisionWorld);
  }

  /** Lets a drone that rests fall, or move out of what it is in. */
  private void settle(CollisionWorld collisionWorld) {
    if (model.resting() && collisionWorld.unsettles(this)) {
      model.setMotion(model.motion());
    }
  }

  // --- what others ask ---

  int number() {
    return model.drone();
  }

  Vec3 position() {
    return model.motion().position();
  }

  Vec3 velocity() {
    return model.motion().velocity();
  }

  /** Where it was at the beginning of the step. */
  Vec3 before() {
    return before;
  }

  boolean resting() {
    return model.resting();
  }

  /** Distance along a ray to its body [m]; infinite if the ray misses it. */
  double distanceAlong(Vec3 origin, Vec3 direction) {
    return DroneSpec.COLLIDER.distance(position(), origin, direction);
  }

  // --- steps 3 to 9 ---

  void plan(SimTime time) {
    now = time;
    link.deliverReplies();
    controller.plan(now);
  }

  void integrate(Vec3 wind) {
    before = position();
    Setpoint setpoint = controller.setpoint();
    if (model.resting() && setpoint instanceof Setpoint.MotorsOff) {
      dynamics.rest();
      return;
    }
    model.setMotion(dynamics.advance(model.motion(), setpoint, wind, SimTime.STEP));
    model.setPushed(dynamics.pushed());
  }

  void collide(CollisionWorld collisionWorld) {
    if (!model.resting()) {
      collisionWorld.obstacle(this).ifPresent(this::stopBy);
    }
    if (!model.resting()) {
      collisionWorld.surface(this).ifPresent(this::stopBy);
    }
  }

  void stopBy(Collision collision) {
    model.setMotion(model.motion().heldAt(collision.position(), collision.velocity()));
    controller.touch(collision);
  }

  /** Looks for mission pads. */
  void sense(CollisionWorld collisionWorld) {
    boolean blind = faults().find(FaultKind.PAD_BLIND).isPresent();
    padSense.sense(model, now, blind, collisionWorld);
  }

  void consume() {
    int before = model.battery().percent();
    model.consume(SimTime.STEP, behavior.filmingEndurance());
    BatteryNotes.note(before, model.battery().percent()).ifPresent(this::note);
  }

  void finish() {
    controller.finish();
  }

  SimSnapshot.DroneSnapshot publish() {
    state = model.snapshot(now);
    return new SimSnapshot.DroneSnapshot(
        state, session.link(), setup.product(), model.start(), setup.rgb(), link.faults());
  }

  void output() {
    boolean expected = stateLines.owed();
    if (stateLines.due(now) && session.wantsState(now)) {
      stateFaults
          .next(
              faults(),
              now,
              () ->
                  new StatePort.StateReport(
                      state,
                      instruments.read(state),
                      state.perception().reading(),
                      profile,
                      session.link()))
          .ifPresent(report -> link.send(report, expected));
    }
    controller.watchOver();
  }

  /** Whether somebody waits for the answer to a command that takes time. */
  boolean answers() {
    return controller.answers();
  }

  /** Why time must pass for it. */
  Demand demand() {
    return stateLines.owed() || link.owes() ? Demand.DEBT : controller.demand();
  }

  private void setStart(Pose start) {
    model.setStart(start);
    if (model.resting() && !controller.flying()) {
      controller.reset();
      settle(neighborhood.collisionWorld());
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

  private void forgetLink() {
    handler.powerOff();
    link.forget();
    stateLines.end();
  }

  private void operatorChanged(OperatorSession.Takeover takeover) {
    events.operatorChanged(takeover, session.link().statePort());
    stateLines.begin(now);
  }
}
