package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import tellosimulator.goal.Goal;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.view.plan.Piece.Pad;
import tellosimulator.view.plan.Piece.Start;
import tellosimulator.view.plan.Piece.Thing;
import tellosimulator.world.Arena;
import tellosimulator.world.Footprint;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Obstacles;

/** Why a piece cannot be where it would be, or cannot be taken away. */
enum Fit {
  /** Something of it would be outside of the walls. */
  OUTSIDE,
  /** It would reach above the ceiling. */
  TOO_HIGH,
  /** An obstacle would stand where a drone starts. */
  ON_START,
  /** A drone would start in an obstacle. */
  IN_OBSTACLE,
  /** Two drones would start in the same place. */
  ON_DRONE,
  /** It would be gone, and a goal names it. */
  NAMED_BY_GOAL;

  /** What may be missing to a gap [m]: the last bits of a calculation. */
  private static final double SLACK = 1e-6;

  /** What keeps a piece from where it is; empty if nothing does. */
  static Optional<Fit> problem(Layout layout, Piece piece) {
    if (piece instanceof Thing thing) {
      return problem(layout, layout.obstacle(thing));
    } else if (piece instanceof Start start) {
      return problem(layout, start);
    }
    return Footprint.inside(layout.pad((Pad) piece), layout.arena().room())
        ? Optional.empty()
        : Optional.of(OUTSIDE);
  }

  /** What keeps a piece from being taken away; empty if nothing does. */
  static Optional<Fit> problemWithout(Layout layout, Piece piece, List<Goal> goals) {
    Layout without = layout.without(piece);
    return goals.stream().anyMatch(goal -> layout.offers(goal) && !without.offers(goal))
        ? Optional.of(NAMED_BY_GOAL)
        : Optional.empty();
  }

  private static Optional<Fit> problem(Layout layout, Obstacle obstacle) {
    Arena arena = layout.arena();
    if (!Footprint.betweenWalls(obstacle, arena.room())) {
      return Optional.of(OUTSIDE);
    }
    if (!Footprint.underCeiling(obstacle, arena.room())) {
      return Optional.of(TOO_HIGH);
    }
    Obstacles alone = Obstacles.of(arena.withObstacles(List.of(obstacle)));
    return layout.starts().stream()
            .anyMatch(start -> alone.around(start.position(), DroneSpec.HULL).isPresent())
        ? Optional.of(ON_START)
        : Optional.empty();
  }

  private static Optional<Fit> problem(Layout layout, Start start) {
    Vec3 place = layout.spot(start).place();
    if (!layout.arena().room().contains(place, DroneSpec.HULL)) {
      return Optional.of(OUTSIDE);
    }
    if (Obstacles.of(layout.arena()).around(place, DroneSpec.HULL).isPresent()) {
      return Optional.of(IN_OBSTACLE);
    }
    for (int drone = 1; drone <= layout.starts().size(); drone++) {
      Vec3 other = layout.starts().get(drone - 1).position();
      if (drone != start.drone() && place.distanceTo(other) < 2 * DroneSpec.HULL.radius() - SLACK) {
        return Optional.of(ON_DRONE);
      }
    }
    return Optional.empty();
  }
}
