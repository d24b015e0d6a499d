package tellosimulator.command;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Function;
import tellosimulator.controller.Completion;
import tellosimulator.controller.DroneController;
import tellosimulator.controller.FlightEvent.Note;
import tellosimulator.controller.RefusalKind;
import tellosimulator.controller.Result;
import tellosimulator.words.Phrase;

/**
 * Carries out commands on a drone, and turns the results into replies. Confined to the simulation
 * thread.
 */
final class DroneCommands implements CommandTarget {

  private final ProtocolContext drone;
  private final StateLines stateLines;
  private final DroneController controller;
  private final ReadReplies reads;
  private final Map<Class<? extends Command>, BiConsumer<Command, Responder>> table =
      new HashMap<>();

  DroneCommands(ProtocolContext drone, StateLines stateLines) {
    this.drone = drone;
    this.stateLines = stateLines;
    this.controller = drone.controller();
    this.reads = new ReadReplies(drone);
    order(Command.Takeoff.class, command -> controller.takeoff());
    order(Command.Land.class, command -> controller.land());
    order(Command.Move.class, c -> controller.move(c.direction(), c.distance()));
    order(Command.Turn.class, c -> controller.turn(c.angle()));
    order(Command.Flip.class, c -> controller.flip(c.direction()));
    order(Command.Go.class, c -> controller.go(c.way(), c.speed()));
    order(Command.Curve.class, c -> controller.curve(c.arc(), c.speed()));
    order(Command.GoToPad.class, c -> controller.goToPad(c.goal(), c.speed(), c.pad()));
    order(
        Command.CurveOverPad.class,
        c -> controller.curveOverPad(c.via(), c.end(), c.speed(), c.pad()));
    order(
        Command.Jump.class,
        c ->
            controller.jump(
                c.leg().goal(), c.leg().speed(), c.leg().pad(), c.heading(), c.second()));
    order(Command.SetSpeed.class, c -> controller.setSpeed(c.speed()));
    order(Command.DetectPads.class, c -> controller.equipment().detectPads(c.on()));
    order(
        Command.SetPadDirection.class, c -> controller.equipment().setPadDirection(c.direction()));
    order(Command.SetVideo.class, c -> controller.equipment().setVideo(c.option(), c.value()));
    order(Command.SpinMotors.class, c -> controller.spinMotors(c.on()));
    entry(Command.Stop.class, this::stop);
    entry(Command.Emergency.class, (command, responder) -> controller.emergency());
    entry(Command.Rc.class, (command, responder) -> controller.steer(command.sticks()));
    entry(Command.Reboot.class, (command, responder) -> controller.reboot(false));
    entry(Command.EnterSdkMode.class, this::enterSdkMode);
    entry(Command.Stream.class, this::stream);
    entry(Command.SetPorts.class, this::setPorts);
    entry(Command.SetNetwork.class, this::setNetwork);
    entry(Command.Light.class, this::light);
    entry(Command.Acknowledge.class, (command, responder) -> responder.reply(command.reply()));
    entry(
        Command.Read.class,
        (command, responder) -> responder.reply(reads.reply(command.reading())));
    if (!table.keySet().equals(Set.of(Command.class.getPermittedSubclasses()))) {
      throw new IllegalStateException("a command is missing in the table");
    }
  }

  private <C extends Command> void order(Class<C> type, Function<C, Result> order) {
    entry(type, (command, responder) -> answer(order.apply(command), responder));
  }

  private <C extends Command> void entry(Class<C> type, BiConsumer<C, Responder> action) {
    table.put(type, (command, responder) -> action.accept(type.cast(command), responder));
  }

  @Override
  public void carryOut(Command command, Responder responder) {
    table.get(command.getClass()).accept(command, responder);
  }

  private static void answer(Result result, Responder responder) {
    if (result instanceof Result.Refused refused) {
      responder.refuse(Reply.of(refused.kind()), refused.reason());
    } else if (result instanceof Result.Running running) {
      running.completion().await(responder.text(), whenOver(responder, Reply.OK));
    } else {
      responder.reply(Reply.OK);
    }
  }

  private static Completion.Listener whenOver(Responder responder, Reply reply) {
    return new Completion.Listener() {
      @Override
      public void done() {
        responder.reply(reply);
      }

      @Override
      public void failed(RefusalKind kind, Phrase reason) {
        responder.fail(Reply.of(kind), reason);
      }
    };
  }

  /** Brakes. {@code stop} is answered at once, and again when the drone has come to rest. */
  private void stop(Command.Stop command, Responder responder) {
    Result result = controller.stop();
    if (result instanceof Result.Running running) {
      responder.reply(Reply.OK);
      running.completion().await(responder.text(), whenOver(responder, Reply.FORCED_STOP));
    } else {
      answer(result, responder);
    }
  }

  private void enterSdkMode(Command.EnterSdkMode command, Responder responder) {
    OperatorSession session = drone.session();
    session
        .open(responder.peer(), drone.now(), !controller.airborne())
        .ifPresent(takeover -> drone.observer().operatorChanged(takeover, session.link()));
    stateLines.begin();
    String operator = session.link().operator().orElseThrow().host();
    if (!operator.equals(responder.peer().host())) {
      note(Phrase.of("answers %s, but is operated by %s", responder.peer().host(), operator));
    }
    responder.reply(Reply.OK);
  }

  private void stream(Command.Stream command, Responder responder) {
    Result result = controller.equipment().stream(command.on());
    note(
        command.on()
            ? Phrase.of("films for port %d of its operator", drone.session().link().videoPort())
            : Phrase.of("films no more"));
    answer(result, responder);
  }

  private void setPorts(Command.SetPorts command, Responder responder) {
    if (drone.session().setPorts(responder.peer(), command.statePort(), command.videoPort())) {
      responder.reply(Reply.OK);
    } else {
      responder.refuse(Reply.ERROR, Phrase.of("state and video go to another host"));
    }
  }

  private void setNetwork(Command.SetNetwork command, Responder responder) {
    if (drone.behavior().restartsForNetwork()) {
      responder.reply(command.done());
      controller.reboot(true);
      return;
    }
    note(Phrase.of("joins no network, because it is simulated"));
    responder.reply(Reply.OK);
  }

  private void light(Command.Light command, Responder responder) {
    controller.equipment().light(command.order(), controller.now());
    responder.reply(command.reply());
  }

  private void note(Phrase phrase) {
    drone.observer().happened(new Note(phrase));
  }

  @Override
  public Optional<Phrase> running() {
    return controller.running();
  }

  @Override
  public Optional<Phrase> unactivated() {
    return controller.unactivated();
  }

  @Override
  public boolean flying() {
    return controller.flying();
  }

  @Override
  public Phrase notFlying() {
    return controller.notFlying();
  }

  @Override
  public void linkAlive() {
    controller.linkAlive();
  }

  @Override
  public void commandArrived() {
    controller.commandArrived();
  }
}
