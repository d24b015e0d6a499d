package tellosimulator.protocol.app;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import tellosimulator.command.CommandObserver;
import tellosimulator.command.Peer;
import tellosimulator.command.ProtocolContext;
import tellosimulator.command.Reply;
import tellosimulator.command.Request;
import tellosimulator.controller.Completion;
import tellosimulator.controller.Direction;
import tellosimulator.controller.DroneController;
import tellosimulator.controller.FlightEvent.Note;
import tellosimulator.controller.RefusalKind;
import tellosimulator.controller.Result;
import tellosimulator.controller.Sticks;
import tellosimulator.math.Arc;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The flight orders of the app. An order is answered at once; how it goes on is in the flight data.
 * Confined to the simulation thread.
 */
final class FlightOrders {

  /** Answer to an order that has been accepted. Measured: TelloPy 25, 29 and 48. */
  static final byte DONE = 0;

  /** Answer to an order that the drone refuses. Decided: no answer to a refusal is published. */
  static final byte REFUSED = 1;

  /** The messages whose orders are reported to the observer here. */
  static final Set<MessageId> MESSAGES =
      EnumSet.of(
          MessageId.PHOTO,
          MessageId.TAKEOFF,
          MessageId.THROW_AND_GO,
          MessageId.LAND,
          MessageId.PALM_LANDING,
          MessageId.FLIP,
          MessageId.SMART_VIDEO,
          MessageId.BOUNCE);

  /** Time without stick packets after which the sticks count as let go [s]. Decided. */
  private static final double LETS_GO = 1;

  /** Time for which both sticks must be down and inwards to start the motors [s]. Decided. */
  private static final double STARTS_MOTORS = 1;

  /** Deflection from which a stick counts as full [% of the way]. Decided. */
  private static final double NEARLY_FULL = 90;

  /** Distance by which a drone bounces [m]. Decided. */
  private static final double BOUNCE = 0.3;

  /** Distance from the drone to the centre of the circle that smart video flies [m]. Decided. */
  private static final double CIRCLE = 1;

  /** Speed of smart video [m/s]. Decided. */
  private static final double FILMING = 0.5;

  /** Way of the smart video that flies up and away, in the level body frame [m]. Decided. */
  private static final Vec3 UP_AND_OUT = new Vec3(-2, 0, 1);

  private static final int BOUNCE_ON = 0x30;

  /** The directions of flips by their number; diagonal flips are flown to the front or the back. */
  private static final List<Direction> FLIPS =
      List.of(
          Direction.FORWARD,
          Direction.LEFT,
          Direction.BACK,
          Direction.RIGHT,
          Direction.FORWARD,
          Direction.BACK,
          Direction.BACK,
          Direction.FORWARD);

  private final ProtocolContext drone;
  private final DroneController controller;
  private final CommandObserver observer;
  private final AppLimits limits;
  private Sticks sticks = Sticks.CENTERED;
  private SimTime steered = SimTime.ZERO;

  /** Since when both sticks have been down and inwards. */
  private Optional<SimTime> pinched = Optional.empty();

  private boolean bounces;

  FlightOrders(ProtocolContext drone, AppLimits limits) {
    this.drone = drone;
    this.limits = limits;
    controller = drone.controller();
    observer = drone.observer();
  }

  /** Takes off. A repeated takeoff has no effect, because some clients send it several times. */
  byte takeoff(String words) {
    boolean repeated = controller.flying() && drone.state().get().phase() != FlightPhase.LANDING;
    return repeated ? accepted(words) : order(words, controller::takeoff);
  }

  byte land(String words) {
    bounces = false;
    if (!controller.flying()) {
      return accepted(words);
    }
    return order(
        words,
        () -> {
          Result result = controller.land();
          boolean lands =
              result instanceof Result.Refused refused && refused.kind() == RefusalKind.BUSY;
          return lands ? Result.DONE : result;
        });
  }

  /** Takes a photo. */
  byte photo(Supplier<Result> camera) {
    return order("photo", camera);
  }

  byte stopLanding() {
    return order("stop landing", controller::stop);
  }

  /**
   * Flips.
   *
   * @param number 0 to the front, and then counter-clockwise; 4 to 7 are diagonal
   */
  byte flip(int number) {
    return direction(number)
        .map(to -> order(NamedPacket.flip(to), () -> ifFree(() -> controller.flip(to))))
        .orElse(REFUSED);
  }

  /** Returns the direction of a flip with a number; empty if there is none. */
  static Optional<Direction> direction(int number) {
    return number < 0 || number >= FLIPS.size() ? Optional.empty() : Optional.of(FLIPS.get(number));
  }

  /**
   * Begins or ends a smart video.
   *
   * @param value bit 0 begins; the bits from 2 on are the kind: 1 a full turn, 2 a circle, 3 up and
   *     away
   */
  byte smartVideo(int value) {
    if ((value & 1) == 0) {
      return order("smart video stop", controller::stop);
    }
    return switch (value >> 2) {
      case 1 -> order("smart video 360", () -> ifFree(() -> controller.turn(-2 * StrictMath.PI)));
      case 2 -> order("smart video circle", () -> ifFree(this::circle));
      case 3 ->
          order("smart video up and out", () -> ifFree(() -> controller.go(UP_AND_OUT, FILMING)));
      default -> REFUSED;
    };
  }

  /** Flies around a point ahead: half a circle, and then the other half. */
  private Result circle() {
    Result first = controller.curve(halfCircle(1), FILMING);
    if (first instanceof Result.Running running) {
      running
          .completion()
          .await(NamedPacket.named("smart video circle"), new Ending(this::secondHalf));
      return Result.DONE;
    }
    return first;
  }

  private void secondHalf() {
    controller.curve(halfCircle(-1), FILMING);
  }

  /** Returns half a circle around a point ahead, or behind after the first half. */
  private static Arc halfCircle(int ahead) {
    Vec3 via = new Vec3(ahead * CIRCLE, -ahead * CIRCLE, 0);
    return Arc.through(via, new Vec3(2 * ahead * CIRCLE, 0, 0)).orElseThrow();
  }

  /** Begins to bounce up and down, or ends that. */
  byte bounce(int value) {
    boolean on = value == BOUNCE_ON;
    if (!on) {
      bounces = false;
      return accepted("bounce off");
    }
    if (!controller.flying()) {
      return order("bounce", () -> ifFree(() -> Result.DONE));
    }
    bounces = true;
    byte answer = accepted("bounce");
    bounce(Direction.UP);
    return answer;
  }

  private void bounce(Direction direction) {
    if (bounces && controller.running().isEmpty()) {
      Direction next = direction == Direction.UP ? Direction.DOWN : Direction.UP;
      if (controller.move(direction, BOUNCE) instanceof Result.Running running) {
        running.completion().await(NamedPacket.named("bounce"), new Ending(() -> bounce(next)));
      }
    }
  }

  /** Gives an order unless another one is being carried out, or the drone is not flying. */
  private Result ifFree(Supplier<Result> order) {
    if (!controller.flying()) {
      return new Result.Refused(RefusalKind.MOTORS_OFF, controller.notFlying());
    }
    return controller
        .running()
        .<Result>map(running -> new Result.Refused(RefusalKind.BUSY, running))
        .orElseGet(order);
  }

  private byte order(String words, Supplier<Result> order) {
    Request request = request(words);
    controller.commandArrived();
    Result result = order.get();
    if (result instanceof Result.Refused refused) {
      observer.refused(request, Reply.ERROR, refused.reason());
      return REFUSED;
    }
    if (result instanceof Result.Running running) {
      running.completion().await(request.text(), new Ending(() -> {}));
    }
    observer.replied(request, Reply.OK);
    return DONE;
  }

  private byte accepted(String words) {
    observer.replied(request(words), Reply.OK);
    return DONE;
  }

  /** Reports an order to the observer. */
  private Request request(String words) {
    return request(drone.session().link().operator().orElseThrow(), NamedPacket.named(words));
  }

  private Request request(Peer peer, String text) {
    Request request = new Request(drone.session().nextRequest(), peer, text);
    observer.received(request);
    return request;
  }

  /** Reports a packet that is no order of flight, and its answer, to the observer. */
  void report(Peer peer, Packet packet, Packet answer) {
    Request request = request(peer, NamedPacket.words(packet));
    Reply reply = NamedPacket.reply(answer);
    if (reply.equals(Reply.ERROR)) {
      observer.refused(request, reply, Phrase.of("the value is out of range"));
    } else {
      observer.replied(request, reply);
    }
  }

  /** Reports a connection to the observer. */
  void connected(Peer peer) {
    observer.replied(request(peer, NamedPacket.CONNECTION), NamedPacket.CONNECTED);
  }

  /** The end of an order that has been answered already. */
  private final class Ending implements Completion.Listener {

    private final Runnable next;

    Ending(Runnable next) {
      this.next = next;
    }

    @Override
    public void done() {
      next.run();
    }

    @Override
    public void failed(RefusalKind kind, Phrase reason) {
      bounces = false;
      observer.happened(new Note(Phrase.of("could not complete the order of its app: %s", reason)));
    }
  }

  // --- sticks ---

  /** Sets the sticks. They act until the next ones, or until none have come for a while. */
  void steer(Sticks newSticks) {
    controller.commandArrived();
    steered = drone.controller().now();
    if (!newSticks.equals(sticks)) {
      sticks = newSticks;
      request(NamedPacket.rc(sticks));
      controller.steer(limits.limited(sticks, height()));
    }
    startByHand();
  }

  /** Starts the motors by both sticks down and inwards, and then takes off by the throttle. */
  private void startByHand() {
    FlightPhase phase = drone.state().get().phase();
    boolean inwards =
        sticks.up() <= -NEARLY_FULL
            && sticks.clockwise() >= NEARLY_FULL
            && sticks.forward() <= -NEARLY_FULL
            && sticks.right() <= -NEARLY_FULL;
    if (!inwards) {
      pinched = Optional.empty();
    } else if (pinched.isEmpty()) {
      pinched = Optional.of(controller.now());
    } else if (phase == FlightPhase.GROUNDED
        && controller.now().since(pinched.get()) >= STARTS_MOTORS) {
      order("motoron", () -> controller.spinMotors(true));
    }
    if (phase == FlightPhase.IDLING && sticks.up() > 0) {
      order("takeoff by hand", controller::takeoff);
    }
  }

  /** Lets the sticks go if none have come for a while, and ends a climb at the height limit. */
  void watchOver() {
    if (!sticks.centered() && controller.now().since(steered) >= LETS_GO) {
      steer(Sticks.CENTERED);
    } else if (sticks.up() > 0 && limits.near(height())) {
      controller.steer(limits.limited(sticks, height()));
    }
  }

  private double height() {
    return drone.state().get().motion().position().z();
  }

  void reset() {
    sticks = Sticks.CENTERED;
    pinched = Optional.empty();
    bounces = false;
  }
}
