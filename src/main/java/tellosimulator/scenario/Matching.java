package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.IntStream;
import tellosimulator.fault.Fault;
import tellosimulator.sim.DroneSetup;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;

/** Which items of the lists of a scenario are those of another one. */
final class Matching {

  /** What no item is. */
  static final int NEW = -1;

  private final Map<String, List<Integer>> byKey;

  private Matching(Map<String, List<Integer>> byKey) {
    this.byKey = byKey;
  }

  static Matching of(Scenario before, Scenario now) {
    Arena old = before.config().arena();
    Arena arena = now.config().arena();
    return new Matching(
        Map.of(
            "obstacles", matched(old.obstacles(), arena.obstacles(), Obstacle::name),
            "pads", matched(old.pads(), arena.pads(), MissionPad::id),
            "posters", inOrder(old.decor().posters(), arena.decor().posters()),
            "drones", inOrder(drones(before), drones(now)),
            "faults", inOrder(faults(before), faults(now)),
            "goals", inOrder(before.challenge().goals(), now.challenge().goals())));
  }

  /**
   * For each item of a list, the index of the one before, or {@link #NEW}. One that changed places
   * with others counts as new.
   *
   * @param key of the list in a file
   */
  List<Integer> of(String key) {
    return byKey.get(key);
  }

  private static List<Fault> faults(Scenario scenario) {
    return scenario.config().rules().faults().faults();
  }

  private static <T> List<Integer> matched(List<T> before, List<T> now, Function<T, ?> identity) {
    Map<Object, Integer> indices = new HashMap<>();
    for (int i = 0; i < before.size(); i++) {
      indices.put(identity.apply(before.get(i)), i);
    }
    List<Integer> matches = new ArrayList<>();
    int last = NEW;
    for (T item : now) {
      int match = indices.getOrDefault(identity.apply(item), NEW);
      matches.add(match > last ? match : NEW);
      last = Math.max(last, match);
    }
    return matches;
  }

  /** All that a file says of each drone. */
  private static List<List<?>> drones(Scenario scenario) {
    List<DroneSetup> setups = scenario.config().drones();
    return IntStream.range(0, setups.size())
        .<List<?>>mapToObj(i -> List.of(setups.get(i), scenario.stations().get(i)))
        .toList();
  }

  /**
   * Items that have no name: equal ones at both ends belong together, and those between in turn.
   */
  private static List<Integer> inOrder(List<?> before, List<?> now) {
    int most = Math.min(before.size(), now.size());
    int first = 0;
    while (first < most && before.get(first).equals(now.get(first))) {
      first++;
    }
    int last = 0;
    while (last < most - first
        && before.get(before.size() - 1 - last).equals(now.get(now.size() - 1 - last))) {
      last++;
    }
    List<Integer> matches = new ArrayList<>();
    for (int i = 0; i < now.size(); i++) {
      boolean atEnd = i >= now.size() - last;
      int match = atEnd ? i - now.size() + before.size() : i;
      matches.add(atEnd || i < before.size() - last ? match : NEW);
    }
    return matches;
  }
}
