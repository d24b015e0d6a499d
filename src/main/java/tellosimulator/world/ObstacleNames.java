package tellosimulator.world;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** Names for obstacles that nobody gave one: {@code box 1}. Not thread-safe. */
public final class ObstacleNames {

  private final Set<String> taken = new HashSet<>();
  private final Map<String, Integer> numbers = new HashMap<>();

  /** A name that an obstacle has already. */
  public void take(String name) {
    taken.add(name);
  }

  /**
   * A name that no other has.
   *
   * @param kind its first word
   */
  public String next(String kind) {
    String name;
    do {
      name = kind + " " + numbers.merge(kind, 1, Integer::sum);
    } while (!taken.add(name));
    return name;
  }
}
