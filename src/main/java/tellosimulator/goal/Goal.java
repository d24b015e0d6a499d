package tellosimulator.goal;

import java.util.OptionalInt;
import java.util.function.Function;
import tellosimulator.words.Phrase;
import tellosimulator.world.MissionPad;

/** A task for a drone. Immutable. */
public sealed interface Goal {

  /** Minimum duration of a hover goal [s]. Decided: anything shorter is not a hover. */
  double SHORTEST_HOVER = 0.1;

  /** Maximum duration of a hover goal [s]. Decided: longer than a battery lasts. */
  double LONGEST_HOVER = 3600;

  /**
   * Minimum share of the picture's width that a target must take [percent]. Decided: 10 of 960
   * pixels.
   */
  double SMALLEST_SIZE = 1;

  /**
   * Maximum share of the picture's width that a target must take [percent]. Decided: a square that
   * takes 75 percent is as high as the picture, and the drone needs some air to move in.
   */
  double LARGEST_SIZE = 60;

  /** Default share of the picture's width [percent]. Decided: 96 pixels, enough for a detector. */
  double DEFAULT_SIZE = 10;

  /** Returns who must reach the goal, and what it is worth. */
  Terms terms();

  /** Returns the number of the drone that must reach the goal; empty if any drone may. */
  default OptionalInt drone() {
    return terms().drone();
  }

  /** Describes the task, such as {@code land on mission pad 3}. */
  Phrase task();

  /** Describes the task and the drone that must reach the goal. */
  default Phrase phrase() {
    return said(task());
  }

  /**
   * Adds the drone that must reach the goal, if any, to the beginning of a description of the task.
   *
   * @param task the description, which may be more detailed than {@link #task}
   */
  default Phrase said(Phrase task) {
    return drone().isPresent() ? Phrase.of("drone %d: %s", drone().getAsInt(), task) : task;
  }

  /** Returns the time for which the drone must fulfil the task without interruption [s]. */
  default double lasting() {
    return 0;
  }

  /** Returns a copy for another drone. */
  default Goal forDrone(OptionalInt newDrone) {
    return withTerms(terms().forDrone(newDrone));
  }

  /** Returns a copy with other terms. */
  default Goal withTerms(Terms newTerms) {
    return match(
        new Cases<>(
            reach -> new Reach(newTerms, reach.region),
            hover -> new Hover(newTerms, hover.region, hover.seconds),
            pass -> new Pass(newTerms, pass.gate, pass.direction),
            land -> new Land(newTerms, land.region),
            landOn -> new LandOn(newTerms, landOn.pad),
            see -> new See(newTerms, see.target, see.sizePercent, see.seconds)));
  }

  /** Applies the function for this kind of goal to this goal, and returns the result. */
  <T> T match(Cases<T> cases);

  /**
   * A function for each kind of goal. All code that distinguishes between kinds of goals uses this
   * type.
   */
  record Cases<T>(
      Function<Reach, T> reach,
      Function<Hover, T> hover,
      Function<Pass, T> pass,
      Function<Land, T> land,
      Function<LandOn, T> landOn,
      Function<See, T> see) {}

  /** A goal with a fixed region, which does not depend on a gate or a mission pad. */
  sealed interface InRegion extends Goal {

    /** Returns the region in which the drone must be. */
    GoalRegion region();

    /** Returns a copy with another region. */
    InRegion at(GoalRegion newRegion);
  }

  /** The drone's feet must reach a place. */
  record Reach(Terms terms, GoalRegion region) implements InRegion {
    @Override
    public <T> T match(Cases<T> cases) {
      return cases.reach().apply(this);
    }

    @Override
    public Reach at(GoalRegion newRegion) {
      return new Reach(terms, newRegion);
    }

    @Override
    public Phrase task() {
      return Phrase.of(
          "reach x %.0f, y %.0f, z %.0f cm",
          region.place().x() * 100, region.place().y() * 100, region.place().z() * 100);
    }
  }

  /**
   * The drone's feet must stay at a place.
   *
   * @param seconds the time for which the drone must stay without interruption
   */
  record Hover(Terms terms, GoalRegion region, double seconds) implements InRegion {
    public Hover {
      if (!(seconds > 0 && seconds <= LONGEST_HOVER)) {
        throw new IllegalArgumentException(
            "seconds is " + seconds + ", but must be above 0 and at most " + LONGEST_HOVER);
      }
    }

    @Override
    public <T> T match(Cases<T> cases) {
      return cases.hover().apply(this);
    }

    @Override
    public Hover at(GoalRegion newRegion) {
      return new Hover(terms, newRegion, seconds);
    }

    @Override
    public double lasting() {
      return seconds;
    }

    @Override
    public Phrase task() {
      return Phrase.of(
          "stay %.0f s at x %.0f, y %.0f, z %.0f cm",
          seconds, region.place().x() * 100, region.place().y() * 100, region.place().z() * 100);
    }
  }

  /**
   * The drone's centre must pass through a gate.
   *
   * @param gate the name of the gate
   */
  record Pass(Terms terms, String gate, Direction direction) implements Goal {
    @Override
    public <T> T match(Cases<T> cases) {
      return cases.pass().apply(this);
    }

    @Override
    public Phrase task() {
      return Phrase.of("fly through gate %s", gate);
    }
  }

  /** The direction in which a drone must fly through a gate. */
  enum Direction {
    /** Either way. */
    EITHER,
    /** Along the gate's x axis. */
    ALONG,
    /** Against the gate's x axis. */
    AGAINST
  }

  /** The drone must land at a place, and stand there with its motors off. */
  record Land(Terms terms, GoalRegion region) implements InRegion {
    @Override
    public <T> T match(Cases<T> cases) {
      return cases.land().apply(this);
    }

    @Override
    public Land at(GoalRegion newRegion) {
      return new Land(terms, newRegion);
    }

    @Override
    public Phrase task() {
      return Phrase.of(
          "land at x %.0f, y %.0f cm", region.place().x() * 100, region.place().y() * 100);
    }
  }

  /**
   * The drone must land on a mission pad that lies on the floor. The middle of the drone must be
   * over the pad.
   *
   * @param pad the number of the pad, from 1 to 8
   */
  record LandOn(Terms terms, int pad) implements Goal {
    public LandOn {
      if (pad < 1 || pad > MissionPad.LAST_ID) {
        throw new IllegalArgumentException(
            "pad is " + pad + ", but must be from 1 to " + MissionPad.LAST_ID);
      }
    }

    @Override
    public <T> T match(Cases<T> cases) {
      return cases.landOn().apply(this);
    }

    @Override
    public Phrase task() {
      return Phrase.of("land on mission pad %d", pad);
    }
  }

  /** A flat object that a drone can see. It hangs on a side of the room, or lies on the floor. */
  sealed interface Target {

    /** Names the target, such as {@code mission pad 3}. */
    Phrase phrase();
  }

  /** The poster of a name. */
  record NamedPoster(String name) implements Target {
    @Override
    public Phrase phrase() {
      return Phrase.of("poster %s", name);
    }
  }

  /** The mission pad of a number, on the floor or on a wall. */
  record NumberedPad(int pad) implements Target {
    @Override
    public Phrase phrase() {
      return Phrase.of("mission pad %d", pad);
    }
  }

  /**
   * A flying drone must have a target in the picture of its forward camera: all of it, large
   * enough, and hidden by no obstacle.
   *
   * @param sizePercent the share of the picture's width that the target must take [percent]
   * @param seconds the time for which the drone must see it without interruption
   */
  record See(Terms terms, Target target, double sizePercent, double seconds) implements Goal {
    public See {
      if (!(sizePercent >= SMALLEST_SIZE && sizePercent <= LARGEST_SIZE)) {
        throw new IllegalArgumentException(
            "sizePercent is "
                + sizePercent
                + ", but must be from "
                + SMALLEST_SIZE
                + " to "
                + LARGEST_SIZE);
      }
      if (!(seconds > 0 && seconds <= LONGEST_HOVER)) {
        throw new IllegalArgumentException(
            "seconds is " + seconds + ", but must be above 0 and at most " + LONGEST_HOVER);
      }
    }

    /** Creates a goal with the default size and time. */
    public See(Terms terms, Target target) {
      this(terms, target, DEFAULT_SIZE, 1);
    }

    /** Returns a copy with another target. */
    public See of(Target newTarget) {
      return new See(terms, newTarget, sizePercent, seconds);
    }

    @Override
    public <T> T match(Cases<T> cases) {
      return cases.see().apply(this);
    }

    @Override
    public double lasting() {
      return seconds;
    }

    @Override
    public Phrase task() {
      return Phrase.of(
          "see %s for %.1f s, at least %.0f%% of the picture's width",
          target.phrase(), seconds, sizePercent);
    }
  }
}
