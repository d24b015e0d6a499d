package tellosimulator.goal;

import java.util.OptionalInt;
import tellosimulator.words.Phrase;
import tellosimulator.world.MissionPad;

/** Something that a drone shall do. Immutable; for any thread. */
public sealed interface Goal {

  /** Shortest time that a drone can be asked to hover [s]. Decided: what anybody calls staying. */
  double SHORTEST_HOVER = 0.1;

  /** Longest time that a drone can be asked to hover [s]. Decided: longer than a battery lasts. */
  double LONGEST_HOVER = 3600;

  /** The number of the drone that shall do it; empty if any may. */
  OptionalInt drone();

  /** What to do, for people: {@code land on mission pad 3}. */
  Phrase task();

  /** The same, and who shall do it. */
  default Phrase phrase() {
    return said(task());
  }

  /** A task in other words, and who shall do it. */
  default Phrase said(Phrase task) {
    return drone().isPresent() ? Phrase.of("drone %d: %s", drone().getAsInt(), task) : task;
  }

  /** How long the drone must do it without a break [s]. */
  default double lasting() {
    return 0;
  }

  /** The same for another drone. */
  Goal forDrone(OptionalInt newDrone);

  /** A goal that has a place of its own. */
  sealed interface InRegion extends Goal {

    /** Where the drone shall be. */
    GoalRegion region();

    /** The same elsewhere. */
    InRegion at(GoalRegion newRegion);
  }

  /** To be at a place with its feet. */
  record Reach(OptionalInt drone, GoalRegion region) implements InRegion {
    @Override
    public Reach forDrone(OptionalInt newDrone) {
      return new Reach(newDrone, region);
    }

    @Override
    public Reach at(GoalRegion newRegion) {
      return new Reach(drone, newRegion);
    }

    @Override
    public Phrase task() {
      return Phrase.of(
          "reach x %.0f, y %.0f, z %.0f cm",
          region.place().x() * 100, region.place().y() * 100, region.place().z() * 100);
    }
  }

  /**
   * To stay at a place with its feet.
   *
   * @param seconds how long without a break
   */
  record Hover(OptionalInt drone, GoalRegion region, double seconds) implements InRegion {
    public Hover {
      if (!(seconds > 0 && seconds <= LONGEST_HOVER)) {
        throw new IllegalArgumentException(
            "seconds is " + seconds + ", but must be above 0 and at most " + LONGEST_HOVER);
      }
    }

    @Override
    public Hover forDrone(OptionalInt newDrone) {
      return new Hover(newDrone, region, seconds);
    }

    @Override
    public Hover at(GoalRegion newRegion) {
      return new Hover(drone, newRegion, seconds);
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
   * To fly through a gate with its centre.
   *
   * @param gate name of the obstacle
   */
  record Pass(OptionalInt drone, String gate, Direction direction) implements Goal {
    @Override
    public Pass forDrone(OptionalInt newDrone) {
      return new Pass(newDrone, gate, direction);
    }

    @Override
    public Phrase task() {
      return Phrase.of("fly through gate %s", gate);
    }
  }

  /** Which way through a gate. */
  enum Direction {
    /** Either way. */
    EITHER,
    /** Along the gate's x axis. */
    ALONG,
    /** Against the gate's x axis. */
    AGAINST
  }

  /** To land at a place: afterwards it stands there without motors. */
  record Land(OptionalInt drone, GoalRegion region) implements InRegion {
    @Override
    public Land forDrone(OptionalInt newDrone) {
      return new Land(newDrone, region);
    }

    @Override
    public Land at(GoalRegion newRegion) {
      return new Land(drone, newRegion);
    }

    @Override
    public Phrase task() {
      return Phrase.of(
          "land at x %.0f, y %.0f cm", region.place().x() * 100, region.place().y() * 100);
    }
  }

  /**
   * To land on a mission pad that lies on the floor, with its middle over the card.
   *
   * @param pad 1 to 8
   */
  record LandOn(OptionalInt drone, int pad) implements Goal {
    public LandOn {
      if (pad < 1 || pad > MissionPad.LAST_ID) {
        throw new IllegalArgumentException(
            "pad is " + pad + ", but must be from 1 to " + MissionPad.LAST_ID);
      }
    }

    @Override
    public LandOn forDrone(OptionalInt newDrone) {
      return new LandOn(newDrone, pad);
    }

    @Override
    public Phrase task() {
      return Phrase.of("land on mission pad %d", pad);
    }
  }
}
