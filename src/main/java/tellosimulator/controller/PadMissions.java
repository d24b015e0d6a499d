package tellosimulator.controller;

import java.util.Comparator;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import tellosimulator.command.Command;
import tellosimulator.command.GeometryRules;
import tellosimulator.command.PadChoice;
import tellosimulator.command.Reply;
import tellosimulator.command.Responder;
import tellosimulator.math.Arc;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneModel;
import tellosimulator.model.PadSighting;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/** The commands that fly by mission pads. For one drone and the simulation thread. */
final class PadMissions {

  /** Means the pad that was identified first. Documented: SDK 3.0 User Guide. */
  private static final int FIRST = -1;

  /** Means the nearest pad. Documented: SDK 3.0 User Guide. */
  private static final int NEAREST = -2;

  private final DroneModel model;
  private final Flight flight;
  private final PathPlanner planner;

  PadMissions(DroneModel model, Flight flight, PathPlanner planner) {
    this.model = model;
    this.flight = flight;
    this.planner = planner;
  }

  /** Flies to a point in the pad's frame; the heading stays. */
  void go(Command.GoToPad command, Responder responder) {
    seek(
        command.pad(),
        responder,
        pad -> flight.fly(way(pad, command), CompletionHandler.of(responder)));
  }

  /** Flies an arc through two points in the pad's frame. */
  void curve(Command.CurveOverPad command, Responder responder) {
    seek(command.pad(), responder, pad -> curve(pad, command, responder));
  }

  /**
   * Flies to a point over the first pad, looks for the second one, flies over its middle and turns.
   * Documented: Mission Pad User Guide.
   */
  void jump(Command.Jump command, Responder responder) {
    CompletionHandler second =
        CompletionHandler.then(
            responder,
            () -> search(command.second(), responder, pad -> cross(pad, command, responder)));
    seek(command.leg().pad(), responder, pad -> flight.fly(way(pad, command.leg()), second));
  }

  private void curve(PadSighting pad, Command.CurveOverPad command, Responder responder) {
    Vec3 here = flight.basePosition();
    Optional<Arc> arc =
        Arc.through(place(pad, command.via()).minus(here), place(pad, command.end()).minus(here));
    Optional<Phrase> objection = GeometryRules.radiusObjection(arc);
    if (objection.isPresent()) {
      responder.refuse(Reply.RADIUS, objection.get());
      return;
    }
    Maneuver curve = planner.along(new Command.Curve(arc.orElseThrow(), command.speed()), 0);
    flight.fly(watching(pad, curve, place(pad, command.end())), CompletionHandler.of(responder));
  }

  /** Over the middle of the second pad of a jump. */
  private void cross(PadSighting pad, Command.Jump command, Responder responder) {
    Vec3 over = place(pad, new Vec3(0, 0, command.leg().goal().z()));
    Maneuver way = planner.to(over, command.leg().speed());
    double heading = pad.pad().attitude().heading() + command.heading();
    flight.fly(
        watching(pad, way, over),
        CompletionHandler.then(responder, () -> turn(heading, responder)));
  }

  /** Goes on with the pad if it is seen; waits for the first look if there was none yet. */
  private void seek(PadChoice choice, Responder responder, Consumer<PadSighting> next) {
    Optional<Phrase> blind = blind();
    Optional<PadSighting> pad = find(choice);
    if (blind.isPresent()) {
      responder.refuse(Reply.NO_VALID_MARKER, blind.get());
    } else if (pad.isPresent()) {
      next.accept(pad.get());
    } else if (model.perception().looked()) {
      responder.refuse(Reply.NO_VALID_MARKER, unseen(choice));
    } else {
      search(choice, responder, next);
    }
  }

  /** Hovers until the pad is seen, or for as long as it looks for one. */
  private void search(PadChoice choice, Responder responder, Consumer<PadSighting> next) {
    PadSearch search =
        new PadSearch(flight.basePosition(), flight.baseHeading(), () -> find(choice).isPresent());
    Runnable end =
        () ->
            find(choice)
                .ifPresentOrElse(next, () -> responder.fail(Reply.NO_VALID_MARKER, unseen(choice)));
    flight.fly(search, CompletionHandler.then(responder, end));
  }

  private void turn(double heading, Responder responder) {
    double angle = Frames.wrapped(heading - flight.baseHeading());
    flight.fly(planner.turn(angle), CompletionHandler.of(responder));
  }

  private Maneuver way(PadSighting pad, Command.GoToPad command) {
    Vec3 goal = place(pad, command.goal());
    return watching(pad, planner.to(goal, command.speed()), goal);
  }

  /** Flies to a place as long as the pad is in sight. */
  private Maneuver watching(PadSighting pad, Maneuver maneuver, Vec3 goal) {
    return planner.reaches(goal)
        ? PadWatch.over(maneuver, pad.id(), () -> sees(pad.id()))
        : PadWatch.inVain(maneuver);
  }

  /** Whether it is below; one far ahead of the nose says nothing of where the drone is. */
  private boolean sees(int id) {
    return model.perception().pads().stream().anyMatch(pad -> pad.id() == id && pad.below());
  }

  private static Vec3 place(PadSighting pad, Vec3 inPadFrame) {
    return pad.pad().position().plus(pad.pad().attitude().toRoom(inPadFrame));
  }

  /** The pad that is meant, if the camera in the underside sees it. */
  private Optional<PadSighting> find(PadChoice choice) {
    var below = model.perception().pads().stream().filter(PadSighting::below);
    return switch (choice.id()) {
      case FIRST -> below.min(Comparator.comparing(pad -> pad.moment().since().nanos()));
      case NEAREST -> below.min(Comparator.comparing(pad -> pad.offset().norm()));
      default -> below.filter(pad -> pad.id() == choice.id()).findFirst();
    };
  }

  /** Why it does not look for pads below. */
  private Optional<Phrase> blind() {
    return switch (model.perception().padMode()) {
      case OFF -> Optional.of(Phrase.of("pad detection is off, send `mon` first"));
      case FORWARD ->
          Optional.of(
              Phrase.of("the drone does not look down for pads, send `mdirection 0` or 2 first"));
      case DOWN, BOTH -> Optional.empty();
    };
  }

  private static Phrase unseen(PadChoice choice) {
    return choice.id() < 0
        ? Phrase.of("the drone does not see any pad below it")
        : Phrase.of("the drone does not see the pad %s", choice.word());
  }

  /** Hovers until a mission pad is seen, or for as long as it looks for one. */
  private static final class PadSearch implements Maneuver {

    /** How long it looks [s]. Assumed: some pictures. */
    private static final double PATIENCE = 1;

    private final Setpoint.Track place;
    private final BooleanSupplier seen;
    private double time;
    private boolean found;

    /**
     * @param position where it hovers, room frame [m]
     * @param heading where the nose points [rad]
     * @param seen whether the pad is seen now
     */
    PadSearch(Vec3 position, double heading, BooleanSupplier seen) {
      this.place =
          new Setpoint.Track(position, Vec3.ZERO, Vec3.ZERO, new Setpoint.Heading(heading, 0));
      this.seen = seen;
    }

    @Override
    public Setpoint advance(Sensed sensed, double seconds) {
      time += seconds;
      found = found || seen.getAsBoolean();
      return place;
    }

    @Override
    public boolean planned() {
      return found || time >= PATIENCE;
    }

    @Override
    public Phrase progress() {
      return Phrase.of("it looks for the pad");
    }
  }

  /**
   * A maneuver by a mission pad, which gives up when the pad is out of sight for too long, or when
   * its goal cannot be reached.
   */
  private static final class PadWatch implements Maneuver {

    /** How long it flies without seeing the pad [s]. Measured: 15.2 (Tello-Python issue 88). */
    private static final double PATIENCE = 15.2;

    private final Maneuver maneuver;
    private final BooleanSupplier seen;
    private final boolean reachable;
    private final Phrase reason;
    private double unseen;

    private PadWatch(Maneuver maneuver, BooleanSupplier seen, boolean reachable, Phrase reason) {
      this.maneuver = maneuver;
      this.seen = seen;
      this.reachable = reachable;
      this.reason = reason;
    }

    /**
     * As long as a pad is in sight.
     *
     * @param pad its number
     * @param seen whether the drone sees it below now
     */
    static PadWatch over(Maneuver maneuver, int pad, BooleanSupplier seen) {
      Phrase reason = Phrase.of("it has not seen the pad m%d for %.1f s", pad, PATIENCE);
      return new PadWatch(maneuver, seen, true, reason);
    }

    /** To a place below the lowest hover: the drone flies as far as it can, and waits there. */
    static PadWatch inVain(Maneuver maneuver) {
      Phrase reason = Phrase.of("the place is too low, and not reached after %.1f s", PATIENCE);
      return new PadWatch(maneuver, () -> false, false, reason);
    }

    @Override
    public Setpoint advance(Sensed sensed, double seconds) {
      unseen = seen.getAsBoolean() ? 0 : unseen + seconds;
      return maneuver.advance(sensed, seconds);
    }

    @Override
    public boolean planned() {
      return reachable && maneuver.planned();
    }

    @Override
    public Phrase progress() {
      return maneuver.progress();
    }

    @Override
    public Optional<Phrase> lost() {
      return unseen < PATIENCE || planned() ? Optional.empty() : Optional.of(reason);
    }
  }
}
