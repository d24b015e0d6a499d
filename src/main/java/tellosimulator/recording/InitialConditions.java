package tellosimulator.recording;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import tellosimulator.goal.Challenge;
import tellosimulator.json.JsonRecords;
import tellosimulator.sim.SimConfig;

/**
 * The initial conditions of a simulation. Together with the inputs, they determine everything that
 * follows. Immutable.
 *
 * @param config the configuration of the simulation
 * @param challenge the goals of the drones
 * @param replyPort port to which all replies go; if empty, each reply goes to the port that its
 *     command came from
 */
public record InitialConditions(SimConfig config, Challenge challenge, OptionalInt replyPort) {

  private static final String TERMS = "terms";
  private static final String DRONE = "drone";
  private static final String POINTS = "points";

  /**
   * Converts these conditions to a JSON value. The terms of a goal are members of the goal itself,
   * as in scenario files and in recordings of earlier versions, which know no points.
   */
  @SuppressWarnings("unchecked") // the names of members are texts
  Object json() {
    Object json = JsonRecords.write(InitialConditions.class, this);
    for (Map<String, Object> goal : goals(json)) {
      Map<String, Object> members = new LinkedHashMap<>(goal);
      goal.clear();
      members.forEach(
          (name, value) -> {
            if (name.equals(TERMS)) {
              goal.putAll((Map<String, Object>) value);
              goal.remove(POINTS, 0.0);
            } else {
              goal.put(name, value);
            }
          });
    }
    return json;
  }

  /**
   * Converts a JSON value of {@link #json} to initial conditions.
   *
   * @throws IllegalArgumentException if the value does not describe any; the message is one
   *     sentence
   */
  static InitialConditions of(Object json) {
    for (Map<String, Object> goal : goals(json)) {
      Map<String, Object> terms = new LinkedHashMap<>();
      terms.put(DRONE, goal.get(DRONE));
      terms.put(POINTS, goal.getOrDefault(POINTS, 0.0));
      goal.put(TERMS, terms);
    }
    return JsonRecords.read(InitialConditions.class, json);
  }

  /** Returns the goals in a JSON value; empty if it has no list of goals. */
  @SuppressWarnings("unchecked") // the names of members are texts
  private static List<Map<String, Object>> goals(Object json) {
    return json instanceof Map<?, ?> conditions
            && conditions.get("challenge") instanceof Map<?, ?> challenge
            && challenge.get("goals") instanceof List<?> goals
        ? goals.stream()
            .filter(Map.class::isInstance)
            .map(goal -> (Map<String, Object>) goal)
            .toList()
        : List.of();
  }

  /** Returns a copy of these conditions with another challenge. */
  InitialConditions withChallenge(Challenge newChallenge) {
    return new InitialConditions(config, newChallenge, replyPort);
  }
}
