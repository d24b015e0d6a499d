package tellosimulator.goal;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import tellosimulator.math.Pose;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;
import tellosimulator.world.Surface;

/** What goals name in an arena, found quickly. Immutable. */
final class Course {

  /** An opening and where the foot of its gate is. */
  record Gate(Shape.Gate opening, Pose pose) {}

  private final Arena arena;
  private final Map<String, Gate> gates = new HashMap<>();
  private final Map<Integer, Pose> cards = new HashMap<>();

  Course(Arena arena) {
    this.arena = arena;
    for (Obstacle obstacle : arena.obstacles()) {
      if (obstacle.shape() instanceof Shape.Gate opening) {
        gates.putIfAbsent(obstacle.name(), new Gate(opening, obstacle.pose()));
      }
    }
    for (MissionPad pad : arena.pads()) {
      if (pad.surface() == Surface.FLOOR) {
        cards.put(pad.id(), pad.pose(arena.room()));
      }
    }
  }

  /** Itself, unless the arena is another one. */
  Course in(Arena present) {
    return present.equals(arena) ? this : new Course(present);
  }

  Optional<Gate> gate(String name) {
    return Optional.ofNullable(gates.get(name));
  }

  /** Where the card of a mission pad lies on the floor. */
  Optional<Pose> card(int pad) {
    return Optional.ofNullable(cards.get(pad));
  }
}
