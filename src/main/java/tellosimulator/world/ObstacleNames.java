package tellosimulator.world;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** Generates names for unnamed obstacles, such as {@code box 1}. Not thread-safe. */
public final class ObstacleNames {

  private final Set<String> taken = new HashSet<>();
  private final Map<String, Integer> numbers = new HashMap<>();

  /** Registers the name of an existing obstacle. */
  public void take(String name) {
    taken.add(name);
  }

  /**
   * Returns an unused name.
   *
   * @param kind the first word of the name
   */
  public String next(String kind) {
    String name;
    do {
      name = kind + " " + numbers.merge(kind, 1, Integer::sum);
    } while (!taken.add(name));
    return name;
  }
}
