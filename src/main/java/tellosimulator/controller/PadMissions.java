package tellosimulator.controller;

import java.util.Comparator;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import tellosimulator.math.Arc;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneModel;
import tellosimulator.model.PadSighting;
import tellosimulator.physics.Setpoint;
import tellosimulator.words.Phrase;

/**
 * Executes the commands that fly relative to mission pads. One instance per drone, confined to the
 * simulation thread.
 */
final class PadMissions {

  /** The id that selects the first identified pad. Documented: SDK 3.0 User Guide. */
  private static final int FIRST = -1;

  /** The id that selects the nearest pad. Documented: SDK 3.0 User Guide. */
  private static final int NEAREST = -2;

  private final DroneModel model;
  private final Flight flight;
  private final PathPlanner planner;

  PadMissions(DroneModel model, Flight flight, PathPlanner planner) {
    this.model = model;
    this.flight = flight;
    this.planner = planner;
  }

  /**
   * Flies to a point in the pad's frame. The heading stays the same.
   *
   * @param goal the goal [m]
   * @param speed the speed [m/s]
   */
  Result go(Vec3 goal, double speed, PadChoice choice) {
    return seek(choice, pad -> running(over(pad, place(pad, goal), speed)));
  }

  /**
   * Flies an arc through two points in the pad's frame.
   *
   * @param via the first point [m]
   * @param end the second point [m]
   * @param speed the speed [m/s]
   */
  Result curve(Vec3 via, Vec3 end, double speed, PadChoice choice) {
    return seek(choice, pad -> curve(pad, place(pad, via), place(pad, end), speed));
  }

  /**
   * Flies to a point over the first pad, searches for the second one, flies over its middle and
   * turns. Documented: Mission Pad User Guide.
   *
   * @param goal the goal in the first pad's frame [m]
   * @param speed the speed [m/s]
   * @param heading the heading at the end, in the second pad's frame [rad]
   */
  Result jump(Vec3 goal, double speed, PadChoice first, double heading, PadChoice second) {
    return seek(
        first,
        pad -> {
          Completion there = flight.fly(over(pad, place(pad, goal), speed));
          return new Result.Running(
              there.then(() -> search(second, other -> cross(other, goal.z(), speed, heading))));
        });
  }

  private Result running(Maneuver maneuver) {
    return new Result.Running(flight.fly(maneuver));
  }

  private Result curve(PadSighting pad, Vec3 via, Vec3 end, double speed) {
    Vec3 here = flight.basePosition();
    Optional<Arc> arc = Arc.through(via.minus(here), end.minus(here));
    Optional<Phrase> objection = CurveRadius.objection(arc);
    if (objection.isPresent()) {
      return new Result.Refused(RefusalKind.RADIUS, objection.get());
    }
    return running(watching(pad, planner.along(arc.orElseThrow(), speed, 0), end));
  }

  /** Flies over the middle of a jump's second pad, and turns there. */
  private Result cross(PadSighting pad, double height, double speed, double heading) {
    Completion there = flight.fly(over(pad, place(pad, new Vec3(0, 0, height)), speed));
    double end = pad.pad().attitude().heading() + heading;
    return new Result.Running(
        there.then(() -> running(planner.turn(Frames.wrapped(end - flight.baseHeading())))));
  }

  /**
   * Continues with the selected pad if it is in sight, and refuses the command if it is not. If no
   * detection has run yet, waits for the first one.
   */
  private Result seek(PadChoice choice, Function<PadSighting, Result> next) {
    Optional<Phrase> blind = blind();
    Optional<PadSighting> pad = find(choice);
    if (blind.isPresent()) {
      return new Result.Refused(RefusalKind.PAD_NOT_SEEN, blind.get());
    } else if (pad.isPresent()) {
      return next.apply(pad.get());
    } else if (model.perception().looked()) {
      return new Result.Refused(RefusalKind.PAD_NOT_SEEN, unseen(choice));
    }
    return search(choice, next);
  }

  /** Hovers until the pad is in sight or the search times out. */
  private Result search(PadChoice choice, Function<PadSighting, Result> next) {
    PadSearch search =
        new PadSearch(flight.basePosition(), flight.baseHeading(), () -> find(choice).isPresent());
    return new Result.Running(
        flight
            .fly(search)
            .then(
                () ->
                    find(choice)
                        .map(next)
                        .orElseGet(
                            () -> new Result.Refused(RefusalKind.PAD_NOT_SEEN, unseen(choice)))));
  }

  private Maneuver over(PadSighting pad, Vec3 goal, double speed) {
    return watching(pad, planner.to(goal, speed), goal);
  }

  /**
   * Returns a maneuver that fails when the pad is out of sight for too long or the goal is
   * unreachable.
   */
  private Maneuver watching(PadSighting pad, Maneuver maneuver, Vec3 goal) {
    return planner.reaches(goal)
        ? PadWatch.over(maneuver, pad.id(), () -> sees(pad.id()))
        : PadWatch.inVain(maneuver);
  }

  /**
   * Whether the downward camera sees a pad. The drone can determine its position only from such a
   * pad, and not from one far ahead.
   */
  private boolean sees(int id) {
    return model.perception().pads().stream().anyMatch(pad -> pad.id() == id && pad.below());
  }

  private static Vec3 place(PadSighting pad, Vec3 inPadFrame) {
    return pad.pad().position().plus(pad.pad().attitude().toRoom(inPadFrame));
  }

  /** Returns the selected pad if the downward camera sees it. */
  private Optional<PadSighting> find(PadChoice choice) {
    var below = model.perception().pads().stream().filter(PadSighting::below);
    return switch (choice.id()) {
      case FIRST -> below.min(Comparator.comparing(pad -> pad.moment().since().nanos()));
      case NEAREST -> below.min(Comparator.comparing(pad -> pad.offset().norm()));
      default -> below.filter(pad -> pad.id() == choice.id()).findFirst();
    };
  }

  /** Returns the reason why the downward camera does not detect pads; empty if it does. */
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

  /** Hovers until a mission pad is in sight or the search times out. */
  private static final class PadSearch implements Maneuver {

    /** Timeout of the search [s]. Assumed: enough for several detections. */
    private static final double PATIENCE = 1;

    private final Setpoint.Track place;
    private final BooleanSupplier seen;
    private double time;
    private boolean found;

    /**
     * Creates a search.
     *
     * @param position the position to hold, in the room frame [m]
     * @param heading the direction of the nose [rad]
     * @param seen whether the pad is in sight now
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
   * A maneuver relative to a mission pad. It fails when the pad is out of sight for too long, or
   * when the goal is unreachable.
   */
  private static final class PadWatch implements Maneuver {

    /**
     * Maximum time for which the pad may be out of sight [s]. Measured: 15.2 s (Tello-Python issue
     * 88).
     */
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
     * Returns a maneuver that fails when a pad is out of sight for too long.
     *
     * @param pad the pad's number
     * @param seen whether the downward camera sees the pad now
     */
    static PadWatch over(Maneuver maneuver, int pad, BooleanSupplier seen) {
      Phrase reason = Phrase.of("it has not seen the pad m%d for %.1f s", pad, PATIENCE);
      return new PadWatch(maneuver, seen, true, reason);
    }

    /**
     * Returns a maneuver for a goal below the lowest hover height. The drone flies down as far as
     * it can, and waits there until the maneuver fails.
     */
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
